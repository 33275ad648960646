#include "collision/narrow/mesh.h"

namespace sudar::inline SUDAR_PRECISION {
namespace {

// The shortest turn that takes y to the unit vector n.
Quat turn_y_to(const Vec3& n) {
  if (n.y < Real(-0.9999)) return Quat{1, 0, 0, 0};
  return normalize(Quat{n.z, 0, -n.x, 1 + n.y});
}

// The points in which the body meets the triangle's plane, as far as they are over the triangle.
void meet_plane(const TriangleMesh::Triangle& t, const Placed& mesh, const Placed& b, Reach reach, Manifold& out) {
  Geometry plane;
  plane.kind = ShapeKind::half_space;
  plane.bounding_radius = std::numeric_limits<Real>::infinity();
  AxisCache none;
  Manifold all;
  const Vec3 normal = rotate(mesh.pose.q, t.normal);
  collide({&plane, {mesh.pose.point(t.corners[0]), turn_y_to(normal)}}, b, reach, none, all);
  out = {};
  for (int k = 0; k < all.count; ++k) {
    const ManifoldPoint& point = all.points[std::size_t(k)];
    if (!t.above(mesh.pose.local(point.at), Real(1e-4) * t.size())) continue;
    out.points[std::size_t(out.count++)] = point;
  }
  if (out.count > 0) out.normal = -normal;
}

}

Real collide_triangle(const Placed& mesh, std::uint32_t triangle, const Placed& b, Reach reach, AxisCache& cache,
                      Manifold& out) {
  out = {};
  const TriangleMesh::Triangle& t = mesh.geometry->mesh->triangles[triangle];
  const Vec3 normal = rotate(mesh.pose.q, t.normal), corner = mesh.pose.point(t.corners[0]);
  const Real apart = dot(normal, b.pose.p - corner) - b.geometry->bounding_radius;
  if (apart > reach.margin) return apart;
  if (dot(normal, b.pose.point(convert<Real>(b.geometry->mass.center)) - corner) < 0) return 0;
  const Real gap = collide({t.piece.get(), mesh.pose}, b, reach, cache, out);
  if (out.count == 0) return gap;
  const Vec3 leans = rotate_back(mesh.pose.q, -out.normal);
  constexpr Real as_good = Real(1e-3);  // but for rounding
  if (length(leans - t.normal) < as_good) {
    out.normal = -normal;
  } else if (!t.allows(leans)) {
    meet_plane(t, mesh, b, reach, out);
  }
  return 0;
}

}
