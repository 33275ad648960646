#include "geometry/convex.h"

namespace sudar::inline SUDAR_PRECISION {
namespace {

// A point of the circle about y, or its centre where the direction is that of the axis.
Vec3d rim(double radius, double y, const Vec3d& d) {
  const double across = sqrt(d.x * d.x + d.z * d.z);
  if (!(across > 0)) return {0, y, 0};
  return {radius * (d.x / across), y, radius * (d.z / across)};
}

Vec3d farthest(const Polyhedron& hull, const Vec3d& d) {
  const Vec3* best = &hull.vertices[0];
  double best_value = -std::numeric_limits<double>::infinity();
  for (const Vec3& v : hull.vertices) {
    const double value = dot(convert<double>(v), d);
    if (value > best_value) best_value = value, best = &v;
  }
  return convert<double>(*best);
}

Vec3d farthest(const Geometry& g, const Vec3d& d) {
  const double r = double(g.radius), half = double(g.half_length);
  switch (g.kind) {
    case ShapeKind::capsule:
      return {0, d.y > 0 ? half : -half, 0};
    case ShapeKind::hull:
      return farthest(g.hull, d);
    case ShapeKind::cylinder:
      return rim(r, d.y > 0 ? half : -half, d);
    case ShapeKind::cone: {
      const Vec3d apex{0, 1.5 * half, 0}, base = rim(r, -0.5 * half, d);
      return dot(apex, d) > dot(base, d) ? apex : base;
    }
    case ShapeKind::ellipsoid: {
      const Vec3d radii = convert<double>(g.radii), scaled = scale(radii, d);
      return scale(radii, normalize(scaled));
    }
    default:
      return {};
  }
}

}

Convex::Convex(const Geometry& g, const Mat3d& m, const Vec3d& origin)
    : geometry(&g),
      turn(m),
      at(origin),
      round(g.kind == ShapeKind::sphere || g.kind == ShapeKind::capsule ? double(g.radius) : 0) {}
Convex::Convex(const Geometry& g, const Quat& q, const Vec3d& origin)
    : Convex(g, matrix(normalize(convert<double>(q))), origin) {}

Vec3d Convex::support(const Vec3d& direction) const {
  const Vec3d local{dot(turn.c0, direction), dot(turn.c1, direction), dot(turn.c2, direction)};
  return point(farthest(*geometry, local));
}

Vec3d Convex::center() const {
  return geometry->kind == ShapeKind::hull ? point(convert<double>(geometry->hull.interior)) : at;
}

}
