#include "collision/narrow/collide.h"

namespace sudar::inline SUDAR_PRECISION {
namespace {

// Where a ray enters a ball. The nearest point of the line is found first, so that a far origin costs no digits.
bool ball(const Vec3& center, Real radius, const Vec3& from, const Vec3& direction, Real& distance) {
  const Real nearest = dot(center - from, direction);
  const Real half_chord = square(radius) - length_squared(from + direction * nearest - center);
  if (half_chord < 0) return false;
  distance = nearest - sqrt(half_chord);
  return distance >= 0;
}

bool capsule(const Geometry& g, const Vec3& from, const Vec3& direction, RayOnGeometry& out) {
  bool hit = false;
  const auto take = [&](Real distance, const Vec3& on_axis) {
    if (hit && distance >= out.distance) return;
    hit = true;
    out = {distance, normalize(from + direction * distance - on_axis)};
  };
  for (const Real end : {-g.half_length, g.half_length}) {
    Real distance;
    if (ball({0, end, 0}, g.radius, from, direction, distance)) take(distance, {0, end, 0});
  }
  // The cylinder: the same as a ball in the plane across it.
  const Vec3 flat{direction.x, 0, direction.z};
  const Real across = length(flat);
  Real distance;
  if (across > 0 && ball({}, g.radius, {from.x, 0, from.z}, flat / across, distance)) {
    const Real y = from.y + direction.y * (distance / across);
    if (abs(y) <= g.half_length) take(distance / across, {0, y, 0});
  }
  return hit;
}

bool inside_capsule(const Geometry& g, const Vec3& p) {
  const Vec3 on_axis{0, clamp(p.y, -g.half_length, g.half_length), 0};
  return length_squared(p - on_axis) < square(g.radius);
}

// Cut by one face plane after the other.
bool polyhedron(const Polyhedron& hull, const Vec3& from, const Vec3& direction, Real length, RayOnGeometry& out) {
  Real enter = -1, leave = length;
  for (const Polyhedron::Face& f : hull.faces) {
    const Real above = dot(f.normal, from) - f.offset, speed = dot(f.normal, direction);
    if (speed >= 0 && above > 0) return false;
    if (speed < 0 && above >= 0 && -above / speed > enter) enter = -above / speed, out = {enter, f.normal};
    if (speed > 0) leave = min(leave, -above / speed);
    if (enter > leave) return false;
  }
  return enter >= 0;
}

}

bool ray_cast(const Geometry& g, const Vec3& from, const Vec3& direction, Real length, RayOnGeometry& out) {
  switch (g.kind) {
    case ShapeKind::sphere:
      if (!ball({}, g.radius, from, direction, out.distance)) return false;
      out.normal = normalize(from + direction * out.distance);
      return out.distance <= length;
    case ShapeKind::capsule:
      return !inside_capsule(g, from) && capsule(g, from, direction, out) && out.distance <= length;
    case ShapeKind::half_space:
      if (from.y < 0 || direction.y >= 0) return false;
      out = {-from.y / direction.y, {0, 1, 0}};
      return out.distance <= length;
    case ShapeKind::hull:
      return polyhedron(g.hull, from, direction, length, out);
  }
  return false;
}

}
