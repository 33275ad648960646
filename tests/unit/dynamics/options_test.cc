// The options show what they are for: the thesis's one-point contact and its friction, correction of joints in the
// velocity, passes, sub-steps.
#include "unit/worlds.h"

namespace sudar_test {
namespace {

// A tower of ten cubes that is given a millimetre of lean: on four points it stands, on one it falls.
double tower_top_after_10_s(bool one_point) {
  Config c = steady();
  c.impulse_2007.one_point_contact = one_point;
  World w(c);
  w.add(Gravity{{0, -5, 0}});
  add_floor(w);
  Body top;
  for (int i = 0; i < 10; ++i) top = w.add(cube({0.001 * i, 0.5 + i, 0}));
  step(w, 1000);
  return w[top].center().y;
}
TEST(Options, OnePointContactTopplesATower) {
  EXPECT_GT(tower_top_after_10_s(false), 9.3);
  EXPECT_LT(tower_top_after_10_s(true), 8);
}

// Option joint_correction_in_velocity: a gap closes with a real speed.
TEST(Options, JointCorrectionInVelocity) {
  for (const bool real : {false, true}) {
    Config c = steady();
    c.impulse_2007.joint_correction_in_velocity = real;
    World w(c);
    const Body b = w.add(cube({0, 0, 0}));
    w.join(Rope{.b = b, .at_a = {0, 0, 0}, .at_b = {0, 0, 0}, .length = Real(0.1)});
    const Joint j = w.join(Ball{.b = b, .at = {0, 0, 0}});
    w.place(b, {{0.1, 0, 0}, {}});
    w.step();
    EXPECT_NEAR(w[b].velocity().x, real ? -0.3 * 0.1 / 0.01 : 0, 1e-3);
    EXPECT_NEAR(w[b].center().x, 0.07, 1e-3);
    step(w, 50);
    EXPECT_LT(w[j].gap(), 1e-3);
  }
}

// No passes, no impulses.
TEST(Options, NoPassesNoContacts) {
  Config c = steady();
  c.impulse_2007.collision_passes = c.impulse_2007.contact_passes = 0;
  World w(c);
  w.add(Gravity{});
  add_floor(w);
  const Body b = w.add(cube({0, 0.5, 0}));
  step(w, 100);
  EXPECT_NEAR(w[b].velocity().y, -9.81, 1e-4);
}

// Passes end early, and the profile says how many there were.
TEST(Options, PassesEndEarly) {
  World w(steady());
  w.add(Gravity{});
  add_floor(w);
  w.add(cube({0, 0.5, 0}));
  step(w, 200);
  EXPECT_GE(w.profile().contact.used, 1);
  EXPECT_LT(w.profile().contact.used, 40);
  EXPECT_EQ(w.profile().points, 4);
  EXPECT_EQ(w.profile().contacts, 1);
}

// A deep overlap is pushed out to the slop at the rate b/h, and nothing of it is left as speed.
TEST(Options, OverlapLeavesWithoutSpeed) {
  World w(steady());
  add_floor(w);
  const Body b = w.add(cube({0, 0.4, 0}));
  double depth = 0.1;
  for (int i = 0; i < 100; ++i) {
    w.step();
    depth -= 0.2 * (depth - 0.01);
    ASSERT_NEAR(0.5 - w[b].center().y, depth, 1e-5);
    ASSERT_NEAR(w[b].velocity().y, 0, 1e-6);
  }
}

// A thousand units a metre: the same scene in millimetres behaves alike.
TEST(Options, LengthUnitScalesTheScene) {
  double heights[2];
  for (const Real unit : {Real(1), Real(1000)}) {
    Config c = sleepy();
    c.length_unit = unit;
    World w(c);
    w.add(Gravity{{0, Real(-9.81) * unit, 0}});
    add_floor(w);
    const Body b = w.add({.shape = box({unit, unit, unit}), .at = {0, 1.5 * double(unit), 0}, .mass = 1});
    step(w, 200);
    EXPECT_TRUE(w[b].asleep());
    heights[unit > 1] = w[b].center().y / double(unit);
  }
  EXPECT_NEAR(heights[0], heights[1], 1e-4);
}

}
}
