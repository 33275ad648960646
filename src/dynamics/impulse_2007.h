// impulse_2007: the solver of the thesis (M. Tintor 2007, thesis §3), with its mistakes corrected (docs/thesis.md).
// Written to be read beside the thesis. One call is one sub-step of length h, contacts detected, island after island:
//   collisions (N₁ passes, old velocities, true restitution) → external forces → velocities →
//   contacts (N₂ passes, restitution −1 … 0) → positions with real + pseudo velocity.
// Collisions come before the forces, so a resting body never sees a bounce made by gravity: no restitution threshold.
//
// An island knows nothing of the others: all thresholds are its own, and its passes end when it has settled. So its bits
// do not depend on what goes on elsewhere, islands may be solved in any order, and one at a time fits the caches.
#pragma once

#include <memory>

#include "dynamics/solve.h"

namespace sudar::inline SUDAR_PRECISION {

// Keeps only memory between sub-steps, no state.
class Impulse2007Solver {
 public:
  static constexpr bool detects_each_substep = true;  // contacts are looked for again before every sub-step

  Impulse2007Solver();
  Impulse2007Solver(Impulse2007Solver&&) noexcept;
  Impulse2007Solver& operator=(Impulse2007Solver&&) noexcept;
  ~Impulse2007Solver();
  // Makes room for so many bodies, so that the first sub-step costs nothing more.
  void reserve(std::uint32_t slots);
  // Advances bodies and impulses by one sub-step; adds to the outcome.
  void advance(const StepView&, StepOutcome&);

  struct Memory;

 private:
  std::unique_ptr<Memory> memory_;
};

}
