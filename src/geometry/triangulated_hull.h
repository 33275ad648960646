// The convex hull as triangles: quickhull (Barber, Dobkin, Huhdanpaa 1996) with exact orientation tests. The tests
// never contradict each other, so there is nothing to repair: duplicates, grids and points on one sphere are ordinary
// input. Points in the interior of a facet or an edge may or may not be corners, and coplanar triangles are not merged:
// that is for hull.h, which knows how much rounding to forgive.
#pragma once

#include <sudar/math.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace sudar::inline SUDAR_PRECISION {

struct HullTriangle {
  std::array<std::uint32_t, 3> corners;    // counter-clockwise from outside
  std::array<std::uint32_t, 3> neighbors;  // the triangle across the edge corners[i] → corners[i + 1]
};

// `simplex`: four of the points that do not lie in one plane.
std::vector<HullTriangle> triangulated_hull(std::span<const Vec3d> points, std::array<std::uint32_t, 4> simplex);

}
