// What the drives of joints move, and what servos aim at. A drive acts along its joint's free coordinate while every
// other joint of its group goes on holding; with A = J M⁻¹ Jᵀ of the group's rows, and c and d the coordinate's answers
// to them and to itself, a unit of its impulse changes the rate by d − cᵀ A⁻¹ c: one over the inertia that it feels
// (Featherstone, Rigid Body Dynamics Algorithms, 2008, ch. 8). A servo brakes by that inertia, and by the work that the
// loads will do on the rest of the way.
#pragma once

#include "dynamics/joint_group.h"

namespace sudar::inline SUDAR_PRECISION {

// Keeps only memory between sub-steps, no state.
class Drives {
 public:
  // Before any visit, with `on` as the sub-step begins: gives every driven joint what it moves, and servos their aim.
  void prepare(SubStep&, std::span<const JointGroup>);
  // Of joint k over the whole sub-step, should nothing but joints and loads act on its group, half of it acting before
  // the drift and half after.
  Real impulse(std::uint32_t k) const { return impulses_[k]; }

 private:
  struct Driven {
    explicit Driven(std::uint32_t number) : joint(number) {}
    std::uint32_t joint;            // number in SubStep::joint_rows
    Real inverse_mass = 0;          // that it feels while nothing else drives
    Real rate = 0, carried_on = 0;  // now; after the sub-step without drives
    std::vector<Moving> motion;     // that a unit of its impulse makes, by body of the group
    std::vector<JointSolve::Carried> carried;
  };
  // Work of the loads while a servo's bodies go on along their circles: see drives.cc.
  struct Servo {
    Real way = 0, deceleration = 0, inertia = 0;
  };

  void prepare_group(const JointGroup&, SubStep&);
  void respond(JointSystem&, std::span<const std::uint32_t> joints, SubStep&, Driven&);
  void carry_on(const JointGroup&, const SubStep&);
  void couple();
  Servo plan(const SubStep&, std::size_t n, Real way) const;
  void aim(SubStep&, bool staggered);
  void solve(const SubStep&);
  void forget(const JointGroup&, const SubStep&);

  std::vector<Driven> driven_;                          // of the group at work
  std::vector<Real> answer_;                            // their rates to each other's impulses, n × n
  std::vector<Real> inertia_;                           // its inverse
  std::vector<Real> impulses_;                          // by joint of the island
  std::vector<std::vector<JointSolve::Carried>> kept_;  // what JointSolve looks at
  std::vector<Moving> field_;                           // by number of the body; zero between uses
  std::vector<Wrench> loads_;  // by number in the component's `dynamic`
  std::vector<std::span<const PreparedRow>> rows_;
  std::vector<std::array<Real, 6>> lambda_;
};

}
