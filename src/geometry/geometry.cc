#include "geometry/geometry.h"

#include "base/hash.h"

namespace sudar::inline SUDAR_PRECISION {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

void check_size(const char* field, Real size) {
  if (!std::isfinite(size) || !(size > 0)) throw Error(field, "must be a positive number");
}

MassProperties sphere_mass(double r) {
  const double volume = 4.0 / 3 * pi * r * r * r;
  return {volume, {}, Mat3d::identity() * (0.4 * volume * r * r)};
}

// A cylinder and two half balls whose centres of mass are 3/8 r beyond its ends.
MassProperties capsule_mass(double r, double half) {
  const double cylinder = 2 * half * pi * r * r, ball = 4.0 / 3 * pi * r * r * r;
  const double along = 0.5 * cylinder * r * r + 0.4 * ball * r * r;
  const double across = cylinder * (r * r / 4 + half * half / 3) + ball * (0.4 * r * r + half * half + 0.75 * half * r);
  return {cylinder + ball, {}, Mat3d::diagonal({across, along, across})};
}

std::uint64_t content_hash(const Geometry& g) {
  Hasher hasher;
  hasher.add(g.kind).add(g.radius).add(g.half_length).add_all(std::span<const Vec3>(g.hull.vertices));
  for (const Polyhedron::Face& face : g.hull.faces) hasher.add(face.count);
  return hasher.add_all(std::span<const std::uint32_t>(g.hull.loops)).value();
}

void complete_hull(Geometry& g) {
  // −0 and 0 are the same place and must have the same hash.
  for (Vec3& v : g.hull.vertices) v += Vec3{};
  g.mass = complete(g.hull);
  double farthest = 0;
  for (const Vec3& v : g.hull.vertices) farthest = max(farthest, length(convert<double>(v)));
  g.bounding_radius = Real(farthest) * (1 + std::numeric_limits<Real>::epsilon());  // not less, for all rounding
}

}

std::shared_ptr<const Geometry> make_geometry(Geometry&& plain) {
  Geometry g = std::move(plain);
  switch (g.kind) {
    case ShapeKind::sphere:
      check_size("radius", g.radius);
      g.mass = sphere_mass(double(g.radius));
      g.bounding_radius = g.radius;
      break;
    case ShapeKind::capsule:
      check_size("radius", g.radius);
      check_size("length", g.half_length);
      g.mass = capsule_mass(double(g.radius), double(g.half_length));
      g.bounding_radius = g.radius + g.half_length;
      break;
    case ShapeKind::half_space:
      g.bounding_radius = Real(infinity);
      break;
    case ShapeKind::hull:
      complete_hull(g);
      break;
    default:
      throw Error("kind", "is no kind of shape");
  }
  const bool massive = g.kind != ShapeKind::half_space;
  if (massive &&
      !(std::isfinite(trace(g.mass.inertia)) && trace(g.mass.inertia) > 0 && g.bounding_radius < Real(1e15))) {
    throw Error("shape", "is too small or too large to have a mass");
  }
  g.hash = content_hash(g);
  return std::make_shared<const Geometry>(std::move(g));
}

Box bounds(const Geometry& g, const Pose& pose, Real margin) {
  Vec3 low, high;
  switch (g.kind) {
    case ShapeKind::half_space:
      return {{-infinity, -infinity, -infinity}, {infinity, infinity, infinity}};
    case ShapeKind::hull: {
      const Mat3 turn = matrix(pose.q);
      low = high = turn * g.hull.vertices[0];
      for (const Vec3& vertex : g.hull.vertices) {
        const Vec3 v = turn * vertex;
        low = min(low, v);
        high = max(high, v);
      }
      break;
    }
    case ShapeKind::sphere:
    case ShapeKind::capsule:
      high = abs(rotate(pose.q, Vec3{0, g.half_length, 0})) + Vec3{g.radius, g.radius, g.radius};
      low = -high;
      break;
  }
  const Vec3 wider{margin, margin, margin};
  return {pose.p + (low - wider), pose.p + (high + wider)};
}

}
