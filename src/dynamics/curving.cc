#include "dynamics/curving.h"

#include "collision/narrow/pairs.h"
#include "dynamics/integrate.h"

namespace sudar::inline SUDAR_PRECISION {

namespace {

// Energy that a contact would lose in a second were its curving left out, as a share: ω²h. Below this it is not worth
// another manifold.
constexpr Real worth = Real(1e-4);

// What turns farther in a sub-step on something flat, rad, stands on another point in its middle than at its beginning.
constexpr Real most_turn = Real(1.3);

bool flat_sided(const Geometry& g) {
  return g.kind == ShapeKind::hull || g.kind == ShapeKind::half_space || g.kind == ShapeKind::mesh;
}

bool curves(const SubStep& s, const ManifoldRow& m) {
  if (s.set.one_point_contact || s.set.friction_per_increment) return false;
  const Moving &a = s.on[m.a].real, &b = s.on[m.b].real;
  const ActiveContact& c = s.contact(m);
  const Real turning = max(length_squared(vector(a.w)), length_squared(vector(b.w)));
  const Geometry &on_a = *s.in.geometries[c.shape_a], &on_b = *s.in.geometries[c.shape_b];
  if (flat_sided(on_a) || flat_sided(on_b)) return turning * s.h > worth && turning * square(s.h) < square(most_turn);
  // One glides round the other.
  const Real around = min(on_a.bounding_radius, on_b.bounding_radius);
  return max(turning, length_squared(vector(a.v - b.v)) / square(around)) * s.h > worth;
}

// A body and one of its shapes in the middle of the sub-step.
struct Halfway {
  Halfway(const SubStep& s, std::uint32_t slot, std::uint32_t of_shape, std::uint32_t number)
      : Halfway(s.in.bodies.shape_frame(of_shape), ahead(s.in.bodies, slot, s.on[number], s.h / 2)) {}
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
  const ActiveContact& c = s.contact(m);
  const Vec3 before = vector(m.frame.c0);
  const Real cosine = dot(before, normal);
  if (!flat_sided(*s.in.geometries[c.shape_a]) || !flat_sided(*s.in.geometries[c.shape_b])) return cosine > Real(0.5);
  const Moving &a = s.on[m.a].real, &b = s.on[m.b].real;
  const Real turn = s.h / 2 * (length(vector(a.w)) + length(vector(b.w)));
  return cosine > 0 && length(cross(before, normal)) < Real(1.1) * turn + Real(1e-3);
}

// Sets `curving`, the change of u until the middle of the sub-step, where the manifold's points are still there then.
void measure(const SubStep& s, const ManifoldRow& m, ManifoldStart& start) {
  const ActiveContact& c = s.contact(m);
  const Moving &a = s.on[m.a].real, &b = s.on[m.b].real;
  const Vec3 v = vector(a.v - b.v), spin_a = vector(a.w), spin_b = vector(b.w);
  const auto arm = [&](const Real4& middle, const PointRow& p) { return vector(middle + m.frame * p.at); };
  const Halfway then_a(s, c.a, c.shape_a, m.a), then_b(s, c.b, c.shape_b, m.b);
  const Real reach = length(v) + length(spin_a) * length(arm(m.ra, m.points[0])) +
                     length(spin_b) * length(arm(m.rb, m.points[0]));
  AxisCache no_cache;
  Manifold then;
  collide_placed(*s.in.geometries[c.shape_a], then_a.shape, *s.in.geometries[c.shape_b], then_b.shape, c.part,
                 s.slop() + s.h * reach, no_cache, then);
  if (then.count == 0 || !same_place(s, m, then.normal)) return;
  const Mat3 frame = matrix(m.frame), to_frame_then = transpose(shortest_turn(frame.c0, then.normal) * frame);
  for (std::size_t k = 0; k < m.count; ++k) {
    const PointRow& p = m.points[k];
    for (int n = 0; n < then.count; ++n) {
      const ManifoldPoint& point = then.points[std::size_t(n)];
      if (point.feature != c.manifold->points[k].feature) continue;
      const Vec3 ra = point.at + (then_a.shape.p - then_a.center), rb = ra + (then_a.center - then_b.center);
      const Vec3 u_then = v + cross(then_a.spin, ra) - cross(then_b.spin, rb);
      const Vec3 u_now = v + cross(spin_a, arm(m.ra, p)) - cross(spin_b, arm(m.rb, p));
      Vec3& curving = start.points[k].curving;
      curving = to_frame_then * u_then - transpose(frame) * u_now;
      if (m.count > 2) curving.x = 0;  // a face on a face turns about the normal only
    }
  }
}

}

void look_back(SubStep& s) {
  const Real bounce = Real(0.01) * s.g * s.h;
  for (std::size_t n = 0; n < s.rows.size(); ++n) {
    ManifoldRow& m = s.rows[n];
    ManifoldStart& start = s.starts[n];
    bool approaches = false;
    for (std::size_t k = 0; k < m.count; ++k) {
      const ManifoldStart::Point& p = start.points[k];
      approaches |= m.points[k].impulse.x > 0 && p.speed < p.free_speed - bounce;
    }
    if (!approaches || !curves(s, m)) continue;
    measure(s, m, start);
    for (std::size_t k = 0; k < m.count; ++k) {
      Vec3& curving = start.points[k].curving;
      if (m.points[k].impulse.x <= 0) curving.x = 0;
      start.points[k].speed -= curving.x;
      m.points[k].glide[0] -= curving.x;
    }
  }
}

void look_ahead(SubStep& s) {
  for (std::size_t n = 0; n < s.rows.size(); ++n) {
    ManifoldRow& m = s.rows[n];
    ManifoldStart& start = s.starts[n];
    for (std::size_t k = 0; k < m.count; ++k) {
      Vec3& curving = start.points[k].curving;
      m.points[k].glide[0] += curving.x;
      curving = {};
    }
    if (!curves(s, m)) continue;
    measure(s, m, start);
    for (std::size_t k = 0; k < m.count; ++k) {
      Vec3& curving = start.points[k].curving;
      if (m.points[k].target > 0) curving.x = 0;  // it leaves: nothing holds it to the surface
      m.points[k].glide += lanes(curving);
    }
    if (m.count > 1) continue;  // which points of a face slide is not determined
    const Vec3& curving = start.points[0].curving;
    m.slip_y = m.points[0].tangent_mass * curving.y, m.slip_z = m.points[0].tangent_mass * curving.z;
  }
}

}
