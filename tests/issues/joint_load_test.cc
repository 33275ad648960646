// `sudar verify V26`: two weights that turn round each other on a bar pulled on it with 0 N, by JointView::load(). The
// turning is kept up by the impacts at the beginning of each sub-step, which were no part of the load; now they are.
#include <gtest/gtest.h>

#include <sudar/world.h>

using namespace sudar;

namespace {

TEST(JointLoad, HoldsTheTurning) {
  World w;
  const Body a = w.add({.shape = sphere(0.05), .at = {1, 0, 0}, .velocity = {0, 1, 0}, .mass = 2});
  const Body b = w.add({.shape = sphere(0.05), .at = {-1, 0, 0}, .velocity = {0, -1, 0}, .mass = 2});
  const Joint bar = w.join(Bar{.a = a, .b = b, .at_a = {1, 0, 0}, .at_b = {-1, 0, 0}});
  for (int i = 0; i < 10; ++i) w.step();
  const Real v = length(w[a].velocity());
  EXPECT_NEAR(length(w[bar].load().force), 2 * v * v / 1, 0.01);
  const Vec3 towards = w[a].center() - w[b].center();
  EXPECT_GT(dot(w[bar].load().force, towards), 0);  // on b
}

TEST(JointLoad, HoldsAFallingRod) {
  World w;
  w.add(Gravity{});
  const Body rod = w.add({.shape = box({1, 0.01, 0.01}), .at = {0.5, 0, 0}, .mass = 1});
  const Joint hinge = w.join(Hinge{.b = rod});
  Real most = 0;
  for (int i = 0; i < 30; ++i) {
    w.step();
    most = max(most, w[hinge].load().force.y);
  }
  EXPECT_NEAR(most, 2.5 * 9.81, 0.5);
}

}
