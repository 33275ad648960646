// Motion of bodies that nothing touches: external forces on velocities, and the classical Runge–Kutta method (the
// thesis's future work: higher order).
#pragma once

#include "dynamics/forces.h"
#include "dynamics/rotation.h"
#include "dynamics/rows.h"

namespace sudar::inline SUDAR_PRECISION {

// ω of a body that turns with L: the same arithmetic wherever it is asked, so that an untouched L gives an exact zero.
Vec3 spin_of(const Bodies&, std::uint32_t i);

// A body before all impulses; what is not dynamic does not answer them.
SolverBody solver_body(const Bodies&, std::uint32_t i);

// thesis (3.2): v += h F/m, then resistance, thesis (3.6), implicitly, v ← v / (1 + h (A + B|v|)/m): the explicit form overshoots where
// h A/m > 1, which large time factors reach. `body` holds the velocities of body i.
void accelerate(const Bodies&, std::uint32_t i, const Wrench& load, const DragRates& drag, Real h, SolverBody& body);

// The motion of one body. place() takes it over, if all of it is finite; else returns false, and the body stays as it was.
struct BodyMotion {
  Pos position;
  Quat orientation;
  Vec3 velocity, angular_momentum;
};
bool place(Bodies&, std::uint32_t i, const BodyMotion&);

// Where body i would be, and how it would turn, if it drifted over h with the real velocities in `body`.
struct Ahead {
  Pose center;
  Vec3 spin;
};
Ahead ahead(const Bodies&, std::uint32_t i, const SolverBody& body, Real h);

// thesis (3.3): takes over the real velocities in `body` and drifts over h; then turns by the pseudo ones. Returns false, and leaves
// the body as it was, where its state would not be finite.
bool drift(Bodies&, std::uint32_t i, const SolverBody& body, Real h);
// The same for a kinematic body.
void carry(Bodies&, std::uint32_t i, Real h);

// One step of the classical fourth-order Runge–Kutta method for all of `which` together, forces re-evaluated at its four
// states. For smooth forces only; h (drag rate) must stay below about 1. A body whose state would not be finite stays as
// it was; these are returned.
std::vector<std::uint32_t> runge_kutta_4(Bodies&, const Forces&, std::span<const std::uint32_t> which, Real h);

}
