// Bodies that hang together by joints and touch nothing: their joints are solved exactly, all at once, so that a
// pendulum keeps its energy and its length. Projecting velocities alone loses ω²h of the kinetic energy a second,
// because the next projection meets a turned tangent. SHAKE (Ryckaert, Ciccotti, Berendsen 1977) chooses velocities
// that meet the joints at the end of the drift, RATTLE (Andersen 1983) projects them once more there; half of the
// forces and drives act before, half after (Hairer, Lubich, Wanner, Geometric Numerical Integration, VII.1). What spins or is taut
// moves in parts of the sub-step.
#pragma once

#include "dynamics/drives.h"

namespace sudar::inline SUDAR_PRECISION {

// Keeps only memory between sub-steps, no state.
class FreeJoints {
 public:
  // Moves over h all that hangs together by `joints`, if none of its bodies is `touched` (by body slot), no limit is
  // near, no spring acts, and it succeeds: no gap is wide before or after, no link between two joints is so taut that it
  // would swing to and fro within a part, and no energy was made. Marks these joints `free`. The motion is held back
  // until commit(), so that all bodies see each other where the sub-step began.
  void advance(std::vector<JointSolve>& joints, const Joints& state, Bodies& bodies, const Forces& forces,
               const Drives& drives, JointGroups& groups, std::span<const std::uint8_t> touched, Real length_unit,
               Real h);
  void reset(std::size_t bodies) { moved_.clear(), moves_.assign(bodies, 0); }  // before advance()
  bool moves(std::uint32_t body) const { return moves_[body] != 0; }
  void commit(Bodies&);

 private:
  struct Scene {
    std::vector<JointSolve>& joints;
    const Joints& state;
    Bodies& bodies;
    const Forces& forces;
    const Drives& drives;
    Real wide;  // gap, m
    Real h;     // of the whole sub-step, s
  };
  // A body's motion.
  struct Saved {
    std::uint32_t body;
    Pos position;
    Quat orientation;
    Vec3 velocity, angular_momentum, spin;
  };

  static Real fastest_turn(const JointGroup&, const Bodies&);
  Real swing(const JointGroup&, const Scene&, Real h);
  bool move(JointGroup&, const Scene&, Real h, int parts);
  bool part(JointGroup&, const Scene&, Real h);
  bool drift(const JointGroup&, const Scene&, Real h);
  void gather(const JointGroup&, const Scene&);
  void kick(const JointGroup&, const Scene&, Real h);
  void prepare(JointGroup&, const Scene&);
  template <class Ask>
  void solve(JointGroup&, const Scene&, Ask ask);
  void apply(JointGroup&, const Scene&);
  double energy_made(const JointGroup&, const Scene&, Real h) const;
  std::vector<Real> rates(const JointGroup&, const Scene&) const;  // of the driven coordinates
  static void save(std::span<const std::uint32_t> bodies, const Bodies&, std::vector<Saved>& to);
  static void restore(const std::vector<Saved>& from, Bodies&);

  std::vector<std::uint8_t> moves_;
  std::vector<Saved> moved_, before_, after_, trial_;
  SolverBodies on_;
  std::vector<Wrench> loads_;
  std::vector<Real> rates_before_;   // m/s or rad/s
  std::vector<Real> tension_;        // by body slot, N s m
  std::vector<std::uint8_t> pulls_;  // joints that pull
  std::vector<std::array<Real, 6>> impulses_;
  std::vector<std::span<const PreparedRow>> rows_;
};

}
