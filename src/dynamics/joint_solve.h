// One joint in one sub-step of an impulse solver: its rows as a block, p = K⁻¹(−u), thesis (3.14), (3.23), and the bounded rows of
// its limit and drive. Impulses act on a; b gets the opposite.
#pragma once

#include "dynamics/joints.h"

namespace sudar::inline SUDAR_PRECISION {

// How joints are pulled back together.
struct JointPull {
  Real rate;         // share of the error per second, 1/s
  bool in_velocity;  // in the real velocity, else in the pseudo velocity
};

class JointSolve {
 public:
  JointSolve(Joints& joints, const Bodies& bodies, std::uint32_t joint, const SolverBody& on_a, const SolverBody& on_b,
             Real h, const JointPull& pull);

  std::uint32_t a, b;  // body slots, or no_body

  // An impact: the relative velocity vanishes at once; what that took counts as load only.
  void stop(SolverBody& on_a, SolverBody& on_b);
  void warm_start(SolverBody& on_a, SolverBody& on_b) const;
  // One visit of the accumulated impulses; of the pseudo ones. Return the largest relative velocity mended.
  Real hold(SolverBody& on_a, SolverBody& on_b);
  Real push(SolverBody& on_a, SolverBody& on_b);
  void store(Joints& joints) const;

 private:
  // A limit's end or a drive.
  struct BoundedRow {
    PreparedRow row;
    bool present = false;
    Real mass = 0, impulse = 0, low = 0, high = 0;  // impulse within low…high
    Real target = 0;                                // rate that it aims at
    Real push = 0, push_target = 0;
  };
  void prepare_coordinate(Joints& joints, const JointRows& demands, const SolverBody& on_a, const SolverBody& on_b, Real h);
  template <class Speed, class Apply>
  Real solve_block(bool pull, Speed speed, Apply apply);

  std::uint32_t joint_;
  JointPull pull_;
  int count_;  // rows of the block
  std::array<PreparedRow, 6> rows_;
  SmallSystem block_;
  std::array<Real, 6> impulse_, bias_{};  // bias: rate that pulls the position back
  std::array<Real, 6> struck_{};          // of all impacts
  Real struck_limit_ = 0;
  BoundedRow low_, high_, drive_;
};

}
