// A box that friction carries round on a turntable crept outward, 0.34 m in 50 s, and would have been thrown off in the
// end. Friction gave it the speed of the point on which it stood at the beginning of a step, and with that it went on
// along the tangent for the whole step: r grew by ω²rh/2 a second. The arms of contacts are now those of mid-step.
#include <gtest/gtest.h>

#include <sudar/world.h>

using namespace sudar;

namespace {

TEST(CarriedRound, WhatATurntableCarriesStaysWhereItStands) {
  Config c;
  c.dt = 0.01;
  c.substeps = 1;
  World w(c);
  w.add(Gravity{{0, -4, 0}});
  const Body table = w.add({.shape = box({30, 4, 30}), .at = {0, -2, 0}, .motion = Motion::kinematic});
  const Body rider = w.add({.shape = box({2, 2, 2}), .at = {5, 1, 0}, .density = 1});
  w.set_velocity(table, {}, {0, Real(0.5), 0});
  w.set_velocity(rider, {0, 0, Real(-2.5)}, {0, Real(0.5), 0});
  for (int i = 0; i < 5000; ++i) w.step();
  const Pos p = w[rider].pose().p;
  EXPECT_NEAR(sqrt(p.x * p.x + p.z * p.z), 5, 1e-3);
}

}
