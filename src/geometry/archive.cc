#include "geometry/archive.h"

namespace sudar::inline SUDAR_PRECISION {

void write(Writer& w, const Shape& shape) {
  const Geometry& g = shape.geometry();
  w.value(g.kind);
  w.value(g.radius), w.value(g.half_length);
  if (g.kind == ShapeKind::ellipsoid) write(w, g.radii);
  w.array(g.hull.vertices);
  w.value(std::uint64_t(g.hull.faces.size()));
  for (const Polyhedron::Face& f : g.hull.faces) w.value(f.first), w.value(f.count);
  w.array(g.hull.loops);
}

void read(Reader& r, Shape& shape) {
  Geometry g;
  g.kind = r.value<ShapeKind>();
  g.radius = r.value<Real>(), g.half_length = r.value<Real>();
  if (g.kind == ShapeKind::ellipsoid) read(r, g.radii);
  r.array(g.hull.vertices);
  g.hull.faces.resize(r.count(8));
  for (Polyhedron::Face& f : g.hull.faces) f.first = r.value<std::uint32_t>(), f.count = r.value<std::uint32_t>();
  r.array(g.hull.loops);
  for (const Polyhedron::Face& f : g.hull.faces) {
    if (f.first > g.hull.loops.size() || f.count > g.hull.loops.size() - f.first) throw Error("data", "holds a face without vertices");
  }
  for (const std::uint32_t v : g.hull.loops) {
    if (v >= g.hull.vertices.size()) throw Error("data", "holds a face of a vertex that does not exist");
  }
  shape = Shape(make_geometry(std::move(g)));
}

}
