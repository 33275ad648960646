// A comet in a weak field hung still in the air: released at rest, it needs longer than the twenty steps of the sleep
// rule to become faster than the rule's 3 mm/s, so it was put to sleep, and nothing ever woke it. A body that touches
// nothing and hangs on nothing has nothing to rest on: it does not sleep.
#include "unit/worlds.h"

namespace sudar_test {
namespace {

TEST(WeakGravity, DoesNotPutAFallingBodyToSleep) {
  World w(sleepy());
  w.add(Gravity{{0, Real(-0.01), 0}});
  const Body b = w.add(cube({0, 0, 0}));
  step(w, 1000);
  EXPECT_FALSE(w[b].asleep());
  EXPECT_NEAR(w[b].velocity().y, -0.1, 1e-5);
}

TEST(WeakGravity, DoesNotStopASlowDrift) {
  World w(sleepy());
  const Body b = w.add(cube({0, 0, 0}));
  w.set_velocity(b, {Real(0.002), 0, 0}, {0, Real(0.001), 0});
  step(w, 1000);
  EXPECT_NEAR(w[b].center().x, 0.02, 1e-6);
}

}
}
