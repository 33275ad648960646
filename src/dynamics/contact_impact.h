// What an impact does to one contact, thesis §3.5, §3.6: all its points at once, with accumulated impulses that live in
// this impact only.
#pragma once

#include "dynamics/contact_rows.h"

namespace sudar::inline SUDAR_PRECISION {

// Points of one face answer nearly alike, and visits need long until the first has shared its load with the others. So
// where all approach they begin with equal impulses, as large as the mean of their aims asks for: all that a face needs
// that meets a face squarely.
inline void share(ManifoldRow& m, Moving& a, Moving& b, const std::array<Vec3, 4>& before) {
  Real asked = 0, answered = 0;
  Moving tried_a = a, tried_b = b;
  const Vec3 trial{m.points[0].normal_mass, 0, 0};
  for (std::size_t k = 0; k < m.count; ++k) {
    if (before[k].x >= m.points[k].aim) return;
    asked += m.points[k].aim - before[k].x;
    apply(tried_a, tried_b, m, m.points[k], trial);
  }
  for (std::size_t k = 0; k < m.count; ++k) {
    answered += relative_velocity(tried_a, tried_b, m, m.points[k])[0] - before[k].x;
  }
  const Vec3 each = trial * (asked / answered);
  for (PointRow& p : m.rows()) apply(a, b, m, p, each), p.blow += each;
}

struct Impact {
  bool slips = false, made_energy = false;
};
inline Impact impact(ManifoldRow& m, Moving& a, Moving& b, Real restitution, Real friction, Real least,
                     std::int64_t& visits) {
  std::array<Vec3, 4> before{};
  for (std::size_t k = 0; k < m.count; ++k) {
    PointRow& p = m.points[k];
    before[k] = vector(relative_velocity(a, b, m, p));
    const Real un = before[k].x;
    if (!m.owes) p.aim = un < p.free_speed ? -restitution * un : p.free_speed;
  }
  share(m, a, b, before);
  constexpr int most = 60;
  for (int repeat = 0; repeat < most; ++repeat) {
    Real change = 0;
    for (PointRow& p : m.rows()) {
      const Vec3 step = answer(p, relative_velocity(a, b, m, p), p.aim, 1, friction, p.blow);
      apply(a, b, m, p, step);
      change = max(change, size(p, step, 1));
    }
    visits += m.count;
    if (change <= Real(0.1) * least) break;
  }
  Impact outcome;
  std::array<Vec3, 4> blow;
  Real work = 0, scale_of_work = 0;  // ½ Σ p·(u⁻ + u⁺), and its size without cancellation
  for (std::size_t k = 0; k < m.count; ++k) {
    PointRow& p = m.points[k];
    blow[k] = p.blow;
    work += dot(p.blow, before[k] + vector(relative_velocity(a, b, m, p))) * Real(0.5);
    scale_of_work += abs(dot(p.blow, before[k]));
    p.hit |= p.blow.x > 0;
  }
  outcome.slips = slips(std::span<const Vec3>(blow).first(m.count), friction);
  outcome.made_energy = !m.owes && work > Real(1e-4) * scale_of_work;
  return outcome;
}

}
