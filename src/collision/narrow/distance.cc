#include <sudar/distance.h>

#include "collision/narrow/separation.h"

namespace sudar::inline SUDAR_PRECISION {
namespace {

Vec3d between(const Pos& from, const Pos& to) { return {to.x - from.x, to.y - from.y, to.z - from.z}; }

void check(const char* name, const Shape& shape, const Pos& p, const Quat& q) {
  if (!shape) throw Error(name, "has no shape");
  if (is_hollow(shape.kind())) throw Error(name, "is a hollow, to which there is no distance");
  if (shape.kind() == ShapeKind::mesh) throw Error(name, "is a mesh, to which there is no distance yet");
  if (!is_finite(p) || !is_finite(q) || !(length_squared(q) > 0)) throw Error(name, "has a pose that is not one");
}

// The shape is convex, the other geometry too or a half space; everything about at_a.p.
SignedDistance to_convex(const Shape& a, const Pose& at_a, const Geometry& b, const Pose& at_b) {
  const Convex convex(a.geometry(), at_a.q, {});
  const Vec3d way = between(at_a.p, at_b.p);
  if (b.kind == ShapeKind::half_space) {
    const Vec3d n = rotate(normalize(convert<double>(at_b.q)), Vec3d{0, 1, 0});
    const Vec3d lowest = convex.support(-n) - n * convex.round;
    const double value = dot(n, lowest - way);
    return {value, convert<Real>(n), at_a.p + lowest, at_a.p + (lowest - n * value)};
  }
  const Separation s = separation(convex, {b, at_b.q, way}, std::numeric_limits<double>::infinity());
  return {s.distance, convert<Real>(s.normal), at_a.p + s.on_a, at_a.p + s.on_b};
}

}

SignedDistance distance(const Shape& a, const Pose& at_a, const Shape& b, const Pose& at_b) {
  check("a", a, at_a.p, at_a.q);
  check("b", b, at_b.p, at_b.q);
  if (a.kind() != ShapeKind::half_space) return to_convex(a, at_a, b.geometry(), at_b);
  if (b.kind() == ShapeKind::half_space) throw Error("b", "is a half space like a");
  const SignedDistance d = to_convex(b, at_b, a.geometry(), at_a);
  return {d.value, -d.normal, d.on_b, d.on_a};
}

SignedDistance distance(const Shape& a, const Pose& at_a, const Pos& point) {
  check("a", a, at_a.p, at_a.q);
  if (!is_finite(point)) throw Error("point", "is not finite");
  const Geometry nothing;  // a sphere of radius 0
  if (a.kind() != ShapeKind::half_space) return to_convex(a, at_a, nothing, {point, {}});
  const Vec3d n = rotate(normalize(convert<double>(at_a.q)), Vec3d{0, 1, 0});
  const double value = dot(n, between(at_a.p, point));
  return {value, convert<Real>(-n), point - n * value, point};
}

}
