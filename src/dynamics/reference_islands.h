// The islands of a step that soft_step leaves to the reference solver, impulse_2007: those with joints, unless
// they are ball joints in large numbers, bodies that move alone on what does not answer, and free bodies for Runge–Kutta.
// Sub-step by sub-step, their contacts looked at again in each.
#pragma once

#include "collision/narrow/pairs.h"
#include "dynamics/impulse_2007.h"

namespace sudar::inline SUDAR_PRECISION {

// Keeps only memory between steps, no state.
class ReferenceIslands {
 public:
  // Before the step: whose company it is in.
  static void watch_crowds(const StepView&);
  // Whether the island is one of them, in this view.
  static bool belongs(const StepView&, const Island&);

  // Advances them by all sub-steps, and kinematic bodies, too, if it advances anything: returns whether it did.
  bool advance(const StepView&, StepOutcome&);

 private:
  // A contact of the step's view, or what may become one.
  struct Seen {
    static constexpr std::uint32_t nowhere = 0xffffffffu;
    ActiveContact contact;
    std::uint32_t number;  // in the view's contacts
    bool in_view() const { return number != nowhere; }
  };

  void gather(const StepView&);
  void look_again(const StepView&);
  void store_impulses(const StepView&);

  Impulse2007Solver solver_;
  std::vector<Island> islands_;
  std::vector<std::uint32_t> awake_, joints_, smooth_;
  // All pairs of the step's view, island after island, and those of them that touch in the sub-step at work.
  std::vector<Seen> seen_;
  std::vector<PairRow> pairs_;
  Contacts impulses_;                        // by pair
  std::vector<Island::Part> pairs_of_;       // by island
  std::vector<ActiveContact> contacts_;
  std::vector<std::uint32_t> number_;        // in the view
  std::vector<const Geometry*> geometries_;  // of a pair's two shapes
  std::vector<Pose> poses_;
};

}
