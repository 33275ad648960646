// How two shapes touch. Plain data without padding: manifolds are saved and hashed as bytes.
#pragma once

#include <sudar/definitions.h>

#include <array>
#include <cstdint>

namespace sudar::inline SUDAR_PRECISION {

// What a contact is to hold until the pair is looked at again.
struct Reach {
  Reach(Real m, Real t = 0) : margin(m), turn(t) {}
  Real margin;  // points nearer than this count, m
  Real turn;    // how far the two may turn against each other until then, rad; 0: hardly
};

struct ManifoldPoint {
  Vec3 at;                    // in the common frame; half-way between the surfaces where both shapes are flat or both
                              // are round, else on the round shape's surface
  Real separation = 0;        // along the normal; negative: overlap
  std::uint32_t feature = 0;  // the same number for the same corner in the next step
  std::int32_t match = -1;    // the point of the same feature in the manifold before, or -1; written by pairs.h
};

struct Manifold {
  enum Bits : std::uint32_t { touching = 1, began = 2, ended = 4, kept = 8 };

  Vec3 normal;  // from b to a
  std::array<ManifoldPoint, 4> points;
  std::int32_t count = 0;  // 0: no point nearer than the margin
  std::uint32_t bits = 0;  // has points; has them since the last collision; lost them then; is the one of the step before, moved on. Written by pairs.h
};
template <class V, Like<ManifoldPoint> T>
void describe(V& v, T& d) {
  v("at", d.at, any), v("separation", d.separation, any), v("feature", d.feature, any), v("match", d.match, any);
}
template <class V, Like<Manifold> T>
void describe(V& v, T& d) {
  v("normal", d.normal, any), v("points", d.points, any), v("count", d.count, any), v("bits", d.bits, any);
}
static_assert(sizeof(Manifold) == 19 * sizeof(Real) + 40, "no padding");

// The axis that decided last time, tried first next time. It changes only the time that a collision takes, never its
// result (sat.h says why), so it may be dropped at any moment.
struct AxisCache {
  std::uint32_t kind = 0, a = 0, b = 0;
};
template <class V, Like<AxisCache> T>
void describe(V& v, T& d) { v("kind", d.kind, any), v("a", d.a, any), v("b", d.b, any); }

}
