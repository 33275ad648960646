#include "dynamics/contact_prepare.h"

namespace sudar::inline SUDAR_PRECISION {

namespace {

// thesis §3.9's contact: one point, the centre of the overlap. It carries no moment, so no tower stands on it.
Manifold centre(const Manifold& m) {
  Manifold one;
  one.normal = m.normal;
  one.count = 1;
  one.points[0].separation = m.points[0].separation;
  for (int k = 0; k < m.count; ++k) {
    one.points[0].at += m.points[std::size_t(k)].at / Real(m.count);
    one.points[0].separation = min(one.points[0].separation, m.points[std::size_t(k)].separation);
  }
  return one;
}

// The impulse of the last sub-step, point by feature; friction turned into the new tangent plane.
void remember(const SubStep& s, const ContactImpulse& stored, const Manifold& manifold, ManifoldRow& m) {
  const Mat3 to_frame = transpose(m.frame);
  for (std::size_t k = 0; k < m.count; ++k) {
    const int match = s.set.one_point_contact ? 0 : manifold.points[k].match;
    if (match < 0) continue;
    m.points[k].impulse = to_frame * stored.friction[std::size_t(match)];
    m.points[k].impulse.x = stored.normal[std::size_t(match)];
  }
  if (m.resists_turning()) m.turn.impulse = to_frame * stored.turning;
}

void prepare(SubStep& s, std::uint32_t contact, ManifoldRow& m) {
  const ActiveContact& c = s.in.contacts[contact];
  const Manifold manifold = s.set.one_point_contact ? centre(*c.manifold) : *c.manifold;
  m.a = c.a, m.b = c.b;
  m.contact = contact;
  m.count = std::uint32_t(manifold.count);
  m.material = c.material;
  m.struck = m.owes = false;
  const Vec3 n = manifold.normal, t = any_perpendicular(n);
  m.frame = {n, t, cross(n, t)};
  const Mat3 to_frame = transpose(m.frame);
  const SolverBody &a = s.on[c.a], &b = s.on[c.b];
  m.to_frame = lanes(to_frame);
  m.mass_a = lanes(m.frame * a.inverse_mass);
  m.mass_b = lanes(m.frame * b.inverse_mass);
  m.a_answers = a.inverse_mass > 0, m.b_answers = b.inverse_mass > 0;
  if (m.resists_turning()) prepare_turning(m.turn, m.frame, a, b);
  const Vec3 to_shape = rotate(s.bodies.orientation[c.a], s.bodies.shape_frame[c.a].p);
  const Vec3 apart = s.bodies.position[c.a] - s.bodies.position[c.b];
  const Vec3 surfaces = s.bodies.surface_velocity_world(c.a) - s.bodies.surface_velocity_world(c.b);
  const Real4 glide{0, dot(m.frame.c1, surfaces), dot(m.frame.c2, surfaces), 0};
  for (std::size_t k = 0; k < m.count; ++k) {
    const ManifoldPoint& from = manifold.points[k];
    PointRow& p = m.points[k] = PointRow{};
    p.glide = glide;
    p.ra = from.at + to_shape;
    p.rb = p.ra + apart;
    prepare_masses(p, to_frame, a, b);
    const Real depth = -from.separation;
    p.free_speed = min(Real(0), depth / s.h);
    p.start = relative_velocity(a.real, b.real, m, p)[0];
    s.fastest = max(s.fastest, -p.start);
    p.push_target = s.set.correction / s.h * max(Real(0), depth - s.slop());  // thesis (3.20): a speed
  }
  prepare_shared(m, a, b);
  remember(s, s.contacts.impulse[c.slot], manifold, m);
}

}

void prepare_contacts(SubStep& s) {
  s.rows.resize(s.in.contacts.size());
  for (std::uint32_t k = 0; k < s.rows.size(); ++k) prepare(s, k, s.rows[k]);
}

}
