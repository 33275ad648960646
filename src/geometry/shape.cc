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
         a.hull.vertices == b.hull.vertices && a.hull.loops == b.hull.loops &&
         std::equal(a.hull.faces.begin(), a.hull.faces.end(), b.hull.faces.begin(), b.hull.faces.end(), same_size);
}

ShapeKind Shape::kind() const { return geometry_->kind; }
Real Shape::radius() const { return geometry_->radius; }
Real Shape::half_length() const { return geometry_->half_length; }
Real Shape::bounding_radius() const { return geometry_->bounding_radius; }
std::span<const Vec3> Shape::vertices() const { return geometry_->hull.vertices; }

MassProperties Shape::mass_properties() const {
  if (geometry_->kind == ShapeKind::half_space) throw Error("shape", "is a half space, which has no mass");
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

Shape sphere(Real radius) {
  Geometry g;
  g.kind = ShapeKind::sphere;
  g.radius = radius;
  return Shape(make_geometry(std::move(g)));
}

Shape capsule(Real radius, Real length) {
  Geometry g;
  g.kind = ShapeKind::capsule;
  g.radius = radius;
  g.half_length = length / 2;
  return Shape(make_geometry(std::move(g)));
}

Shape half_space() {
  Geometry g;
  g.kind = ShapeKind::half_space;
  return Shape(make_geometry(std::move(g)));
}

}
