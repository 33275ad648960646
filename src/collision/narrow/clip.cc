#include "collision/narrow/clip.h"

#include <algorithm>

#include "collision/narrow/closest.h"
#include "collision/narrow/flat.h"
#include "collision/narrow/reduce.h"

namespace sudar::inline SUDAR_PRECISION {
namespace {

constexpr Real thickness = Real(1e-4);  // of side planes, of the smaller hull's radius

using Feature = std::uint32_t;
constexpr Feature vertex_of_a = 0, vertex_of_b = 1u << 30, crossing = 2u << 30, fifteen_bits = 0x7fff;

// What bounds the polygon after a corner: a side of the incident face, or one of the reference face.
struct Side {
  bool of_reference;
  std::uint32_t number;  // in the face's loop
};

struct Corner {
  Vec3 at;
  Feature feature;
  Side next;
};

using Polygon = SmallArray<Corner, 64>;

struct FacePair {
  const HullView &reference, &incident;
  std::uint32_t reference_face, incident_face;
  bool reference_is_a;

  const Polyhedron::Face& outer() const { return reference.faces[reference_face]; }
  const Polyhedron::Face& inner() const { return incident.faces[incident_face]; }

  Feature incident_vertex(std::uint32_t corner) const {
    return (reference_is_a ? vertex_of_b : vertex_of_a) | incident.shape->loops[inner().first + corner];
  }
  // Where the side plane `clip` cuts what follows a corner.
  Feature cut(const Side& side, std::uint32_t clip) const {
    const std::uint32_t count = outer().count;
    if (side.of_reference) {  // two side planes meet at a vertex of the reference face
      const std::uint32_t vertex = (side.number + 1) % count == clip ? clip : side.number;
      return (reference_is_a ? vertex_of_a : vertex_of_b) | reference.shape->loops[outer().first + vertex];
    }
    const std::uint32_t r = outer().first + clip, i = inner().first + side.number;
    const std::uint32_t a = reference_is_a ? r : i, b = reference_is_a ? i : r;
    return crossing | (a & fifteen_bits) << 15 | (b & fifteen_bits);
  }
};

// Cuts off what lies beyond the plane; `clip` is the number of the reference side that the plane stands on.
void cut(const Polygon& in, const Vec3& normal, Real offset, Real thick, std::uint32_t clip, const FacePair& pair,
         Polygon& out) {
  out.clear();
  if (in.size() == 0) return;
  Real d = dot(normal, in[0].at) - offset;
  const Real d_first = d;
  for (std::size_t i = 0; i < in.size(); ++i) {
    const bool last = i + 1 == in.size();
    const Corner &corner = in[i], &following = in[last ? 0 : i + 1];
    const Real d_next = last ? d_first : dot(normal, following.at) - offset;
    if (d <= thick) out.push({corner.at, corner.feature, d_next > thick ? Side{true, clip} : corner.next});
    const bool leaves = d < -thick && d_next > thick, enters = d > thick && d_next < -thick;
    if (leaves || enters) {
      const Vec3 at = corner.at + (following.at - corner.at) * (d / (d - d_next));
      if (leaves) out[out.size() - 1].next = corner.next;
      out.push({at, pair.cut(corner.next, clip), leaves ? Side{true, clip} : corner.next});
    }
    d = d_next;
  }
}

using Points = SmallArray<ManifoldPoint, 64>;

// visit(plane's outward normal, its offset) for each side of the prism that stands on a face along `up`.
template <class Visit>
void each_side(const HullView& hull, std::uint32_t face, const Vec3& up, Visit visit) {
  const std::uint32_t count = hull.faces[face].count;
  for (std::uint32_t k = 0; k < count; ++k) {
    const Vec3 start = hull.vertex(face, k), end = hull.vertex(face, k + 1 == count ? 0 : k + 1);
    const Vec3 side = normalize(cross(end - start, up));
    visit(k, side, dot(side, start));
  }
}

// The incident face, clipped; separations along the axis. `n` is the axis, from a to b.
void clip_faces(const FacePair& pair, const Vec3& n, Real margin, Real thick, Points& out) {
  const Polyhedron::Face &outer = pair.outer(), &inner = pair.inner();
  const std::size_t most = outer.count + inner.count;
  Polygon polygon(most), cut_polygon(most);
  for (std::uint32_t i = 0; i < inner.count; ++i) {
    polygon.push({pair.incident.vertex(pair.incident_face, i), pair.incident_vertex(i), {false, i}});
  }
  const Vec3 up = pair.reference_is_a ? n : -n;
  Polygon *from = &polygon, *to = &cut_polygon;
  each_side(pair.reference, pair.reference_face, up, [&](std::uint32_t k, const Vec3& side, Real offset) {
    cut(*from, side, offset, thick, k, pair, *to);
    std::swap(from, to);
  });

  const Real slope = 1 / dot(outer.normal, up);
  for (const Corner& c : *from) {
    const Real s = (dot(outer.normal, c.at) - outer.offset) * slope;
    if (s < margin) out.push({c.at - up * (s * Real(0.5)), s, c.feature});
  }
}

// What else of the incident hull is over the reference face: where many small faces meet, or the whole hull is smaller
// than the margin, the vertices beside the incident face carry as well as its own.
void other_vertices(const FacePair& pair, const Vec3& n, Real margin, Real thick, Points& out) {
  const Polyhedron::Face &outer = pair.outer(), &inner = pair.inner();
  const Vec3 up = pair.reference_is_a ? n : -n;
  const Real slope = 1 / dot(outer.normal, up);
  const auto own = std::span(pair.incident.shape->loops).subspan(inner.first, inner.count);
  for (std::uint32_t v = 0; v < pair.incident.vertices.size(); ++v) {
    const Vec3& at = pair.incident.vertices[v];
    const Real s = (dot(outer.normal, at) - outer.offset) * slope;
    if (!(s < margin) || std::find(own.begin(), own.end(), v) != own.end()) continue;
    bool over = true;
    each_side(pair.reference, pair.reference_face, up,
              [&](std::uint32_t, const Vec3& side, Real offset) { over &= dot(side, at) - offset <= thick; });
    if (over) out.push({at - up * (s * Real(0.5)), s, (pair.reference_is_a ? vertex_of_b : vertex_of_a) | v});
  }
}

Real lowest(const Manifold& m) {
  Real low = m.points[0].separation;
  for (int i = 1; i < m.count; ++i) low = min(low, m.points[std::size_t(i)].separation);
  return low;
}

// Where one more point goes: in the place of the highest one, if there is no other.
ManifoldPoint& place_of_one(Manifold& m) {
  if (m.count < int(m.points.size())) return m.points[std::size_t(m.count++)];
  return *std::ranges::max_element(m.points, {}, &ManifoldPoint::separation);
}

std::uint32_t most_along(std::span<const Polyhedron::Face> faces, const Vec3& direction) {
  std::uint32_t best = 0;
  Real best_value = dot(faces[0].normal, direction);
  for (std::uint32_t i = 1; i < faces.size(); ++i) {
    const Real value = dot(faces[i].normal, direction);
    if (value > best_value) best = i, best_value = value;
  }
  return best;
}

// One point: where the two edges pass each other, or the vertex that is deepest. Of separation `margin` if there is
// none.
ManifoldPoint single_point(const HullView& a, const HullView& b, const Axis& axis, Real margin) {
  const Vec3& n = axis.normal;
  if (axis.kind == Axis::edges) {
    const Polyhedron::Edge &ea = a.shape->edges[axis.a], &eb = b.shape->edges[axis.b];
    const SegmentPoints c = closest({a.vertices[ea.from], a.along(ea)}, {b.vertices[eb.from], b.along(eb)});
    const bool pass = axis.separation <= 0 || length_squared(c.on_b - c.on_a) < square(margin);
    const Feature feature = crossing | (axis.a & fifteen_bits) << 15 | (axis.b & fifteen_bits);
    return {(c.on_a + c.on_b) * Real(0.5), pass ? axis.separation : margin, feature};
  }
  const bool of_b = axis.kind == Axis::face_a;
  const std::uint32_t v = of_b ? support(b.vertices, -n) : support(a.vertices, n);
  const Vec3 middle =
      of_b ? b.vertices[v] - n * (axis.separation * Real(0.5)) : a.vertices[v] + n * (axis.separation * Real(0.5));
  return {middle, axis.separation <= 0 ? axis.separation : margin, (of_b ? vertex_of_b : vertex_of_a) | v};
}

}

void contact_region(const HullView& a, const HullView& b, const Axis& axis, Reach reach, Manifold& out) {
  const Vec3& n = axis.normal;
  out.normal = -n;
  out.count = 0;
  const std::uint32_t fa = axis.kind == Axis::face_a ? axis.a : most_along(a.faces, n);
  const std::uint32_t fb = axis.kind == Axis::face_b ? axis.b : most_along(b.faces, -n);
  const Real cosine_a = dot(a.faces[fa].normal, n), cosine_b = -dot(b.faces[fb].normal, n);
  const bool flat = min(cosine_a, cosine_b) > Real(flat_cosine);
  const Real scale = min(a.radius, b.radius);
  const Real thick = thickness * scale;
  const FacePair on_a{a, b, fa, fb, true}, on_b{b, a, fb, fa, false};
  Points points(a.vertices.size() + b.vertices.size() + a.faces[fa].count + b.faces[fb].count);
  // Where edges cross almost in the plane of a face, more of the other hull than that point is over the face, or will be
  // before these hulls are looked at again.
  const Real almost = 1 - square(reach.turn) / 2;
  const bool crossing = axis.kind == Axis::edges;
  const bool over_a = flat || axis.kind == Axis::face_a || (crossing && cosine_a > almost);
  const bool over_b = flat || axis.kind == Axis::face_b || (crossing && cosine_b > almost);
  if (over_a) {
    clip_faces(on_a, n, reach.margin, thick, points);
  } else if (over_b) {
    clip_faces(on_b, n, reach.margin, thick, points);
  }
  if (over_a) other_vertices(on_a, n, reach.margin, thick, points);
  if (over_b) other_vertices(on_b, n, reach.margin, thick, points);
  if (points.size() > 0) reduce(points.all(), n, reach.turn, scale, out);
  // Hulls that overlap have a contact, even where the faces pass beside what is deepest. Hulls that do not, and whose
  // faces do not lie over each other either, are farther apart than the axis says, unless the two edges that decided it
  // do pass each other.
  if (out.count > 0 && (axis.separation > 0 || lowest(out) <= axis.separation / 2 + thick)) return;
  const ManifoldPoint point = single_point(a, b, axis, reach.margin);
  if (point.separation < reach.margin) place_of_one(out) = point;
}

}
