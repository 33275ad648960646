// The members of Shape and the shapes that need no vertices.
#include <sudar/shape.h>

#include "geometry/geometry.h"

#include <algorithm>

namespace sudar::inline SUDAR_PRECISION {

bool Shape::operator==(const Shape& other) const {
  if (geometry_ == other.geometry_) return true;
  if (!geometry_ || !other.geometry_) return false;
  const Geometry &a = *geometry_, &b = *other.geometry_;
  const auto same_size = [](const Polyhedron::Face& f, const Polyhedron::Face& g) { return f.count == g.count; };
  return a.hash == b.hash && a.kind == b.kind && a.radius == b.radius && a.half_length == b.half_length &&
         a.radii == b.radii &&
         a.hull.vertices == b.hull.vertices && a.hull.loops == b.hull.loops &&
         std::equal(a.hull.faces.begin(), a.hull.faces.end(), b.hull.faces.begin(), b.hull.faces.end(), same_size);
}

ShapeKind Shape::kind() const { return geometry_->kind; }
Real Shape::radius() const { return geometry_->radius; }
Real Shape::half_length() const { return geometry_->half_length; }
Vec3 Shape::radii() const { return geometry_->radii; }
Real Shape::bounding_radius() const { return geometry_->bounding_radius; }
std::span<const Vec3> Shape::vertices() const { return geometry_->hull.vertices; }

MassProperties Shape::mass_properties() const {
  if (!has_mass(geometry_->kind)) throw Error("shape", "is a half space, a hollow or a mesh, which have no mass");
  return geometry_->mass;
}

std::vector<std::vector<std::uint32_t>> Shape::faces() const {
  const Polyhedron& p = geometry_->hull;
  std::vector<std::vector<std::uint32_t>> faces;
  for (const Polyhedron::Face& face : p.faces) {
    const auto first = p.loops.begin() + face.first;
    faces.emplace_back(first, first + face.count);
  }
  return faces;
}

namespace {

Shape made(ShapeKind kind, Real radius, Real half_length = 0, const Vec3& radii = {}) {
  Geometry g;
  g.kind = kind;
  g.radius = radius;
  g.half_length = half_length;
  g.radii = radii;
  return Shape(make_geometry(std::move(g)));
}

}

Shape sphere(Real radius) { return made(ShapeKind::sphere, radius); }
Shape capsule(Real radius, Real length) { return made(ShapeKind::capsule, radius, length / 2); }
Shape cylinder(Real radius, Real height) { return made(ShapeKind::cylinder, radius, height / 2); }
Shape cone(Real radius, Real height) { return made(ShapeKind::cone, radius, height / 2); }
Shape ellipsoid(Vec3 radii) { return made(ShapeKind::ellipsoid, 0, 0, radii); }
Shape half_space() { return made(ShapeKind::half_space, 0); }
Shape hollow_sphere(Real radius) { return made(ShapeKind::hollow_sphere, radius); }
Shape mesh(std::span<const Vec3> vertices, std::span<const std::uint32_t> triangles) {
  Geometry g;
  g.kind = ShapeKind::mesh;
  g.hull.vertices.assign(vertices.begin(), vertices.end());
  g.hull.loops.assign(triangles.begin(), triangles.end());
  return Shape(make_geometry(std::move(g)));
}
Shape hollow_cylinder(Real radius, Real height) { return made(ShapeKind::hollow_cylinder, radius, height / 2); }

}
