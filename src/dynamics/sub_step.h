// What the phases of a sub-step of impulse_2007 share.
#pragma once

#include "base/timer.h"
#include "dynamics/contact_visit.h"
#include "dynamics/joint_solve.h"
#include "dynamics/solve.h"

namespace sudar::inline SUDAR_PRECISION {

struct SubStep {
  const SolveInput& in;
  const Impulse2007& set;
  Bodies& bodies;
  Joints& joints;
  Contacts& contacts;
  SolveReport& report;
  SolverBodies& on;
  std::vector<ManifoldRow>& rows;       // by contact of the input
  std::vector<JointSolve>& joint_rows;  // by joint of the input
  Real h = in.h;                        // s
  Real g = length(gravity(in.forces));  // m/s²
  Real fastest = 0;                     // approach at the start, m/s

  Real slop() const { return set.slop * in.config.length_unit; }

  // Every joint that needs visits.
  template <class Visit>
  void visit_joints(Visit visit) {
    if (joint_rows.empty()) return;
    const Stopwatch watch(report.joint.microseconds);
    ++report.joint.used;
    for (JointSolve& j : joint_rows) {
      if (j.free) continue;
      visit(j);
      ++report.joint.visits;
    }
  }
};

}
