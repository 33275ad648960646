#include "collision/narrow/plane.h"

#include "collision/narrow/reduce.h"
#include "collision/narrow/small_array.h"

namespace sudar::inline SUDAR_PRECISION {

void collide_round_plane(const Round& a, const HalfSpace& plane, Real margin, Manifold& out) {
  out.normal = plane.normal;
  out.count = 0;
  const int ends = length_squared(a.axis.along) > 0 ? 2 : 1;
  for (int i = 0; i < ends; ++i) {
    const Vec3 p = a.axis.at(Real(i));
    const Real s = dot(plane.normal, p) - plane.offset - a.radius;
    if (s < margin) out.points[std::size_t(out.count++)] = {p - plane.normal * a.radius, s, std::uint32_t(i)};
  }
}

void collide_hull_plane(const Polyhedron& hull, const HalfSpace& plane, Real radius, Reach reach, Manifold& out) {
  out.normal = plane.normal;
  SmallArray<ManifoldPoint, 64> points(hull.vertices.size());
  for (std::uint32_t i = 0; i < hull.vertices.size(); ++i) {
    const Vec3& v = hull.vertices[i];
    const Real s = dot(plane.normal, v) - plane.offset;
    if (s < reach.margin) points.push({v - plane.normal * (s * Real(0.5)), s, i});
  }
  reduce(points.all(), plane.normal, reach.turn, radius, out);
}

}
