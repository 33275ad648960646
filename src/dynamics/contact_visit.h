// One visit of a contact in the contact passes, and of several contacts at once.
#pragma once

#include <algorithm>

#include "dynamics/contact_rows.h"

namespace sudar::inline SUDAR_PRECISION {

// What does not answer impulses is not written: the next contact on the same floor need not wait for it.
inline void put(SolverBodies& on, const ManifoldRow& m, const Moving& a, const Moving& b) {
  if (m.a_answers) on[m.a].real = a;
  if (m.b_answers) on[m.b].real = b;
}

// An arm of the contact, to compare a turning with a speed, m.
inline Real radius(const ManifoldRow& m) { return min(length(m.points[0].ra), length(m.points[0].rb)); }

// A contact that is being visited, its bodies in registers.
class Holding {
 public:
  Holding(SolverBodies& on, ManifoldRow& m, Real relaxation)
      : on_(on), m_(m), relaxation_(relaxation), whole_(1 / relaxation), a_(on[m.a].real), b_(on[m.b].real) {}
  [[gnu::always_inline]] void point(std::size_t k) {
    PointRow& p = m_.points[k];
    const Vec3 step = answer(p, relative_velocity(a_, b_, m_, p), p.target, relaxation_, m_.friction, p.impulse);
    apply(a_, b_, m_, p, step);
    change_ = max(change_, size(p, step, whole_));
    load_ += p.impulse.x;
  }
  // All points at once by the same impulse, as one in their middle.
  [[gnu::always_inline]] void together() {
    SharedRow& all = m_.shared;
    if (m_.count < 2) return;
    Real least = m_.points[0].impulse.x;
    for (std::size_t k = 1; k < m_.count; ++k) least = min(least, m_.points[k].impulse.x);
    const Real left = all.target - all.row.speed(a_, b_);
    const Real each = max(-least, relaxation_ * left * all.mass);
    for (std::size_t k = 0; k < m_.count; ++k) m_.points[k].impulse.x += each;
    all.row.apply(a_, b_, each * Real(m_.count));
    change_ = max(change_, abs(each) * all.response * whole_);
  }
  std::size_t count() const { return m_.count; }
  Real end() {
    if (m_.resists_turning()) change_ = max(change_, radius(m_) * resist_turning(m_, a_, b_, load_));
    put(on_, m_, a_, b_);
    return change_;
  }

 private:
  SolverBodies& on_;
  ManifoldRow& m_;
  Real relaxation_, whole_;
  Moving a_, b_;
  Real change_ = 0, load_ = 0;
};

// Visits contacts that share no body, point by point in turn: the processor then works on all of them at once. Returns
// the largest change of a relative velocity, unrelaxed, m/s.
template <class... Contacts>
Real hold_together(SolverBodies& on, Real relaxation, Contacts&... contacts) {
  std::array all{Holding(on, contacts, relaxation)...};
  const std::uint32_t most = std::max({contacts.count...});
  // Not in the early passes: a train that begins to pull would wait for its friction.
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
inline Real push(SolverBodies& on, ManifoldRow& m, std::int64_t& visits) {
  Moving &a = on[m.a].push, &b = on[m.b].push;
  Real change = 0;
  for (PointRow& p : m.rows()) {
    if (p.push_target <= 0) continue;
    const Real left = p.push_target - (relative_velocity(a, b, m, p)[0] - p.glide[0]);
    const Real step = max(-p.push, left * p.normal_mass);
    apply(a, b, m, p, {step, 0, 0});
    change = max(change, abs(step) * p.normal_response);
    p.push += step;
    ++visits;
  }
  return change;
}

}
