#include "collision/narrow/overlay.h"

#include "collision/narrow/closest.h"
#include "collision/narrow/flat.h"

namespace sudar::inline SUDAR_PRECISION {
namespace {

using namespace feature;

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

// Keeps where |x + t·along| ≤ radius.
void clip_round(Interval<double>& t, const Vec3d& x, const Vec3d& along, double radius) {
  const double full = length_squared(along), middle = -dot(x, along) / full;
  const double half_chord = square(radius) - length_squared(x + along * middle);
  if (!(half_chord > 0)) {
    t.high = -1;
    return;
  }
  t.low = max(t.low, middle - sqrt(half_chord / full));
  t.high = min(t.high, middle + sqrt(half_chord / full));
}

class Overlayer {
 public:
  Overlayer(const Overlay& how, bool first_is_a, SmallArray<ManifoldPoint, 64>& out)
      : how_(how), first_is_a_(first_is_a), out_(out) {}

  void segment_flat(const Patch& line, const Patch& flat) {
    const Vec3d start = onto(flat, line.start, how_.normal), along = onto(flat, line.end, how_.normal) - start;
    Interval<double> t;
    if (flat.kind == Patch::disc) {
      clip_round(t, start - flat.start, along, flat.radius);
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
    Interval<double> t;
    t.low = max(0.0, min(base, base + slope));
    t.high = min(1.0, max(base, base + slope));
    if (!((t.high - t.low) * sqrt(full) > how_.thick)) return;
    int end = 0;
    for (const double k : {t.low, t.high}) {
      const Vec3d on_p = p.start + along * k, on_q = q.start + other * ((k - base) / slope);
      const std::uint32_t feature = p.id[end++];
      // Where lines that cross at a small angle have left each other they no longer touch.
      const Vec3d aside = on_p - on_q - how_.normal * dot(how_.normal, on_p - on_q);
      if (length_squared(aside) < square(100 * how_.thick)) put(on_p, on_q, feature);
    }
  }

  void disc_polygon(const Patch& disc, const Patch& polygon) {
    rims_inside(disc, polygon, 0);
    each_side(polygon, [&](std::uint32_t k, const Corner& from, const Corner& to, const Vec3d&) {
      const Vec3d x = onto(disc, from.at, how_.normal), along = onto(disc, to.at, how_.normal) - x;
      if (inside(disc, x, 0)) put(x, from.at, hull_vertex + from.vertex);
      Interval<double> t;
      clip_round(t, x - disc.start, along, disc.radius);
      if (t.empty()) return;
      const std::uint32_t id = crossing | (polygon.face->first + k) << 1;
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
    std::uint32_t id = crossing;
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
