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

class Preparation {
 public:
  Preparation(SubStep& s, std::size_t k)
      : s_(s), c_(s.in.contacts[s.island.contacts.first + k]), m_(s.rows[k]), start_(s.starts[k]), push_(s.pushes[k]),
        turn_(s.turns[k]), a_(s.on[s.on.number(c_.a)]), b_(s.on[s.on.number(c_.b)]) {}

  void run() {
    const Manifold manifold = s_.set.one_point_contact ? centre(*c_.manifold) : *c_.manifold;
    m_.a = s_.on.number(c_.a), m_.b = s_.on.number(c_.b);
    m_.contact = std::uint32_t(&c_ - s_.in.contacts.data());
    m_.count = std::uint8_t(manifold.count);
    m_.a_answers = a_.answers(), m_.b_answers = b_.answers();
    m_.slip_y = m_.slip_z = 0;
    m_.resists_turning = c_.material.rolling > 0 || c_.material.spinning > 0;
    start_.restitution = c_.material.restitution;
    start_.friction_static = c_.material.friction_static, start_.friction_dynamic = c_.material.friction_dynamic;
    start_.struck = start_.owes = false;
    const Vec3 n = manifold.normal, t = any_perpendicular(n);
    const Mat3 frame{n, t, cross(n, t)};
    m_.frame = lanes(frame), m_.to_frame = lanes(transpose(frame));
    points(manifold, frame);
    remember(manifold, transpose(frame));
  }

 private:
  void points(const Manifold& manifold, const Mat3& frame) {
    const Bodies& bodies = s_.in.bodies;
    const Vec3 to_shape = rotate(bodies.orientation[c_.a], bodies.shape_frame(c_.shape_a).p);
    const Vec3 apart = bodies.position[c_.a] - bodies.position[c_.b];
    const Vec3 surfaces = bodies.surface_velocity_world(c_.shape_a) - bodies.surface_velocity_world(c_.shape_b);
    const Real4 glide{0, dot(frame.c1, surfaces), dot(frame.c2, surfaces), 0};
    Vec3 middle;
    for (std::size_t k = 0; k < m_.count; ++k) middle += manifold.points[k].at / Real(m_.count);
    m_.ra = lanes(middle + to_shape), m_.rb = lanes(middle + to_shape + apart);
    prepare_response(m_, a_, b_);
    const RelativeMotion motion = motion_of(m_, a_.real, b_.real);
    push_ = {};
    for (std::size_t k = 0; k < m_.count; ++k) {
      const ManifoldPoint& from = manifold.points[k];
      PointRow& p = m_.points[k] = PointRow{};
      ManifoldStart::Point& start = start_.points[k] = {};
      p.at = m_.to_frame * lanes(from.at - middle);
      p.glide = glide;
      prepare_masses(m_, p);
      start.depth = -from.separation;
      start.free_speed = min(Real(0), start.depth / s_.h);
      start.speed = relative_velocity(motion, p)[0];
      s_.fastest = max(s_.fastest, -start.speed);
      // thesis (3.20): a speed
      push_.target[k] = s_.set.correction / s_.h * max(Real(0), start.depth - s_.slop());
      push_.needed |= push_.target[k] > 0;
    }
  }

  // The impulse of the last sub-step, point by feature; friction turned into the new tangent plane.
  void remember(const Manifold& manifold, const Mat3& to_frame) {
    const ContactImpulse& stored = s_.in.contact_state.impulse[c_.slot];
    for (std::size_t k = 0; k < m_.count; ++k) {
      const int match = s_.set.one_point_contact ? 0 : manifold.points[k].match;
      if (match < 0) continue;
      m_.points[k].impulse = to_frame * stored.friction[std::size_t(match)];
      m_.points[k].impulse.x = stored.normal[std::size_t(match)];
    }
    if (!m_.resists_turning) return;
    prepare_turning(turn_, m_);
    turn_.spinning = c_.material.spinning, turn_.rolling = c_.material.rolling;
    turn_.impulse = to_frame * stored.turning;
  }

  SubStep& s_;
  const ActiveContact& c_;
  ManifoldRow& m_;
  ManifoldStart& start_;
  ManifoldPush& push_;
  TurnRow& turn_;
  const SolverBody &a_, &b_;
};

}

void prepare_contacts(SubStep& s) {
  const std::size_t count = s.island.contacts.count;
  s.rows.resize(count), s.starts.resize(count), s.pushes.resize(count), s.turns.resize(count);
  for (std::size_t k = 0; k < count; ++k) Preparation(s, k).run();
}

}
