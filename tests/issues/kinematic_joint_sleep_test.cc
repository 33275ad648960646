// A lamp hung asleep from a lift by a joint. The lift began to move, and the lamp stayed where it was: moving kinematic
// bodies woke what touched them, not what was joined to them.
#include "unit/worlds.h"

namespace sudar_test {
namespace {

TEST(KinematicJoint, WakesWhatHangsOnIt) {
  World w(sleepy());
  w.add(Gravity{});
  const Body lift = w.add({.shape = box({1, 1, 1}), .at = {0, 0, 0}, .motion = Motion::kinematic});
  const Body lamp = w.add(cube({0, -2, 0}));
  const Joint j = w.join(Ball{.a = lift, .b = lamp, .at = {0, -1, 0}});
  step(w, 300);
  ASSERT_TRUE(w[lamp].asleep());
  w.set_velocity(lift, {0, 1, 0}, {});
  step(w, 100);
  EXPECT_NEAR(w[lamp].center().y, -1, 0.02);
  EXPECT_LT(w[j].gap(), 0.02);
}

// So with a fixed hook that is placed elsewhere.
TEST(KinematicJoint, PlacedHookWakesWhatHangsOnIt) {
  World w(sleepy());
  w.add(Gravity{});
  const Body hook = w.add({.shape = box({1, 1, 1}), .at = {0, 0, 0}, .motion = Motion::fixed});
  const Body lamp = w.add(cube({0, -2, 0}));
  w.join(Ball{.a = hook, .b = lamp, .at = {0, -1, 0}});
  step(w, 300);
  ASSERT_TRUE(w[lamp].asleep());
  w.place(hook, {{0, 0.1, 0}, {}});
  EXPECT_FALSE(w[lamp].asleep());
  step(w, 100);
  EXPECT_NEAR(w[lamp].center().y, -1.9, 0.01);
}

}
}
