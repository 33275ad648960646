#include "dynamics/collisions.h"

#include "dynamics/as_written.h"
#include "dynamics/contact_impact.h"

namespace sudar::inline SUDAR_PRECISION {

namespace {

class Collisions {
 public:
  // Approach slower than a hundredth of gravity's share in a step is what turning arms and the last contact passes left
  // over: the coming contact passes mend it, no impact does.
  explicit Collisions(SubStep& s) : s_(s), least_(Real(0.01) * s.g * s.h + Real(1e-6) * s.fastest) {}

  // Passes until no manifold approaches, thesis (3.15).
  void run() {
    for (int pass = 0; pass < s_.set.collision_passes; ++pass) {
      stop_joints();
      const Stopwatch watch(s_.report.collision.microseconds);
      bool approaching = false;
      for (ManifoldRow& m : s_.rows) {
        if (m.owes) strike(m), approaching = true;
      }
      for (ManifoldRow& m : s_.rows) {
        if (!approaches(m)) continue;
        approaching = true;
        if (s_.set.friction_per_increment)
          strike_as_written(m);
        else
          strike(m);
      }
      if (!approaching) break;
      ++s_.report.collision.used;
    }
  }

 private:
  bool approaches(const ManifoldRow& m) const {
    const Moving &a = s_.on[m.a].real, &b = s_.on[m.b].real;
    bool any = false;
    for (const PointRow& p : m.rows()) any |= relative_velocity(a, b, m, p)[0] < p.free_speed - least_;
    return any;
  }

  // Joints take a part of the bounce of bodies that they hold, and the contact owes it: it is struck once more, until
  // hinged bodies part as fast as free ones. What another contact takes is not owed: so a row of balls passes its speed
  // on.
  void stop_joints() {
    if (s_.joint_rows.empty()) return;
    const auto each_struck = [&](auto visit) {
      for (ManifoldRow& m : s_.rows) {
        if (!m.struck) continue;
        const Moving &a = s_.on[m.a].real, &b = s_.on[m.b].real;
        for (PointRow& p : m.rows()) visit(m, p, relative_velocity(a, b, m, p)[0]);
      }
    };
    each_struck([&](ManifoldRow&, PointRow& p, Real speed) {
      p.unheld = speed;
      if (abs(speed - p.aim) > Real(1e-3) * s_.fastest) p.aim = speed;
    });
    s_.visit_joints([&](JointSolve& j) { j.stop(s_.on); });
    each_struck([&](ManifoldRow& m, PointRow& p, Real speed) {
      m.owes |= p.unheld - speed > least_ || (p.blow.x > 0 && speed - p.unheld > least_);
    });
  }

  // One impact of a manifold: all its points at once, with accumulated impulses that live in this impact only.
  void strike(ManifoldRow& m) {
    const Moving a0 = s_.on[m.a].real, b0 = s_.on[m.b].real;
    Moving a = a0, b = b0;
    std::array<Vec3, 4> blow{};
    if (m.owes) {
      for (std::size_t k = 0; k < m.count; ++k) blow[k] = m.points[k].blow;
    }
    const auto again = [&](Real restitution, Real friction) {
      a = a0, b = b0;
      for (std::size_t k = 0; k < m.count; ++k) m.points[k].blow = blow[k];
      return impact(m, a, b, restitution, friction, least_, s_.report.collision.visits);
    };
    // It sticks if it can: only when the static cone does not hold does it slip, under dynamic friction.
    Real friction = m.material.friction_static;
    Impact outcome = again(m.material.restitution, friction);
    if (outcome.slips && m.material.friction_dynamic != friction) {
      friction = m.material.friction_dynamic;
      outcome = again(m.material.restitution, friction);
    }
    if (outcome.made_energy) outcome = again(0, friction);  // friction made energy: take the bounce away instead
    put(s_.on, m, a, b);
    m.struck = true, m.owes = false;
  }

  void strike_as_written(ManifoldRow& m) {
    for (PointRow& p : m.rows()) p.hit |= increment_as_written(s_.on, m, p, m.material.restitution) > 0;
    s_.report.collision.visits += m.count;
  }

  SubStep& s_;
  Real least_;  // approach that counts as an impact, m/s
};

}

void collide(SubStep& s) { Collisions(s).run(); }

}
