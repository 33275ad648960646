// One visit of a contact in the contact passes, and of several contacts at once.
#pragma once

#include <algorithm>

#include "dynamics/contact_rows.h"

namespace sudar::inline SUDAR_PRECISION {

// What does not answer impulses is not written: the next contact on the same floor need not wait for it, and another
// island may be reading it.
inline void put(SolverBodies& on, const ManifoldRow& m, const Moving& a, const Moving& b) {
  if (m.a_answers) on[m.a].real = a;
  if (m.b_answers) on[m.b].real = b;
}

// An arm of the contact, to compare a turning with a speed, m.
inline Real radius(const ManifoldRow& m) { return min(length(vector(m.ra)), length(vector(m.rb))); }

// A contact that is being visited, its motion in registers. `turn` is null where nothing resists turning.
class Holding {
 public:
  Holding(SolverBodies& on, ManifoldRow& m, TurnRow* turn, Real relaxation)
      : on_(on), m_(m), turn_(turn), relaxation_(relaxation), whole_(1 / relaxation),
        motion_(motion_of(m, on[m.a].real, on[m.b].real)) {}
  [[gnu::always_inline]] void point(std::size_t k) {
    PointRow& p = m_.points[k];
    const Vec3 step = project_onto_cone(p, relative_velocity(motion_, p), p.target, relaxation_, m_.friction,
                                        m_.slip_y, m_.slip_z, p.impulse);
    const WrenchImpulse impulse = to_middle(p, step);
    sum_ += impulse;
    if (m_.count > 1) answer(m_, motion_, impulse);
    change_ = max(change_, velocity_change(p, step, whole_));
    load_ += p.impulse.x;
  }
  // All points at once by the same impulse, as one in their middle.
  [[gnu::always_inline]] void together() {
    if (m_.count < 2) return;
    const SharedRow& all = m_.shared;
    Real least = m_.points[0].impulse.x;
    for (std::size_t k = 1; k < m_.count; ++k) least = min(least, m_.points[k].impulse.x);
    const Real each = max(-least, relaxation_ * (all.target - motion_.u[0]) * all.mass);
    for (std::size_t k = 0; k < m_.count; ++k) m_.points[k].impulse.x += each;
    const Real4 whole = broadcast(each * Real(m_.count));
    sum_.force[0] += whole[0];
    motion_.u += m_.u_by_force.c0 * whole;
    motion_.w += m_.w_by_force.c0 * whole;
    change_ = max(change_, abs(each) * all.response * whole_);
  }
  std::size_t count() const { return m_.count; }
  Real end() {
    if (turn_ != nullptr) {
      if (m_.count == 1) answer(m_, motion_, sum_);
      const Vec3 moment = resist_turning(*turn_, motion_, load_);
      sum_.moment += lanes(moment);
      change_ = max(change_, radius(m_) * turn_change(*turn_, moment));
    }
    const SolverBody &on_a = on_[m_.a], &on_b = on_[m_.b];
    Moving a = on_a.real, b = on_b.real;
    apply(a, b, on_a, on_b, m_, sum_);
    put(on_, m_, a, b);
    return change_;
  }

 private:
  SolverBodies& on_;
  ManifoldRow& m_;
  TurnRow* turn_;
  Real relaxation_, whole_;
  RelativeMotion motion_;
  WrenchImpulse sum_;
  Real change_ = 0, load_ = 0;
};

// Visits contacts that share no body, point by point in turn: the processor then works on all of them at once. Returns
// the largest change of a relative velocity, unrelaxed, m/s.
template <std::size_t count>
Real hold_together(std::array<Holding, count> all, Real relaxation) {
  std::size_t most = 0;
  for (const Holding& h : all) most = std::max(most, h.count());
  // Only once the relaxation is mostly over: before, the shared impulse would take the load that a point needs for its
  // friction, and what begins to be pulled along would slip.
  if (relaxation > Real(0.5)) {
    for (Holding& h : all) h.together();
  }
  for (std::size_t k = 0; k < most; ++k) {
    for (Holding& h : all) {
      if (k < h.count()) h.point(k);
    }
  }
  Real change = 0;
  for (Holding& h : all) change = max(change, h.end());
  return change;
}

// One visit in pseudo velocity: overlap beyond the slop is pushed apart. Returns the change of the relative speed, m/s.
inline Real separate(SolverBodies& on, const ManifoldRow& m, ManifoldPush& push, std::int64_t& visits) {
  if (!push.needed) return 0;
  SolverBody &on_a = on[m.a], &on_b = on[m.b];
  RelativeMotion motion = motion_of(m, on_a.push, on_b.push);
  WrenchImpulse sum;
  Real change = 0;
  for (std::size_t k = 0; k < m.count; ++k) {
    if (push.target[k] <= 0) continue;
    const PointRow& p = m.points[k];
    const Real left = push.target[k] - (motion.u + cross(motion.w, p.at))[0];
    const Real step = max(-push.impulse[k], left * p.normal_mass);
    const WrenchImpulse impulse = to_middle(p, {step, 0, 0});
    sum += impulse;
    answer(m, motion, impulse);
    change = max(change, abs(step) * p.normal_response);
    push.impulse[k] += step;
    ++visits;
  }
  Moving a = on_a.push, b = on_b.push;
  apply(a, b, on_a, on_b, m, sum);
  if (m.a_answers) on_a.push = a;
  if (m.b_answers) on_b.push = b;
  return change;
}

}
