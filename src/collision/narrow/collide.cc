#include "collision/narrow/collide.h"

#include "collision/narrow/clip.h"
#include "collision/narrow/curved.h"
#include "collision/narrow/plane.h"
#include "collision/narrow/round.h"
#include "collision/narrow/sat.h"

#include <cassert>

namespace sudar::inline SUDAR_PRECISION {
namespace {

Round round_at(const Geometry& g, const Vec3& p, const Vec3& along) { return {{p - along, along * Real(2)}, g.radius}; }

Round round_in_common(const Placed& a) {
  const Geometry& g = *a.geometry;
  return round_at(g, a.pose.p, rotate(a.pose.q, {0, g.half_length, 0}));
}

// From the frame of `local` to the common one.
void to_common(const Transform& local, Manifold& m) {
  m.normal = rotate(local.q, m.normal);
  for (int i = 0; i < m.count; ++i) {
    Vec3& at = m.points[std::size_t(i)].at;
    at = local.point(at);
  }
}

// Returns how far they are apart at least.
Real collide_hulls(const Placed& a, const Placed& b, Reach reach, AxisCache& cache, Manifold& out) {
  const Quat back = conjugate(a.pose.q);
  const HullView in_a(a.geometry->hull);
  const MovedHull of_b(b.geometry->hull, matrix(back * b.pose.q), rotate(back, b.pose.p - a.pose.p));
  const Axis axis = find_axis(in_a, of_b, reach.margin, cache);
  if (axis.kind == Axis::none) return axis.separation;
  contact_region(in_a, of_b, axis, reach, out);
  to_common(a.pose, out);
  return axis.separation;
}

void collide_round_hull(const Placed& a, const Placed& b, Real margin, Manifold& out) {
  const Vec3 p = b.pose.local(a.pose.p);
  const Geometry& g = *a.geometry;
  if (g.kind == ShapeKind::sphere) {
    collide_sphere_hull(p, g.radius, b.geometry->hull, margin, out);
  } else {
    const Vec3 half = rotate(conjugate(b.pose.q) * a.pose.q, {0, g.half_length, 0});
    collide_capsule_hull(round_at(g, p, half), b.geometry->hull, margin, out);
  }
  to_common(b.pose, out);
}

// In a's position and axes if it is a hull, in its position and common axes if it is round: the offset of the plane is
// then all that a far origin could spoil, and pairs.h hands over poses near it.
void collide_plane(const Placed& a, const Placed& plane, Reach reach, Manifold& out) {
  const Vec3 n = rotate(plane.pose.q, {0, 1, 0});
  if (a.geometry->kind == ShapeKind::hull) {
    const Real offset = dot(n, plane.pose.p - a.pose.p);
    collide_hull_plane(a.geometry->hull, {rotate_back(a.pose.q, n), offset}, a.geometry->bounding_radius, reach, out);
    to_common(a.pose, out);
    out.normal = n;
  } else {
    collide_round_plane(round_in_common(a), {n, dot(n, plane.pose.p)}, reach.margin, out);
  }
}

// b's kind is after that of hulls.
void collide_beyond_hulls(const Placed& a, const Placed& b, Reach reach, Manifold& out) {
  const ShapeKind ka = a.geometry->kind;
  if (is_hollow(b.geometry->kind)) {
    if (ka == ShapeKind::sphere) collide_sphere_hollow(a, b, reach.margin, out);
  } else if (ka == ShapeKind::half_space) {
    collide_curved_plane(b, a, reach, out);
    out.normal = -out.normal;
  } else {
    collide_curved(a, b, reach, out);
  }
}

// a's kind is not after b's.
// Returns how far they are apart at least, if that is known.
Real collide_ordered(const Placed& a, const Placed& b, Reach reach, AxisCache& cache, Manifold& out) {
  const ShapeKind ka = a.geometry->kind, kb = b.geometry->kind;
  assert(!(ka == ShapeKind::half_space && kb == ShapeKind::half_space));
  if (kb > ShapeKind::hull) {
    collide_beyond_hulls(a, b, reach, out);
  } else if (ka == ShapeKind::half_space) {
    collide_plane(b, a, reach, out);
    out.normal = -out.normal;
  } else if (kb == ShapeKind::half_space) {
    collide_plane(a, b, reach, out);
  } else if (ka == ShapeKind::hull) {
    return collide_hulls(a, b, reach, cache, out);
  } else if (kb == ShapeKind::hull) {
    collide_round_hull(a, b, reach.margin, out);
  } else {
    collide_rounds(round_in_common(a), round_in_common(b), reach.margin, out);
  }
  return 0;
}

// The distance between bounding spheres.
Real spheres_apart(const Placed& a, const Placed& b) {
  const Real reach = a.geometry->bounding_radius + b.geometry->bounding_radius;  // infinite for a half space
  return length(a.pose.p - b.pose.p) - reach;
}

}

Real collide(const Placed& a, const Placed& b, Reach reach, AxisCache& cache, Manifold& out) {
  out = {};
  const Real least = spheres_apart(a, b);  // thesis (3.28): bounding spheres first
  if (least > reach.margin) return least;
  Real apart;
  if (a.geometry->kind <= b.geometry->kind) {
    apart = collide_ordered(a, b, reach, cache, out);
  } else {
    apart = collide_ordered(b, a, reach, cache, out);
    out.normal = -out.normal;
  }
  return out.count == 0 ? max(Real(0), apart) : Real(0);
}

}
