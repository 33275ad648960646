// What the phases of a sub-step of impulse_2007 share: one island at work.
#pragma once

#include "base/timer.h"
#include "dynamics/contact_visit.h"
#include "dynamics/joint_solve.h"
#include "dynamics/solve.h"

namespace sudar::inline SUDAR_PRECISION {

struct SubStep {
  const StepView& in;
  const Island& island;
  const Impulse2007& set;
  SolverBodies& on;
  StepOutcome& out;
  // By contact of the island; by joint of the island.
  std::vector<ManifoldRow>& rows;
  std::vector<ManifoldStart>& starts;
  std::vector<ManifoldPush>& pushes;
  std::vector<TurnRow>& turns;
  std::vector<JointSolve>& joint_rows;
  Real h = in.h;                        // s
  Real g = length(gravity(in.forces));  // m/s²
  Real fastest = 0;                     // approach at the start, m/s

  Real slop() const { return set.slop * in.config.length_unit; }
  const ActiveContact& contact(const ManifoldRow& m) const { return in.contacts[m.contact]; }
  RelativeMotion motion(const ManifoldRow& m) const { return motion_of(m, on[m.a].real, on[m.b].real); }
  TurnRow* turn(std::size_t k) { return rows[k].resists_turning ? &turns[k] : nullptr; }

  // Every joint that needs visits.
  template <class Visit>
  void visit_joints(Visit visit) {
    if (joint_rows.empty()) return;
    const Stopwatch watch(out.joint.microseconds);
    ++out.joint.used;
    for (JointSolve& j : joint_rows) {
      if (j.exact) continue;
      visit(j);
      ++out.joint.visits;
    }
  }
};

}
