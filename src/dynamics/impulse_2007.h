// impulse_2007: the solver of the thesis (M. Tintor 2007, thesis §3), with its mistakes corrected (docs/thesis.md). One thread,
// written to be read beside the thesis. One call is one sub-step of length h, contacts detected:
//   collisions (N₁ passes, old velocities, true restitution) → external forces → velocities →
//   contacts (N₂ passes, restitution −1 … 0) → positions with real + pseudo velocity.
// Collisions come before the forces, so a resting body never sees a bounce made by gravity: no restitution threshold.
#pragma once

#include "dynamics/solve.h"

namespace sudar::inline SUDAR_PRECISION {

// Keeps only memory between sub-steps, no state.
class Impulse2007Solver {
 public:
  Impulse2007Solver();
  Impulse2007Solver(Impulse2007Solver&&) noexcept;
  Impulse2007Solver& operator=(Impulse2007Solver&&) noexcept;
  ~Impulse2007Solver();
  // Advances bodies and impulses by one sub-step.
  void sub_step(const SolveInput&, Bodies&, Joints&, Contacts&, SolveReport&);

  struct Memory;

 private:
  std::unique_ptr<Memory> memory_;
};

}
