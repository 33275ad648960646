#include "collision/narrow/patch.h"

namespace sudar::inline SUDAR_PRECISION {
namespace {

constexpr double flat_sine = 0.05, flat_cosine = 0.99875;  // 2.9°
// Below this sine the lowest point of a rim has no direction worth following.
constexpr double level = 3e-4;

// Feature numbers. Of a rim: four that keep their places and four from the lowest on, on the lower and the upper cap.
constexpr std::uint32_t cap_rim[2] = {0, 8}, tilted = 4, apex = 16, capsule_end = 24, hull_vertex = 32, of_other = 64,
                        edge_crossing = 1u << 30;

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

// Along the normal onto the plane of a flat patch.
Vec3d onto(const Patch& flat, const Vec3d& x, const Vec3d& normal) {
  return x + normal * (dot(flat.normal, flat.start - x) / dot(flat.normal, normal));
}

struct Corner {
  Vec3d at;
  std::uint32_t vertex;
};
Corner corner(const Patch& polygon, std::uint32_t k) {
  const Polyhedron& hull = polygon.body->geometry->hull;
  const std::uint32_t vertex = hull.loops[polygon.face->first + k % polygon.face->count];
  return {polygon.body->point(convert<double>(hull.vertices[vertex])), vertex};
}

// visit(corner, next corner, outward unit normal of the side between)
template <class Visit>
void each_side(const Patch& polygon, Visit visit) {
  Corner from = corner(polygon, 0);
  for (std::uint32_t k = 0; k < polygon.face->count; ++k) {
    const Corner to = corner(polygon, k + 1);
    visit(k, from, to, normalize(cross(to.at - from.at, polygon.normal)));
    from = to;
  }
}

// Of a point in the plane of the patch.
bool inside(const Patch& flat, const Vec3d& x, double thick) {
  if (flat.kind == Patch::disc) return length_squared(x - flat.start) <= square(flat.radius + thick);
  bool in = true;
  each_side(flat, [&](std::uint32_t, const Corner& from, const Corner&, const Vec3d& out) {
    in &= dot(out, x - from.at) <= thick;
  });
  return in;
}

struct Interval {
  double low = 0, high = 1;
  // Keeps where base + slope·t ≤ 0.
  void clip(double base, double slope) {
    if (slope > 0) high = min(high, -base / slope);
    if (slope < 0) low = max(low, -base / slope);
    if (slope == 0 && base > 0) high = -1;
  }
  // Keeps where |x + t·along| ≤ radius.
  void clip_round(const Vec3d& x, const Vec3d& along, double radius) {
    const double full = length_squared(along), middle = -dot(x, along) / full;
    const double half_chord = square(radius) - length_squared(x + along * middle);
    if (!(half_chord > 0)) {
      high = -1;
      return;
    }
    low = max(low, middle - sqrt(half_chord / full));
    high = min(high, middle + sqrt(half_chord / full));
  }
};

class Overlayer {
 public:
  Overlayer(const Overlay& how, bool first_is_a, SmallArray<ManifoldPoint, 64>& out)
      : how_(how), first_is_a_(first_is_a), out_(out) {}

  void segment_flat(const Patch& line, const Patch& flat) {
    const Vec3d start = onto(flat, line.start, how_.normal), along = onto(flat, line.end, how_.normal) - start;
    Interval t;
    if (flat.kind == Patch::disc) {
      t.clip_round(start - flat.start, along, flat.radius);
    } else {
      each_side(flat, [&](std::uint32_t, const Corner& from, const Corner&, const Vec3d& out) {
        t.clip(dot(out, start - from.at), dot(out, along));
      });
    }
    if (!((t.high - t.low) * length(along) > how_.thick)) return;
    int end = 0;
    for (const double k : {t.low, t.high}) {
      put(line.start + (line.end - line.start) * k, start + along * k, line.id[end++]);
    }
  }

  void segments(const Patch& p, const Patch& q) {
    const Vec3d along = p.end - p.start, other = q.end - q.start;
    const double full = length_squared(along);
    if (!(length_squared(cross(along, other)) < square(flat_sine) * full * length_squared(other))) return;
    const double base = dot(q.start - p.start, along) / full, slope = dot(other, along) / full;
    Interval t;
    t.low = max(0.0, min(base, base + slope));
    t.high = min(1.0, max(base, base + slope));
    if (!((t.high - t.low) * sqrt(full) > how_.thick)) return;
    int end = 0;
    for (const double k : {t.low, t.high}) {
      put(p.start + along * k, q.start + other * ((k - base) / slope), p.id[end++]);
    }
  }

  void disc_polygon(const Patch& disc, const Patch& polygon) {
    rims_inside(disc, polygon, 0);
    each_side(polygon, [&](std::uint32_t k, const Corner& from, const Corner& to, const Vec3d&) {
      const Vec3d x = onto(disc, from.at, how_.normal), along = onto(disc, to.at, how_.normal) - x;
      if (inside(disc, x, 0)) put(x, from.at, hull_vertex + from.vertex);
      Interval t;
      t.clip_round(x - disc.start, along, disc.radius);
      if (!(t.low < t.high)) return;
      const std::uint32_t id = edge_crossing | (polygon.face->first + k) << 1;
      if (t.low > 0) put(x + along * t.low, from.at + (to.at - from.at) * t.low, id);
      if (t.high < 1) put(x + along * t.high, from.at + (to.at - from.at) * t.high, id | 1);
    });
  }

  // The lens of two circles: rim points of either inside the other, and its two tips.
  void discs(const Patch& p, const Patch& q) {
    const Vec3d centre = onto(p, q.start, how_.normal), between = centre - p.start;
    const double d = length(between);
    const bool p_inside = d + p.radius <= q.radius + how_.thick;
    rims_inside(p, q, 0);
    if (p_inside) return;
    Overlayer(how_, !first_is_a_, out_).rims_inside(q, p, of_other);
    const double foot = (d * d + p.radius * p.radius - q.radius * q.radius) / (2 * d);
    const double half_chord = square(p.radius) - square(foot);
    if (!(d > how_.thick && half_chord > 0)) return;
    const Vec3d middle = p.start + between * (foot / d), tip = cross(p.normal, between) * (sqrt(half_chord) / d);
    std::uint32_t id = edge_crossing;
    for (const Vec3d& x : {middle + tip, middle - tip}) put(x, onto(q, x, how_.normal), id++);
  }

 private:
  // Points of the two surfaces over each other.
  void put(const Vec3d& on_first, const Vec3d& on_second, std::uint32_t feature) {
    const Vec3d &a = first_is_a_ ? on_first : on_second, &b = first_is_a_ ? on_second : on_first;
    const double separation = dot(how_.normal, a - b);
    if (!(separation < how_.margin)) return;
    out_.push({convert<Real>(a * how_.share + b * (1 - how_.share)), Real(separation), feature});
  }

  void rims_inside(const Patch& disc, const Patch& flat, std::uint32_t shift) {
    for (int k = 0; k < 4; ++k) {
      const Vec3d x = disc.rim(k), over = onto(flat, x, how_.normal);
      if (inside(flat, over, how_.thick)) put(x, over, disc.id[0] + std::uint32_t(k) + shift);
    }
  }

  const Overlay& how_;
  bool first_is_a_;
  SmallArray<ManifoldPoint, 64>& out_;
};

}

Vec3d Patch::rim(int quarter) const {
  const Vec3d& way = quarter % 2 == 0 ? toward : across;
  return start + way * (quarter < 2 ? radius : -radius);
}

std::uint32_t Patch::feature_at(const Vec3d& place, double thick) const {
  if (kind != segment) return lone_point;
  if (length_squared(place - start) <= square(thick)) return id[0];
  return length_squared(place - end) <= square(thick) ? id[1] : lone_point;
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

std::size_t most_points(const Patch& a, const Patch& b) {
  std::size_t corners = 10;  // of two discs
  for (const Patch* p : {&a, &b}) {
    if (p->kind == Patch::polygon) corners += 3 * p->face->count;
  }
  return corners;
}

void overlay(const Patch& a, const Patch& b, const Overlay& how, SmallArray<ManifoldPoint, 64>& out) {
  const bool swap = a.kind > b.kind;
  const Patch &p = swap ? b : a, &q = swap ? a : b;  // p's kind is not after q's
  Overlayer o(how, !swap, out);
  if (p.kind == Patch::point) return;
  if (p.kind == Patch::segment) {
    if (q.kind == Patch::segment)
      o.segments(p, q);
    else
      o.segment_flat(p, q);
  } else if (p.kind == Patch::polygon) {
    if (q.kind == Patch::disc) Overlayer(how, swap, out).disc_polygon(q, p);
  } else {
    o.discs(p, q);
  }
}

}
