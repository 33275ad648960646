// Two rods on pivots turned into each other, elastically, and kept a seventh of their energy. Each contact bounced as
// if its bodies were free, then the hinges took most of the bounce away, and nobody asked for it again. What joints
// take from a bounce, the contact now owes. (Besides, the points of a face shared their load so slowly that the rods
// parted with unequal spins, and what the visits had left over was taken for energy made by friction, which cancelled
// the bounce.)
#include <gtest/gtest.h>

#include <sudar/world.h>

using namespace sudar;

namespace {

TEST(HingedBounce, HingedRodsPartAsFastAsTheyMet) {
  Config c;
  c.dt = 0.01;
  c.substeps = 1;
  c.sleep = false;
  World w(c);
  Body rods[2];
  for (int i : {0, 1}) {
    const Pos at{i == 0 ? -2.2 : 2.2, 0, 0};
    rods[i] = w.add({.shape = box({1, 5, 1}), .at = at, .density = 1, .material = {0, 0, 1}});
    w.set_velocity(rods[i], {}, {0, 0, Real(0.1)});
    w.join(Hinge{.b = rods[i], .at = at});
  }
  for (int impact = 0; impact < 2; ++impact) {
    const Real before = w[rods[0]].spin().z;
    for (int i = 0; i < 3000 && w[rods[0]].spin().z * before > 0; ++i) w.step();
    for (Body rod : rods) EXPECT_NEAR(w[rod].spin().z, -before, 1e-6) << "impact " << impact;
  }
}

}
