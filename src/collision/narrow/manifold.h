// How two shapes touch.
#pragma once

#include <sudar/math.h>

#include <array>
#include <cstdint>

namespace sudar::inline SUDAR_PRECISION {

struct ManifoldPoint {
  Vec3 at;                    // in the common frame; half-way between the surfaces for two hulls, on the round body's surface else
  Real separation = 0;        // along the normal; negative: overlap
  std::uint32_t feature = 0;  // the same number for the same corner in the next step
};

struct Manifold {
  Vec3 normal;                // from b to a
  std::array<ManifoldPoint, 4> points;
  int count = 0;              // 0: no point nearer than the margin
};

// The separating axis found last: tried first next time. A hint only in time, never in result... see sat.h.
struct AxisCache {
  std::uint32_t kind = 0, a = 0, b = 0;
};

}
