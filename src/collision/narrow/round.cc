#include "collision/narrow/round.h"

#include "collision/narrow/flat.h"

namespace sudar::inline SUDAR_PRECISION {
namespace {

constexpr Real infinity = std::numeric_limits<Real>::infinity();

std::uint32_t end_of(Real t) { return t <= 0 ? 0 : t >= 1 ? 1 : 2; }

void add(const Vec3& at, Real separation, std::uint32_t feature, Real margin, Manifold& out) {
  if (separation < margin) out.points[std::size_t(out.count++)] = {at, separation, feature};
}

// The normal between segments that touch: across both, or across one, or any.
Vec3 normal_at_touch(const Segment& a, const Segment& b) {
  const Vec3 across = cross(a.along, b.along);
  const Real aa = length_squared(a.along), bb = length_squared(b.along);
  if (length_squared(across) > Real(1e-6) * aa * bb) return normalize(across);
  if (aa > 0 || bb > 0) return any_perpendicular(normalize(aa >= bb ? a.along : b.along));
  return {0, 1, 0};
}

}

void collide_rounds(const Round& a, const Round& b, Real margin, Manifold& out) {
  out.count = 0;
  const SegmentPoints c = closest(a.axis, b.axis);
  const Vec3 between = c.on_a - c.on_b;
  const Real radii = a.radius + b.radius, d_squared = length_squared(between);
  if (!(d_squared < square(radii + margin))) return;
  const Real d = sqrt(d_squared);
  const Vec3 n = d > Real(1e-6) * radii ? between / d : normal_at_touch(a.axis, b.axis);
  out.normal = n;
  const auto middle = [&](const Vec3& on_a, const Vec3& on_b) {
    return (on_a - n * a.radius + on_b + n * b.radius) * Real(0.5);
  };

  const Real aa = length_squared(a.axis.along), bb = length_squared(b.axis.along);
  if (length_squared(cross(a.axis.along, b.axis.along)) < square(Real(flat_sine)) * aa * bb) {
    // The stretch of a beside which b lies, and the points of b at right angles to its ends.
    const Real slope = dot(a.axis.along, b.axis.along) / aa;
    const Real base = dot(b.axis.start - a.axis.start, a.axis.along) / aa;
    Interval<Real> stretch;
    stretch.low = max(Real(0), min(base, base + slope));
    stretch.high = min(Real(1), max(base, base + slope));
    if (!stretch.empty()) {
      std::uint32_t feature = 0;
      for (const Real s : {stretch.low, stretch.high}) {
        const Vec3 on_a = a.axis.at(s), on_b = b.axis.at((s - base) / slope);
        add(middle(on_a, on_b), dot(n, on_a - on_b) - radii, feature++, margin, out);
      }
      if (out.count > 0) return;
    }
  }
  add(middle(c.on_a, c.on_b), d - radii, end_of(c.s), margin, out);
}

void collide_sphere_hull(const Vec3& center, Real radius, const Polyhedron& hull, Real margin, Manifold& out) {
  out.count = 0;
  const HullDistance d = distance(hull, center, radius + margin);
  if (!(d.distance < radius + margin)) return;
  out.normal = d.normal;
  add(center - d.normal * radius, d.distance - radius, 0, margin, out);
}

namespace {

// The axis of largest separation between a segment and a hull: faces, and edges crossed with the segment.
struct SegmentAxis {
  Real separation = -infinity;
  Vec3 normal;  // from the hull to the segment
  int face = -1;
  int edge = -1;
};

SegmentAxis find_axis(const Segment& s, const Polyhedron& hull) {
  SegmentAxis best;
  for (std::size_t i = 0; i < hull.faces.size(); ++i) {
    const Polyhedron::Face& f = hull.faces[i];
    const Real separation = dot(f.normal, s.start) - f.offset + min(dot(f.normal, s.along), Real(0));
    if (separation > best.separation) best = {separation, f.normal, int(i), -1};
  }
  // On the Gauss map a segment is the great circle at right angles to it: the edges whose arcs cross it count.
  const Real face_wins = Real(1e-4) * abs(best.separation);
  for (std::size_t i = 0; i < hull.edges.size(); ++i) {
    const Polyhedron::Edge& e = hull.edges[i];
    const Vec3 &l = hull.faces[e.left].normal, &r = hull.faces[e.right].normal;
    if (!(dot(l, s.along) * dot(r, s.along) < 0)) continue;
    const Vec3 along = hull.vertices[e.to] - hull.vertices[e.from], axis = cross(along, s.along);
    const Real size = length_squared(axis);
    if (!(size > Real(1e-10) * length_squared(along) * length_squared(s.along))) continue;
    Vec3 n = axis / sqrt(size);
    if (dot(n, l + r) < 0) n = -n;
    const Real separation = dot(n, s.start - hull.vertices[e.from]);
    if (separation > best.separation + face_wins) best = {separation, n, -1, int(i)};
  }
  return best;
}

struct Nearest {
  Real distance = infinity;
  Vec3 normal;  // from the hull to the segment
  Real t = 0;   // on the segment
};

// Segment and hull are apart: then an end of the segment is closest, or a point of an edge.
Nearest nearest(const Segment& s, const Polyhedron& hull, Real reach) {
  Nearest best;
  for (const Real t : {Real(0), Real(1)}) {
    const HullDistance d = distance(hull, s.at(t), reach);
    if (d.distance < best.distance) best = {d.distance, d.normal, t};
  }
  for (const Polyhedron::Edge& e : hull.edges) {
    const Vec3& from = hull.vertices[e.from];
    const SegmentPoints c = closest(s, {from, hull.vertices[e.to] - from});
    const Vec3 away = c.on_a - c.on_b;
    const Real d = length(away);
    if (d > 0 && d < best.distance) best = {d, away / d, c.s};
  }
  return best;
}

}

void collide_capsule_hull(const Round& capsule, const Polyhedron& hull, Real margin, Manifold& out) {
  out.count = 0;
  const Real radius = capsule.radius;
  const Segment& s = capsule.axis;
  const SegmentAxis axis = find_axis(s, hull);
  if (!(axis.separation < radius + margin)) return;
  Nearest touch{axis.separation, axis.normal, 0};
  if (axis.separation > 0) {
    touch = nearest(s, hull, radius + margin);
    if (!(touch.distance < radius + margin)) return;
  } else if (axis.edge >= 0) {
    const Polyhedron::Edge& e = hull.edges[std::size_t(axis.edge)];
    const Vec3& from = hull.vertices[e.from];
    touch.t = closest(s, {from, hull.vertices[e.to] - from}).s;
  } else {
    touch.t = dot(axis.normal, s.along) < 0 ? Real(1) : Real(0);
  }
  const Vec3& n = out.normal = touch.normal;

  // The face that the capsule lies on, if it does: the stretch above the face touches in its two ends.
  const Polyhedron::Face* under = nullptr;
  for (const Polyhedron::Face& f : hull.faces) {
    if (dot(f.normal, n) > Real(flat_cosine)) under = &f;
  }
  if (under && square(dot(n, s.along)) < square(Real(flat_sine)) * length_squared(s.along)) {
    Interval<Real> stretch;
    for (std::uint32_t k = 0; k < under->count; ++k) {
      const Vec3& from = hull.vertices[hull.loops[under->first + k]];
      const Vec3& to = hull.vertices[hull.loops[under->first + (k + 1 == under->count ? 0 : k + 1)]];
      const Vec3 side = cross(to - from, n);
      stretch.clip(dot(side, s.start - from), dot(side, s.along));
    }
    if (!stretch.empty()) {
      const Real slope = 1 / dot(under->normal, n);
      std::uint32_t feature = 0;
      for (const Real t : {stretch.low, stretch.high}) {
        const Vec3 p = s.at(t);
        const Real height = (dot(under->normal, p) - under->offset) * slope;
        add(p - n * radius, height - radius, feature++, margin, out);
      }
      if (out.count > 0) return;
    }
  }
  add(s.at(touch.t) - n * radius, touch.distance - radius, end_of(touch.t), margin, out);
}

}
