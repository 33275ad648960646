// One joint in one sub-step of an impulse solver: its rows as a block, p = K⁻¹(−u), thesis (3.14), (3.23), and the
// bounded rows of its limit and drive. Impulses act on a; b gets the opposite.
#pragma once

#include "dynamics/joints.h"
#include "dynamics/small_system.h"

namespace sudar::inline SUDAR_PRECISION {

// How joints are pulled back together.
struct JointPull {
  Real rate;         // share of the error per second, 1/s
  bool in_velocity;  // in the real velocity, else in the pseudo velocity
};

class JointSolve {
 public:
  JointSolve(Joints& joints, const Bodies& bodies, std::uint32_t joint, const SolverBodies& on, Real h);

  std::uint32_t a, b;  // numbers of the bodies (SolverBodies)
  bool exact = false;  // moved by ExactJoints instead: none of the visits below

  std::uint32_t joint() const { return joint_; }  // its slot
  std::span<const PreparedRow> rows() const { return std::span(rows_).first(std::size_t(count_)); }
  Vec3 linear_impulse() const;  // accumulated, on a, N s
  Real error() const;           // the largest, m or rad
  Real strongest() const;       // impulse, as the change of relative velocity that it is
  bool near_limit() const { return near_limit_; }  // it may act in this sub-step

  // The drive, for those who tell it what it moves and what to aim at (drives.h).
  bool driven() const { return drive_.present; }
  bool sprung() const { return drive_.present && drive_.softness > 0; }
  const Drive& drive(const Joints& joints) const;  // of a driven one
  const PreparedRow& coordinate() const { return coordinate_; }
  Real rate(const SolverBodies& on) const { return coordinate_.speed(on[a].real, on[b].real); }
  Real aim() const { return drive_.target; }
  void set_aim(Real rate) { drive_.target = rate; }
  void set_drive_impulse(Real impulse) { drive_.impulse = impulse; }
  void apply_drive(SolverBodies& on, Real impulse) const;  // along the coordinate, and does not accumulate
  // What comes along with a unit of the drive's impulse, so that joints go on holding.
  struct Carried {
    JointSolve* joint;
    std::array<Real, 6> impulse;
  };
  void set_response(Real inverse_mass, std::span<const Carried> carried);

  // Before any visit.
  void prepare_visits(const JointPull& pull);
  // An impact: the relative velocity vanishes at once; what that took counts as load only.
  void stop(SolverBodies& on);
  void warm_start(SolverBodies& on) const;
  // One visit of the accumulated impulses; of the pseudo ones. Return the largest relative velocity mended.
  Real hold(SolverBodies& on);
  Real push(SolverBodies& on);

  // For those who solve many joints together.
  void renew_rows(const Joints& joints, const Bodies& bodies, const SolverBodies& on);  // where the bodies are now
  void forget_impulse() { impulse_ = {}; }
  void apply(SolverBodies& on, const std::array<Real, 6>& impulse, Real share = 1);  // and accumulates
  void restart(const Joints& joints, const Bodies& bodies, const SolverBodies& on);  // as constructed

  void store(Joints& joints) const;

 private:
  // A limit's end or a drive.
  struct BoundedRow {
    bool present = false;
    Real mass = 0, impulse = 0, low = 0, high = 0;  // impulse within low…high
    Real target = 0;                                // rate that it aims at
    Real softness = 0;                              // of a spring: it gives way by this rate per impulse
    Real push = 0, excess = 0;                      // excess: how far beyond the limit
  };
  void set_rows(const JointRows& demands, const SolverBodies& on);
  // What does not answer is not written: another island may be reading it.
  void put(SolverBodies& on, Moving SolverBody::*which, const Moving& on_a, const Moving& on_b) const;
  void prepare_coordinate(Joints& joints, const Bodies& bodies, const JointRows& demands, const SolverBodies& on,
                          Real h);
  Real drifting(const Joints& joints, const Bodies& bodies, const SolverBodies& on, Real h) const;
  Real hold_drive(SolverBodies& on);
  template <class Apply>
  Real solve_block(Real pull, const Moving& on_a, const Moving& on_b, Apply apply);

  // What every visit reads comes first.
  bool near_limit_ = false;
  bool a_answers_, b_answers_;
  std::uint32_t joint_;
  int count_ = 0;  // rows of the block
  JointPull pull_{};
  std::array<Real, 6> impulse_;
  std::array<Real, 36> block_{};  // K, factored
  std::array<PreparedRow, 6> rows_;
  PreparedRow coordinate_;  // of the three below
  BoundedRow low_, high_, drive_;
  std::span<const Carried> carried_;
  std::array<Real, 6> struck_{};  // of all impacts
  Real struck_limit_ = 0;
};

}
