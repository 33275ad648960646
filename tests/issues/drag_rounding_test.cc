// `sudar verify V02`: in single precision a body with linear drag came out of 480 sub-steps 2.5e-5 too fast. The velocity
// was multiplied by 1/(1 + h k), rounded once and then applied with the same error in every step. Taking away the part
// h k/(1 + h k) instead makes the rounding a part of that small change.
#include <gtest/gtest.h>

#include <sudar/world.h>

using namespace sudar;

namespace {

TEST(DragRounding, DoesNotAccumulate) {
  World w;
  w.add(Drag{.linear = Real(0.5), .angular = Real(0.5)});
  const Body b = w.add({.shape = sphere(0.1), .velocity = {10, 0, 0}, .spin = {0, 10, 0}});
  for (int i = 0; i < 120; ++i) w.step();
  const double exact = 10 * std::pow(1 + 0.5 / 240, -480);
  EXPECT_NEAR(w[b].velocity().x, exact, 1e-5 * exact);
  EXPECT_NEAR(w[b].spin().y, exact, 1e-5 * exact);
}

}
