// Bodies that hang together by joints and touch nothing: their joints are solved exactly, all at once, so that a
// pendulum keeps its energy and its length. Projecting velocities alone loses ω²h of the kinetic energy a second,
// because the next projection meets a turned tangent. SHAKE (Ryckaert, Ciccotti, Berendsen 1977) chooses velocities
// that meet the joints at the end of the drift, RATTLE (Andersen 1983) projects them once more there; half of the
// forces and drives act before, half after (Hairer, Lubich, Wanner, Geometric Numerical Integration, VII.1). What spins or is taut
// moves in parts of the sub-step; what is tauter still answers impulses as if it had more inertia (geometric stiffness).
#pragma once

#include "dynamics/drives.h"

namespace sudar::inline SUDAR_PRECISION {

// Keeps only memory between sub-steps, no state.
class ExactJoints {
 public:
  // Moves over the sub-step every component of the island's joints, if none of its bodies touches anything, no limit is
  // near, no spring acts, and it succeeds: no gap is wide before or after, and no energy was made. Marks these joints `exact` and the bodies `settled`.
  // The motion is held back until commit(), so that all bodies see each other where the sub-step began.
  void advance(SubStep&, std::span<const JointGroup>, const Drives&);
  void reset() { moved_.clear(); }  // before the first island of a sub-step
  void commit(Bodies&);

 private:
  // A component at work.
  struct Group {
    SubStep& s;
    JointComponent& component;
    std::span<const std::uint32_t> joints;  // numbers in s.joint_rows
    const Drives& drives;
    Real wide;  // gap, m
    Bodies& bodies() const { return s.in.bodies; }
    JointSolve& joint(std::size_t n) const { return s.joint_rows[joints[n]]; }
    SolverBody& on(std::uint32_t slot) const { return s.on[s.on.number(slot)]; }
  };
  // A body's motion.
  struct Saved {
    std::uint32_t body;
    Pos position;
    Quat orientation;
    Vec3 velocity, angular_momentum, spin;
  };

  bool advance(const Group&);
  static bool hindered(const Group&);
  static Real fastest_turn(const Group&);
  Real swing(const Group&, Real h);
  bool move(const Group&, int parts);
  bool part(const Group&, Real h);
  static bool drift(const Group&, Real h);
  static void gather(const Group&);
  void take_up(const Group&);
  static Real largest_inertia(const Group&, std::size_t k);
  Real inertia_for_swing(const Group&, std::size_t k) const;
  void slow_swings(const Group&);
  bool swings_beyond(const Group&) const;
  void kick(const Group&, Real h);
  void prepare(const Group&);
  template <class Ask>
  void solve(const Group&, Ask ask);
  void apply(const Group&);
  double energy_made(const Group&) const;
  static std::vector<Real> rates(const Group&);
  // Of those that move.
  static void save(std::span<const std::uint32_t> bodies, const Bodies&, std::vector<Saved>& to);
  static void restore(const std::vector<Saved>& from, Bodies&);

  std::vector<Saved> moved_, before_, after_, trial_;
  std::vector<Wrench> loads_;        // by number in `dynamic`
  std::vector<Real> tension_;        // by number of the body, N s m
  std::vector<Real> added_;          // to the inertia of taut bodies, by number of the body; empty: none
  std::vector<std::uint8_t> pulls_;  // joints that pull
  std::vector<Real> rates_before_;   // of driven coordinates, by joint of the group
  std::vector<std::array<Real, 6>> impulses_;
  std::vector<std::span<const PreparedRow>> rows_;
};

}
