// Bodies that hang together by joints and touch nothing: their joints are solved exactly, all at once, so that a
// pendulum keeps its energy and its length. Projecting velocities alone loses ω²h of the kinetic energy a second,
// because the next projection meets a turned tangent. SHAKE (Ryckaert, Ciccotti, Berendsen 1977) chooses velocities
// that meet the joints at the end of the drift, RATTLE (Andersen 1983) projects them once more there; half of the
// forces act before, half after (Hairer, Lubich, Wanner, Geometric Numerical Integration, VII.1). What spins or is taut
// moves in parts of the sub-step.
#pragma once

#include "dynamics/forces.h"
#include "dynamics/joint_solve.h"
#include "dynamics/joint_system.h"

namespace sudar::inline SUDAR_PRECISION {

// Keeps only memory between sub-steps, no state.
class FreeJoints {
 public:
  // Moves over h all that hangs together by `joints`, if none of its bodies is `touched` (by body slot), no limit is
  // near, no drive acts, and it succeeds: no gap is wide before or after, no link between two joints is so taut that it
  // would swing to and fro within a part, and no energy was made. Marks these joints `free`. The motion is held back
  // until commit(), so that all bodies see each other where the sub-step began.
  void advance(std::vector<JointSolve>& joints, const Joints& state, Bodies& bodies, const Forces& forces,
               std::span<const std::uint8_t> touched, Real length_unit, Real h);
  void reset(std::size_t bodies) { moved_.clear(), moves_.assign(bodies, 0); }  // before advance()
  bool moves(std::uint32_t body) const { return moves_[body] != 0; }
  void commit(Bodies&);

 private:
  struct Group {
    std::vector<std::uint32_t> joints;  // numbers in the list
    std::vector<std::uint32_t> moving;  // bodies, fixed and kinematic ones too
    std::vector<std::uint32_t> dynamic;
    std::optional<JointSystem> system;  // none: too costly to solve at once
  };
  struct Scene {
    std::vector<JointSolve>& joints;
    const Joints& state;
    Bodies& bodies;
    const Forces& forces;
    Real wide;  // gap, m
  };
  // A body's motion.
  struct Saved {
    std::uint32_t body;
    Pos position;
    Quat orientation;
    Vec3 velocity, angular_momentum, spin;
  };

  void regroup(const std::vector<JointSystem::Joint>& list, const std::vector<JointSolve>& joints, std::uint32_t slots);
  static Real fastest_turn(const Group&, const Bodies&);
  Real swing(const Group&, const Scene&, Real h);
  bool move(Group&, const Scene&, Real h, int parts);
  bool part(Group&, const Scene&, Real h);
  bool drift(const Group&, const Scene&, Real h);
  void gather(const Group&, const Scene&);
  void kick(const Group&, const Scene&, Real h);
  void prepare(Group&, const Scene&);
  template <class Ask>
  void solve(Group&, const Scene&, Ask ask);
  void apply(Group&, const Scene&);
  double energy_made(const Scene&, Real h) const;
  static void save(std::span<const std::uint32_t> bodies, const Bodies&, std::vector<Saved>& to);
  static void restore(const std::vector<Saved>& from, Bodies&);

  std::vector<JointSystem::Joint> list_;  // what the groups were made of
  std::vector<Group> groups_;
  std::vector<std::uint8_t> moves_;
  std::vector<Saved> moved_, before_, after_, trial_;
  SolverBodies on_;
  std::vector<Wrench> loads_;
  std::vector<Real> tension_;        // by body slot, N s m
  std::vector<std::uint8_t> pulls_;  // joints that pull
  std::vector<std::array<Real, 6>> impulses_;
  std::vector<std::span<const PreparedRow>> rows_;
};

}
