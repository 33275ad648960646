// What an impact does to one contact, thesis §3.5, §3.6: all its points at once, with accumulated impulses that live in
// this impact only.
#pragma once

#include "dynamics/contact_rows.h"

namespace sudar::inline SUDAR_PRECISION {

class Impact {
 public:
  // `least`: approach that counts, m/s.
  Impact(const SolverBodies& on, const ManifoldRow& m, ManifoldStart& start, Real least)
      : before_(motion_of(m, on[m.a].real, on[m.b].real)), m_(m), start_(start), least_(least) {}

  // From the velocities that the bodies have. What joints took of its bounce (`owes`) is struck once more, towards the
  // same aims. Counts visits of points.
  void strike(Real restitution, Real friction, std::int64_t& visits) {
    motion_ = before_;
    impulse = {};
    std::array<Vec3, 4> before{};
    for (std::size_t k = 0; k < m_.count; ++k) {
      ManifoldStart::Point& p = start_.points[k];
      before[k] = vector(speed(k));
      if (!start_.owes) p.aim = before[k].x < p.free_speed ? -restitution * before[k].x : p.free_speed;
    }
    pre_share(before);
    constexpr int most = 60;
    for (int repeat = 0; repeat < most; ++repeat) {
      Real change = 0;
      for (std::size_t k = 0; k < m_.count; ++k) {
        const PointRow& p = m_.points[k];
        const Vec3 step =
            project_onto_cone(p, speed(k), start_.points[k].aim, 1, friction, 0, 0, start_.points[k].blow);
        add(p, step);
        change = max(change, velocity_change(p, step, 1));
      }
      visits += m_.count;
      if (change <= Real(0.1) * least_) break;
    }
    conclude(before, friction);
  }

  // The outcome.
  WrenchImpulse impulse;
  bool slips = false;
  bool made_energy = false;  // friction did, which it may not

 private:
  Real4 speed(std::size_t k) const { return relative_velocity(motion_, m_.points[k]); }
  void add(const PointRow& p, const Vec3& step) {
    const WrenchImpulse i = to_middle(p, step);
    impulse += i;
    answer(m_, motion_, i);
  }

  // Points of one face answer nearly alike, and visits need long until the first has shared its load with the others.
  // So where all approach they begin with equal impulses, as large as the mean of their aims asks for: all that a face
  // needs that meets a face squarely.
  void pre_share(const std::array<Vec3, 4>& before) {
    Real asked = 0;
    for (std::size_t k = 0; k < m_.count; ++k) {
      if (before[k].x >= start_.points[k].aim) return;
      asked += start_.points[k].aim - before[k].x;
    }
    const Vec3 each{asked / Real(m_.count) * m_.shared.mass, 0, 0};
    for (std::size_t k = 0; k < m_.count; ++k) {
      add(m_.points[k], each);
      start_.points[k].blow += each;
    }
  }

  void conclude(const std::array<Vec3, 4>& before, Real friction) {
    std::array<Vec3, 4> blow;
    Real work = 0, scale_of_work = 0;  // ½ Σ p·(u⁻ + u⁺), and its size without cancellation
    for (std::size_t k = 0; k < m_.count; ++k) {
      ManifoldStart::Point& p = start_.points[k];
      blow[k] = p.blow;
      work += dot(p.blow, before[k] + vector(speed(k))) * Real(0.5);
      scale_of_work += abs(dot(p.blow, before[k]));
      p.hit |= p.blow.x > 0;
    }
    slips = sudar::slips(std::span<const Vec3>(blow).first(m_.count), friction);
    made_energy = !start_.owes && work > Real(1e-4) * scale_of_work;
  }

  RelativeMotion before_, motion_;
  const ManifoldRow& m_;
  ManifoldStart& start_;
  Real least_;
};

}
