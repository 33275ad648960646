#include "geometry/archive.h"

namespace sudar::inline SUDAR_PRECISION {

namespace {

void write(Writer& w, const Geometry& g) {
  w.named("kind", g.kind);
  w.named("radius", g.radius), w.named("half_length", g.half_length);
  if (g.kind == ShapeKind::ellipsoid || w.by_example()) w.named("radii", g.radii);
  w.named("vertices", g.hull.vertices);
  w.named("faces", std::uint64_t(g.hull.faces.size()));
  for (const Polyhedron::Face& f : g.hull.faces) w.named("first", f.first), w.named("count", f.count);
  w.named("loops", g.hull.loops);
}

}

void write(Writer& w, const Shape& shape) {
  w.named("there", std::uint8_t(shape ? 1 : 0));
  if (shape || w.by_example()) write(w, shape ? shape.geometry() : Geometry{});
}

void read(Reader& r, Shape& shape) {
  shape = {};
  if (r.value<std::uint8_t>() == 0) return;
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
