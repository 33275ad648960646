#include "geometry/geometry.h"

#include "base/hash.h"

#include "geometry/triangle_mesh.h"

#include <sudar/solids.h>

namespace sudar::inline SUDAR_PRECISION {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

void check_size(const char* field, Real size) {
  if (!std::isfinite(size) || !(size > 0)) throw Error(field, "must be a positive number");
}

std::uint64_t content_hash(const Geometry& g) {
  Hasher hasher;
  hasher.add(g.kind).add(g.radius).add(g.half_length);
  if (g.kind == ShapeKind::ellipsoid) hasher.add(g.radii);
  hasher.add_all(std::span<const Vec3>(g.hull.vertices));
  for (const Polyhedron::Face& face : g.hull.faces) hasher.add(face.count);
  return hasher.add_all(std::span<const std::uint32_t>(g.hull.loops)).value();
}

// Not less than the length, for all rounding.
Real at_least(double length) { return Real(length) * (1 + std::numeric_limits<Real>::epsilon()); }

void complete_hull(Geometry& g) {
  // −0 and 0 are the same place and must have the same hash.
  for (Vec3& v : g.hull.vertices) v += Vec3{};
  g.mass = complete(g.hull);
  double farthest = 0;
  for (const Vec3& v : g.hull.vertices) farthest = max(farthest, length(convert<double>(v)));
  g.bounding_radius = at_least(farthest);
}

void complete_mesh(Geometry& g) {
  for (std::uint32_t k = 0; k < g.hull.faces.size(); ++k) {
    const Polyhedron::Face& f = g.hull.faces[k];
    if (f.first != 3 * k || f.count != 3) throw Error("faces", "of a mesh must be triangles, one after the other");
  }
  for (Vec3& v : g.hull.vertices) v += Vec3{};
  g.mesh = make_triangle_mesh(g.hull.vertices, g.hull.loops);
  const std::size_t count = g.mesh->triangles.size();
  g.hull.faces.resize(count);
  for (std::size_t k = 0; k < count; ++k) {
    const TriangleMesh::Triangle& t = g.mesh->triangles[k];
    g.hull.faces[k] = {t.normal, dot(t.normal, t.corners[0]), std::uint32_t(3 * k), 3};
  }
  double farthest = 0;
  for (const Vec3& v : g.hull.vertices) farthest = max(farthest, length(convert<double>(v)));
  g.bounding_radius = at_least(farthest);
}

void complete_ellipsoid(Geometry& g) {
  g.mass = mass_of(solid::Ellipsoid{convert<double>(g.radii)});
  g.bounding_radius = max_component(g.radii);
}

void complete_by_radius(Geometry& g) {
  check_size("radius", g.radius);
  const bool ball = g.kind == ShapeKind::sphere || g.kind == ShapeKind::hollow_sphere;
  if (!ball) check_size(g.kind == ShapeKind::capsule ? "length" : "height", g.half_length);
  const double r = double(g.radius), half = double(g.half_length);
  switch (g.kind) {
    case ShapeKind::sphere:
      g.mass = mass_of(solid::Sphere{r});
      break;
    case ShapeKind::capsule:
      g.mass = mass_of(solid::Capsule{r, 2 * half});
      g.bounding_radius = g.radius + g.half_length;
      return;
    case ShapeKind::cylinder:
      g.mass = mass_of(solid::Cylinder{r, 2 * half});
      break;
    case ShapeKind::cone:
      g.mass = mass_of(solid::Cone{r, 2 * half});
      g.mass.center = {};  // the origin (shape.h)
      g.bounding_radius = at_least(max(1.5 * half, sqrt(r * r + half * half / 4)));
      return;
    default:
      break;
  }
  g.bounding_radius = ball ? g.radius : at_least(sqrt(r * r + half * half));
}

}

std::shared_ptr<const Geometry> make_geometry(Geometry&& plain) {
  Geometry g = std::move(plain);
  switch (g.kind) {
    case ShapeKind::half_space:
      g.bounding_radius = Real(infinity);
      break;
    case ShapeKind::hull:
      complete_hull(g);
      break;
    case ShapeKind::ellipsoid:
      complete_ellipsoid(g);
      break;
    case ShapeKind::mesh:
      complete_mesh(g);
      break;
    case ShapeKind::sphere:
    case ShapeKind::capsule:
    case ShapeKind::cylinder:
    case ShapeKind::cone:
    case ShapeKind::hollow_sphere:
    case ShapeKind::hollow_cylinder:
      complete_by_radius(g);
      break;
    default:
      throw Error("kind", "is no kind of shape");
  }
  const bool heavy = std::isfinite(trace(g.mass.inertia)) && trace(g.mass.inertia) > 0;
  if (g.kind != ShapeKind::half_space && !(g.bounding_radius < Real(1e15) && (heavy || !has_mass(g.kind)))) {
    throw Error("shape", "is too small or too large to have a mass");
  }
  g.hash = content_hash(g);
  return std::make_shared<const Geometry>(std::move(g));
}

namespace {

// How far a disc of radius 1 at right angles to the unit vector `axis` reaches along each coordinate.
Vec3 disc_reach(const Vec3& axis) {
  const auto across = [](Real x) { return sqrt(max(Real(0), (1 - x) * (1 + x))); };
  return {across(axis.x), across(axis.y), across(axis.z)};
}

}

Real inner_radius(const Geometry& g) {
  switch (g.kind) {
    case ShapeKind::hull: {
      Real least = std::numeric_limits<Real>::infinity();
      for (const Polyhedron::Face& f : g.hull.faces) {
        least = min(least, f.offset - dot(f.normal, convert<Real>(g.mass.center)));
      }
      return max(least, Real(0));
    }
    case ShapeKind::sphere:
    case ShapeKind::capsule:
      return g.radius;
    case ShapeKind::cylinder:
      return min(g.radius, g.half_length);
    case ShapeKind::cone: {  // the centre is a quarter of the height above the base
      const Real height = 2 * g.half_length, slope = sqrt(square(g.radius) + square(height));
      return min(height / 4, Real(0.75) * height * g.radius / slope);
    }
    case ShapeKind::ellipsoid:
      return min(min(g.radii.x, g.radii.y), g.radii.z);
    default:
      return 0;
  }
}

Real swing_radius(const Geometry& g) {
  switch (g.kind) {
    case ShapeKind::sphere: return 0;
    case ShapeKind::capsule: return g.half_length;  // of its core, which is what turns
    default: return g.bounding_radius;
  }
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
    case ShapeKind::mesh: {
      const Vec3 middle = (g.mesh->low + g.mesh->high) * Real(0.5), half = (g.mesh->high - g.mesh->low) * Real(0.5);
      const Mat3 turn = matrix(pose.q);
      const Vec3 reach = abs(turn.c0) * half.x + abs(turn.c1) * half.y + abs(turn.c2) * half.z;
      low = turn * middle - reach;
      high = turn * middle + reach;
      break;
    }
    case ShapeKind::sphere:
    case ShapeKind::hollow_sphere:
    case ShapeKind::capsule:
      high = abs(rotate(pose.q, Vec3{0, g.half_length, 0})) + Vec3{g.radius, g.radius, g.radius};
      low = -high;
      break;
    case ShapeKind::cylinder:
    case ShapeKind::hollow_cylinder: {
      const Vec3 axis = rotate(pose.q, Vec3{0, 1, 0});
      high = abs(axis) * g.half_length + disc_reach(axis) * g.radius;
      low = -high;
      break;
    }
    case ShapeKind::cone: {
      const Vec3 axis = rotate(pose.q, Vec3{0, 1, 0}), apex = axis * (g.half_length * Real(1.5));
      const Vec3 base = axis * (g.half_length * Real(-0.5)), reach = disc_reach(axis) * g.radius;
      low = min(apex, base - reach);
      high = max(apex, base + reach);
      break;
    }
    case ShapeKind::ellipsoid: {
      const Mat3 turn = matrix(pose.q);
      const Vec3 x = turn.c0 * g.radii.x, y = turn.c1 * g.radii.y, z = turn.c2 * g.radii.z;
      high = {length(Vec3{x.x, y.x, z.x}), length(Vec3{x.y, y.y, z.y}), length(Vec3{x.z, y.z, z.z})};
      low = -high;
      break;
    }
  }
  const Vec3 wider{margin, margin, margin};
  return {pose.p + (low - wider), pose.p + (high + wider)};
}

}
