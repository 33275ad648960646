#include "dynamics/collisions.h"

#include "dynamics/as_written.h"
#include "dynamics/contact_impact.h"

namespace sudar::inline SUDAR_PRECISION {

namespace {

// Where there are joints a contact goes through three states, told by two flags of its ManifoldStart:
//   not struck      it has not collided in this sub-step
//   struck          it has; the velocities that its points then reached are its aims from now on, whoever changed them
//                   but the joints
//   struck, owes    joints were stopped since and took a part of the bounce: it is struck once more towards its aims
// stop_joints() leads from the second to the third, strike() from any to the second.
class Collisions {
 public:
  // Approach slower than a hundredth of gravity's share in a step is what turning arms and the last contact passes left
  // over: the coming contact passes mend it, no impact does.
  explicit Collisions(SubStep& s) : s_(s), least_(Real(0.01) * s.g * s.h + Real(1e-6) * s.fastest) {}

  // Passes until no manifold approaches, thesis (3.15).
  void run() {
    if (s_.rows.empty() && s_.joint_rows.empty()) return;
    for (int pass = 0; pass < s_.set.collision_passes; ++pass) {
      stop_joints();
      const Stopwatch watch(s_.out.collision.microseconds);
      bool approaching = false;
      for (std::size_t k = 0; k < s_.rows.size(); ++k) {
        if (s_.starts[k].owes) strike(k), approaching = true;
      }
      for (std::size_t k = 0; k < s_.rows.size(); ++k) {
        if (!approaches(k)) continue;
        approaching = true;
        if (s_.set.friction_per_increment)
          strike_as_written(k);
        else
          strike(k);
      }
      if (!approaching) break;
      ++s_.out.collision.used;
    }
  }

 private:
  bool approaches(std::size_t number) const {
    const ManifoldRow& m = s_.rows[number];
    const RelativeMotion motion = s_.motion(m);
    bool any = false;
    for (std::size_t k = 0; k < m.count; ++k) {
      any |= relative_velocity(motion, m.points[k])[0] < s_.starts[number].points[k].free_speed - least_;
    }
    return any;
  }

  // Joints take a part of the bounce of bodies that they hold, and the contact owes it: it is struck once more, until
  // hinged bodies part as fast as free ones. What another contact takes is not owed: so a row of balls passes its speed
  // on.
  void stop_joints() {
    if (s_.joint_rows.empty()) return;
    const auto each_struck = [&](auto visit) {
      for (std::size_t n = 0; n < s_.rows.size(); ++n) {
        if (!s_.starts[n].struck) continue;
        const ManifoldRow& m = s_.rows[n];
        const RelativeMotion motion = s_.motion(m);
        for (std::size_t k = 0; k < m.count; ++k) {
          visit(s_.starts[n], s_.starts[n].points[k], relative_velocity(motion, m.points[k])[0]);
        }
      }
    };
    each_struck([&](ManifoldStart&, ManifoldStart::Point& p, Real speed) {
      p.unheld = speed;
      if (abs(speed - p.aim) > Real(1e-3) * s_.fastest) p.aim = speed;
    });
    s_.visit_joints([&](JointSolve& j) { j.stop(s_.on); });
    each_struck([&](ManifoldStart& m, ManifoldStart::Point& p, Real speed) {
      m.owes |= p.unheld - speed > least_ || (p.blow.x > 0 && speed - p.unheld > least_);
    });
  }

  // One impact of a manifold. It sticks if it can: only when the static cone does not hold does it slip, under dynamic
  // friction.
  void strike(std::size_t number) {
    ManifoldStart& start = s_.starts[number];
    std::array<Vec3, 4> blow{};  // what it begins with
    if (start.owes) {
      for (std::size_t k = 0; k < 4; ++k) blow[k] = start.points[k].blow;
    }
    const ManifoldRow& m = s_.rows[number];
    Impact impact(s_.on, m, start, least_);
    const auto again = [&](Real restitution, Real friction) {
      for (std::size_t k = 0; k < 4; ++k) start.points[k].blow = blow[k];
      impact.strike(restitution, friction, s_.out.collision.visits);
    };
    Real friction = start.friction_static;
    again(start.restitution, friction);
    if (impact.slips && start.friction_dynamic != friction) {
      friction = start.friction_dynamic;
      again(start.restitution, friction);
    }
    if (impact.made_energy) again(0, friction);  // friction made energy: take the bounce away instead
    Moving a = s_.on[m.a].real, b = s_.on[m.b].real;
    apply(a, b, s_.on[m.a], s_.on[m.b], m, impact.impulse);
    put(s_.on, m, a, b);
    start.struck = true, start.owes = false;
  }

  void strike_as_written(std::size_t number) {
    const ManifoldRow& m = s_.rows[number];
    ManifoldStart& start = s_.starts[number];
    for (std::size_t k = 0; k < m.count; ++k) {
      start.points[k].hit |= increment_as_written(s_.on, m, start, k, start.restitution) > 0;
    }
    s_.out.collision.visits += m.count;
  }

  SubStep& s_;
  Real least_;  // approach that counts as an impact, m/s
};

}

void strike_contacts(SubStep& s) { Collisions(s).run(); }

}
