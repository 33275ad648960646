// soft_step: soft contacts, sub-stepped, contacts found once a step (after E. Catto, "soft step", Solver2D 2024), with
// what keeps them from sinking: impulses leak towards the load that a contact carries (support.h), not towards zero.
//
// One sub-step of length h:
//   restitution (true impacts, before gravity) → forces → warm start → solve (overlap pushes apart, softly) → drift →
//   relax (velocities without that push, friction).
// A contact of frequency f and damping ratio ζ, ω = 2πf, a₁ = 2ζ + hω, a₂ = hω a₁, a₃ = 1/(1 + a₂): bias rate ω/a₁, mass
// scale a₂a₃, impulse scale a₃.
//
// Normals and arms stay as they were when the contact was found; only separations move. The order of solving is that of
// colours (colours.h), which depend on the scene alone, so neither lanes nor workers change a bit.
#pragma once

#include <memory>

#include "dynamics/solve.h"

namespace sudar::inline SUDAR_PRECISION {

// Keeps only memory between steps, no state.
class SoftStepSolver {
 public:
  static constexpr bool detects_each_substep = false;

  SoftStepSolver();
  SoftStepSolver(SoftStepSolver&&) noexcept;
  SoftStepSolver& operator=(SoftStepSolver&&) noexcept;
  ~SoftStepSolver();
  // Advances bodies and impulses by all sub-steps of a step; adds to the outcome.
  void advance(const StepView&, StepOutcome&);

  struct Memory;

 private:
  std::unique_ptr<Memory> memory_;
};

}
