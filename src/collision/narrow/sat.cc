#include "collision/narrow/sat.h"

namespace sudar::inline SUDAR_PRECISION {
namespace {

constexpr Real nothing = -std::numeric_limits<Real>::infinity();

// sin² of the angle between two edges below which their cross product is only noise: they have no axis of their own.
// What such an axis could add is at most an edge's length times 1e-5.
constexpr Real parallel = Real(1e-10);
// … and below which its direction is so rough that the edges' distance along it is checked on all vertices.
constexpr Real nearly_parallel = Real(1e-4);

Real lowest(std::span<const Vec3> vertices, const Vec3& direction) {
  Real low = dot(vertices[0], direction);
  for (const Vec3& v : vertices.subspan(1)) low = min(low, dot(v, direction));
  return low;
}

Real face_separation(const Polyhedron::Face& face, const HullView& other) {
  return lowest(other.vertices, face.normal) - face.offset;
}

// The Gauss map test: a's arc runs from its left to its right face normal, b's between the negated ones. They cross if
// each separates the ends of the other and both lie on one half of the sphere. An edge's direction is normal to its
// arc.
inline bool arcs_cross(const HullView& a, const Polyhedron::Edge& ea, const HullView& b, const Polyhedron::Edge& eb) {
  const Vec3 along_a = a.along(ea);
  const Real left_b = dot(b.faces[eb.left].normal, along_a), right_b = dot(b.faces[eb.right].normal, along_a);
  if (!(left_b * right_b < 0)) return false;
  const Vec3 along_b = b.along(eb);
  const Real left_a = dot(a.faces[ea.left].normal, along_b), right_a = dot(a.faces[ea.right].normal, along_b);
  return left_a * right_a < 0 && left_b * right_a < 0;
}

// The axis of two edges whose arcs cross, or kind none if they are parallel.
Axis edge_axis(const HullView& a, std::uint32_t i, const HullView& b, std::uint32_t j) {
  const Polyhedron::Edge &ea = a.shape->edges[i], &eb = b.shape->edges[j];
  const Vec3 along_a = a.along(ea), along_b = b.along(eb), axis = cross(along_a, along_b);
  const Real size = length_squared(axis), full = length_squared(along_a) * length_squared(along_b);
  if (!(size > parallel * full)) return {};
  Vec3 n = axis / sqrt(size);
  if (dot(n, a.faces[ea.left].normal + a.faces[ea.right].normal) < 0) n = -n;
  Real separation = dot(n, b.vertices[eb.from] - a.vertices[ea.from]);
  if (size < nearly_parallel * full) separation = lowest(b.vertices, n) + lowest(a.vertices, -n);
  return {Axis::edges, i, j, separation, n};
}

class Search {
 public:
  Search(const HullView& a, const HullView& b, Real margin)
      : a_(a),
        b_(b),
        margin_(margin),
        scale_(min(a.radius, b.radius)),
        rounding_(16 * std::numeric_limits<Real>::epsilon() * (a.radius + b.radius + length(b.center - a.center))),
        heights_a_(a.faces.size()),
        heights_b_(b.faces.size()) {}

  bool cached(const AxisCache& cache) {
    if (cache.kind == Axis::face_a && cache.a < a_.faces.size()) see(face_separation(a_.faces[cache.a], b_));
    if (cache.kind == Axis::face_b && cache.b < b_.faces.size()) see(face_separation(b_.faces[cache.b], a_));
    if (cache.kind == Axis::edges && cache.a < a_.shape->edges.size() && cache.b < b_.shape->edges.size()) {
      Axis axis;
      pair_of_edges(cache.a, cache.b, axis);
    }
    return apart();
  }

  void faces_of_a(Axis& out) { faces(a_, b_, Axis::face_a, heights_a_, out); }
  void faces_of_b(Axis& out) { faces(b_, a_, Axis::face_b, heights_b_, out); }

  void edges(Axis& out) {
    SmallArray<std::uint32_t, 128> of_b(b_.shape->edges.size());
    for (std::uint32_t j = 0; j < b_.shape->edges.size(); ++j) {
      if (may_win(b_, j, heights_b_, a_)) of_b.push(j);
    }
    for (std::uint32_t i = 0; i < a_.shape->edges.size(); ++i) {
      if (!may_win(a_, i, heights_a_, b_)) continue;
      for (const std::uint32_t j : of_b) {
        pair_of_edges(i, j, out);
        if (apart()) return;
      }
    }
  }

  bool apart() const { return bound_ > margin_; }
  Axis none() const { return {.separation = bound_, .normal = {}}; }
  Real tolerance(Real separation) const { return Real(1e-4) * abs(separation) + Real(2e-5) * scale_; }

 private:
  using Heights = SmallArray<Real, 64>;  // of the other hull's centre above each face

  void see(Real separation) {
    if (separation <= bound_) return;
    bound_ = separation;
    // Three tolerances: what loses by less could still be preferred, directly or by way of a third axis.
    least_ = bound_ - 3 * tolerance(bound_) - rounding_;
  }

  // Replaces `out` if it is better.
  void pair_of_edges(std::uint32_t i, std::uint32_t j, Axis& out) {
    if (!arcs_cross(a_, a_.shape->edges[i], b_, b_.shape->edges[j])) return;
    const Axis axis = edge_axis(a_, i, b_, j);
    if (axis.kind == Axis::none || (out.kind != Axis::none && axis.separation <= out.separation)) return;
    out = axis;
    see(axis.separation);
  }

  // The best face of `of`, unless it cannot win.
  void faces(const HullView& of, const HullView& other, Axis::Kind kind, Heights& heights, Axis& out) {
    for (std::uint32_t i = 0; i < of.faces.size(); ++i) {
      const Polyhedron::Face& face = of.faces[i];
      const Real height = dot(face.normal, other.center) - face.offset;
      heights.push(height);
      if (height - other.inner_radius < least_) continue;
      const Real s = face_separation(face, other);
      if (out.kind == Axis::none || s > out.separation) out = {kind, i, i, s, face.normal};
      see(s);
      if (apart()) return;
    }
  }

  // Along a normal on an edge's arc the edge is the part of its hull farthest out: the separation is at most the height
  // of the other centre above the edge, less the other ball's radius. The heights at the ends of the arc, l and r, are
  // those above the two faces; between them the height is (αl + βr)/|αn_l + βn_r|, largest either at an end or where
  // its square is (l² + r² − 2lr c)/(1 − c²), c = n_l·n_r.
  bool may_win(const HullView& of, std::uint32_t edge, const Heights& heights, const HullView& other) const {
    const Polyhedron::Edge& e = of.shape->edges[edge];
    const Real l = heights[e.left], r = heights[e.right], need = least_ + other.inner_radius;
    if (max(l, r) >= need) return true;
    const Real c = dot(of.faces[e.left].normal, of.faces[e.right].normal);
    if (r <= c * l || l <= c * r) return false;
    return l * l + r * r - 2 * l * r * c >= square(max(need, Real(0))) * (1 - c * c);
  }

  const HullView &a_, &b_;
  const Real margin_, scale_, rounding_;
  Heights heights_a_, heights_b_;
  Real bound_ = nothing;  // some axis separates by at least this
  Real least_ = nothing;  // what a further axis must reach to matter
};

}

HullView::HullView(const Polyhedron& hull)
    : vertices(hull.vertices), faces(hull.faces), shape(&hull), center(hull.interior) {
  measure();
}

void HullView::measure() {
  inner_radius = std::numeric_limits<Real>::infinity();
  for (const Polyhedron::Face& f : faces) inner_radius = min(inner_radius, f.offset - dot(f.normal, center));
  Real r = 0;
  for (const Vec3& v : vertices) r = max(r, length_squared(v - center));
  radius = sqrt(r);
}

MovedHull::MovedHull(const Polyhedron& hull, const Mat3& turn, const Vec3& shift)
    : moved_vertices_(hull.vertices.size()), moved_faces_(hull.faces.size()) {
  for (const Vec3& v : hull.vertices) moved_vertices_.push(turn * v + shift);
  for (const Polyhedron::Face& f : hull.faces) {
    const Vec3 n = turn * f.normal;
    moved_faces_.push({n, f.offset + dot(n, shift), f.first, f.count});
  }
  vertices = moved_vertices_.all();
  faces = moved_faces_.all();
  shape = &hull;
  center = turn * hull.interior + shift;
  measure();
}

std::uint32_t support(std::span<const Vec3> vertices, const Vec3& direction) {
  std::uint32_t best = 0;
  Real best_value = dot(vertices[0], direction);
  for (std::uint32_t i = 1; i < vertices.size(); ++i) {
    const Real value = dot(vertices[i], direction);
    if (value > best_value) best = i, best_value = value;
  }
  return best;
}

Axis find_axis(const HullView& a, const HullView& b, Real margin, AxisCache& cache) {
  Search search(a, b, margin);
  if (search.cached(cache)) return search.none();
  Axis best, of_b, of_edges;
  search.faces_of_a(best);
  if (!search.apart()) search.faces_of_b(of_b);
  if (!search.apart()) search.edges(of_edges);
  // From the most to the least preferred. Where the search stopped early the last axis seen separates; it is kept to be
  // tried first next time.
  for (const Axis& other : {of_b, of_edges}) {
    if (other.kind == Axis::none) continue;
    if (best.kind == Axis::none || other.separation > best.separation + search.tolerance(best.separation)) best = other;
  }
  cache = {best.kind, best.a, best.b};
  if (search.apart()) return search.none();
  if (best.kind == Axis::face_b) best.normal = -best.normal;
  return best;
}

}
