// What moved along a curved surface lost ω²h of its energy a second: its velocity was made tangential once a sub-step,
// then carried it along the tangent to a place where the tangent is another. A ball that circled in a pipe lost a
// quarter of its energy a second, a rattleback never turned back. Impulses now aim at the middle of the sub-step
// (dynamics/curving.h).
#include "unit/worlds.h"

using namespace sudar_test;

namespace {

TEST(CirclingBall, KeepsItsEnergy) {
  World w(steady(1.0 / 60, 4));
  const Material smooth{0, 0, 0};
  w.add({.shape = hollow_cylinder(Real(0.5), 2), .material = smooth, .motion = Motion::fixed});
  const Body ball = w.add(
      {.shape = sphere(Real(0.05)), .at = {0.45, 0, 0}, .velocity = {0, 0, Real(-3.6)}, .mass = 1, .material = smooth});
  const double energy = w[ball].kinetic_energy();
  step(w, 600);
  EXPECT_NEAR(w[ball].kinetic_energy(), energy, 0.001 * energy);
  EXPECT_NEAR(distance(w[ball].pose().p, {}), 0.45, 0.01);
}

}
