// One impact of two bodies at its own moment, by the law of impulse_2007: restitution, static or dynamic friction
// (collisions.h). Neither joints nor other contacts have a say. Friction on slender bodies that spin fast can still
// make some energy; where many impacts come in one step it would add up, so then the impact is without friction and
// bounce.
#pragma once

#include "dynamics/sub_step.h"

namespace sudar::inline SUDAR_PRECISION {

class LoneImpact {
 public:
  // The two touch, where they are, as the contact's manifold says; bodies get their new velocities. Returns how fast
  // its fastest point approached, m/s; 0: none did, and nothing has changed. `step`: the settings of the step, and its
  // state.
  Real strike(const StepView& step, const ActiveContact&);

 private:
  Real strike_as_is(const StepView& step, const ActiveContact&);

  // Memory.
  SolverBodies on_;
  Contacts unknown_;  // what a contact is that was not there before
  std::vector<ManifoldRow> rows_;
  std::vector<ManifoldStart> starts_;
  std::vector<ManifoldPush> pushes_;
  std::vector<TurnRow> turns_;
  std::vector<JointSolve> joints_;
};

}
