#include "dynamics/curving.h"

#include "collision/narrow/pairs.h"
#include "dynamics/integrate.h"

namespace sudar::inline SUDAR_PRECISION {

namespace {

// Energy that a contact would lose in a second were its curving left out, as a share: ω²h. Below this it is not worth
// another manifold.
constexpr Real worth = Real(1e-4);

bool flat_sided(const Geometry& g) { return g.kind == ShapeKind::hull || g.kind == ShapeKind::half_space; }

bool curves(const SubStep& s, const ManifoldRow& m) {
  if (s.set.one_point_contact || s.set.friction_per_increment) return false;
  const Moving &a = s.on[m.a].real, &b = s.on[m.b].real;
  Real squared = max(length_squared(vector(a.w)), length_squared(vector(b.w)));
  const Geometry &on_a = *s.in.geometries[m.a], &on_b = *s.in.geometries[m.b];
  if (!flat_sided(on_a) && !flat_sided(on_b)) {  // one glides round the other
    const Real around = min(on_a.bounding_radius, on_b.bounding_radius);
    squared = max(squared, length_squared(vector(a.v - b.v)) / square(around));
  }
  return squared * s.h > worth;
}

// A body in the middle of the sub-step.
struct Halfway {
  Halfway(const SubStep& s, std::uint32_t i) : Halfway(s.bodies.shape_frame[i], ahead(s.bodies, i, s.on[i], s.h / 2)) {}
  Halfway(const Transform& frame, const Ahead& then)
      : center(then.center.p), spin(then.spin), shape{then.center.point(frame.p), then.center.q * frame.q} {}
  Pos center;
  Vec3 spin;
  Pose shape;
};

// The rotation that turns unit vector `from` the shortest way to `to`.
Mat3 shortest_turn(const Vec3& from, const Vec3& to) {
  const Vec3 axis = cross(from, to);
  const Mat3 k = Mat3::skew(axis);
  return Mat3::diagonal({1, 1, 1}) + k + k * k * (1 / (1 + dot(from, to)));
}

// Faces turn with their bodies; what turns farther is another face, or an edge that begins to count. The surface of
// something round turns faster than its body.
bool same_place(const SubStep& s, const ManifoldRow& m, const Vec3& normal) {
  const Real cosine = dot(m.frame.c0, normal);
  if (!flat_sided(*s.in.geometries[m.a]) || !flat_sided(*s.in.geometries[m.b])) return cosine > Real(0.5);
  const Moving &a = s.on[m.a].real, &b = s.on[m.b].real;
  const Real turn = s.h / 2 * (length(vector(a.w)) + length(vector(b.w)));
  return cosine > 0 && length(cross(m.frame.c0, normal)) < Real(1.1) * turn + Real(1e-3);
}

// Sets p.curving, the change of u until the middle of the sub-step, where the manifold's points are still there then.
void measure(const SubStep& s, ManifoldRow& m) {
  const Moving &a = s.on[m.a].real, &b = s.on[m.b].real;
  const Vec3 v = vector(a.v - b.v), spin_a = vector(a.w), spin_b = vector(b.w);
  const Halfway then_a(s, m.a), then_b(s, m.b);
  const Real reach = length(v) + length(spin_a) * length(m.points[0].ra) + length(spin_b) * length(m.points[0].rb);
  AxisCache no_cache;
  Manifold then;
  collide_placed(*s.in.geometries[m.a], then_a.shape, *s.in.geometries[m.b], then_b.shape, s.slop() + s.h * reach,
                 no_cache, then);
  if (then.count == 0 || !same_place(s, m, then.normal)) return;
  const Mat3 frame = shortest_turn(m.frame.c0, then.normal) * m.frame;
  const Manifold& now = *s.in.contacts[m.contact].manifold;
  for (std::size_t k = 0; k < m.count; ++k) {
    PointRow& p = m.points[k];
    for (int n = 0; n < then.count; ++n) {
      const ManifoldPoint& point = then.points[std::size_t(n)];
      if (point.feature != now.points[k].feature) continue;
      const Vec3 ra = point.at + (then_a.shape.p - then_a.center), rb = ra + (then_a.center - then_b.center);
      const Vec3 u_then = v + cross(then_a.spin, ra) - cross(then_b.spin, rb);
      const Vec3 u_now = v + cross(spin_a, p.ra) - cross(spin_b, p.rb);
      p.curving = transpose(frame) * u_then - transpose(m.frame) * u_now;
      if (m.count > 2) p.curving.x = 0;  // a face on a face turns about the normal only
    }
  }
}

}

void look_back(SubStep& s) {
  const Real bounce = Real(0.01) * s.g * s.h;
  for (ManifoldRow& m : s.rows) {
    const auto approaches = [&](const PointRow& p) { return p.impulse.x > 0 && p.start < p.free_speed - bounce; };
    if (std::none_of(m.rows().begin(), m.rows().end(), approaches) || !curves(s, m)) continue;
    measure(s, m);
    for (PointRow& p : m.rows()) {
      if (p.impulse.x <= 0) p.curving.x = 0;
      p.start -= p.curving.x;
      p.glide[0] -= p.curving.x;
    }
  }
}

void look_ahead(SubStep& s) {
  for (ManifoldRow& m : s.rows) {
    for (PointRow& p : m.rows()) p.glide[0] += p.curving.x, p.curving = {};
    if (!curves(s, m)) continue;
    measure(s, m);
    for (PointRow& p : m.rows()) {
      if (p.target > 0) p.curving.x = 0;  // it leaves: nothing holds it to the surface
      p.glide += lanes(p.curving);
    }
    if (m.count > 1) continue;  // which points of a face slide is not determined
    PointRow& p = m.points[0];
    p.slip_y = p.tangent_mass * p.curving.y, p.slip_z = p.tangent_mass * p.curving.z;
  }
}

}
