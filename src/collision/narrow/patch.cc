#include "collision/narrow/patch.h"

#include "collision/narrow/flat.h"

namespace sudar::inline SUDAR_PRECISION {
namespace {

using namespace feature;

// Below this sine the lowest point of a rim has no direction worth following.
constexpr double level = 3e-4;

Patch disc_of(const Convex& body, int cap, const Vec3d& normal, double height, const Vec3d& direction) {
  Patch p;
  p.kind = Patch::disc;
  p.normal = normal;
  p.start = body.at + body.axis() * height;
  p.radius = double(body.geometry->radius);
  const Vec3d lean = direction - normal * dot(normal, direction);
  const bool leans = length_squared(lean) > square(level);
  p.toward = leans ? normalize(lean) : body.turn.c0;
  p.across = cross(normal, p.toward);
  p.id[0] = cap_rim[cap] + (leans ? tilted : 0);
  return p;
}

Patch segment(const Vec3d& start, std::uint32_t start_id, const Vec3d& end, std::uint32_t end_id) {
  Patch p;
  p.kind = Patch::segment;
  p.start = start, p.end = end;
  p.id[0] = start_id, p.id[1] = end_id;
  return p;
}

// The direction at right angles to the axis; any if there is none.
Vec3d outward(const Convex& body, const Vec3d& direction) {
  const Vec3d out = direction - body.axis() * dot(body.axis(), direction);
  return length_squared(out) > 0 ? normalize(out) : body.turn.c0;
}

// The line along the side of a cylinder or cone, or a capsule, that is farthest out.
Patch side_line(const Convex& body, const Vec3d& direction) {
  const Geometry& g = *body.geometry;
  const double half = double(g.half_length), radius = double(g.radius);
  const Vec3d axis = body.axis();
  if (g.kind == ShapeKind::capsule) {
    const Vec3d out = direction * radius;
    return segment(body.at - axis * half + out, capsule_end, body.at + axis * half + out, capsule_end + 1);
  }
  const bool cone = g.kind == ShapeKind::cone;
  const Vec3d out = outward(body, direction) * radius, low = body.at - axis * (cone ? half / 2 : half) + out;
  if (cone) return segment(low, cap_rim[0] + tilted, body.at + axis * (1.5 * half), apex);
  return segment(low, cap_rim[0] + tilted, body.at + axis * half + out, cap_rim[1] + tilted);
}

Patch hull_part(const Convex& body, const Vec3d& direction) {
  const Polyhedron& hull = body.geometry->hull;
  const Vec3d d{dot(body.turn.c0, direction), dot(body.turn.c1, direction), dot(body.turn.c2, direction)};
  Patch p;
  double best = flat_cosine;
  for (const Polyhedron::Face& f : hull.faces) {
    const double cosine = dot(convert<double>(f.normal), d);
    if (cosine > best) best = cosine, p.face = &f;
  }
  if (p.face) {
    p.kind = Patch::polygon;
    p.body = &body;
    p.normal = body.turn * normalize(convert<double>(p.face->normal));
    p.start = body.point(convert<double>(hull.vertices[hull.loops[p.face->first]]));
    return p;
  }
  const Polyhedron::Edge* level_edge = nullptr;
  double highest = -std::numeric_limits<double>::infinity();
  for (const Polyhedron::Edge& e : hull.edges) {
    const Vec3d from = convert<double>(hull.vertices[e.from]), to = convert<double>(hull.vertices[e.to]);
    const double rise = dot(to - from, d), height = dot(from + to, d);
    if (height > highest && square(rise) < square(flat_sine) * length_squared(to - from)) {
      highest = height, level_edge = &e;
    }
  }
  const Vec3d top = body.support(direction);
  p.start = p.end = top;
  if (!level_edge) return p;
  const Vec3d from = body.point(convert<double>(hull.vertices[level_edge->from])),
              to = body.point(convert<double>(hull.vertices[level_edge->to]));
  if (from != top && to != top) return p;  // a level edge, but not at the top
  return segment(from, hull_vertex + level_edge->from, to, hull_vertex + level_edge->to);
}
}

Vec3d Patch::rim(int quarter) const {
  const Vec3d& way = quarter % 2 == 0 ? toward : across;
  return start + way * (quarter < 2 ? radius : -radius);
}

std::uint32_t Patch::feature_at(const Vec3d& place, double thick) const {
  if (kind != segment) return lone;
  if (length_squared(place - start) <= square(thick)) return id[0];
  return length_squared(place - end) <= square(thick) ? id[1] : lone;
}

Patch touching_part(const Convex& body, const Vec3d& direction) {
  const Geometry& g = *body.geometry;
  const double rise = dot(body.axis(), direction), half = double(g.half_length);
  if (g.kind == ShapeKind::hull) return hull_part(body, direction);
  if (g.kind == ShapeKind::cylinder && abs(rise) > flat_cosine) {
    const bool up = rise > 0;
    return disc_of(body, up ? 1 : 0, up ? body.axis() : -body.axis(), up ? half : -half, direction);
  }
  if (g.kind == ShapeKind::cone && rise < -flat_cosine) {
    return disc_of(body, 0, -body.axis(), -0.5 * half, direction);
  }
  const bool has_side = g.kind == ShapeKind::cylinder || g.kind == ShapeKind::cone || g.kind == ShapeKind::capsule;
  if (has_side) return side_line(body, direction);
  Patch p;
  p.start = p.end = body.support(direction) + direction * body.round;
  return p;
}

Vec3d face_across(const Convex& body, const Vec3d& direction) {
  const Patch part = touching_part(body, direction);
  return part.flat() ? part.normal : Vec3d{};
}

}
