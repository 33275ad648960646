// A world restored in the middle of a run went on with other bits some steps later, though its hash was the same: when a
// pair that is apart would be looked at again was no state, so that a restored world looked at all of them at once, and
// what a look finds, an axis, is where the next look begins. And another broad phase, chosen while a world ran, forgot how
// far the bodies had come, but not until when their pairs need not be looked at: they were not, and passed through.
#include "unit/worlds.h"

namespace sudar_test {
namespace {

// Turning cubes above each other and beside each other, near and never at rest for long.
World tumbling(Solver solver) {
  Config c = sleepy();
  c.solver = solver;
  World w(c);
  w.add(Gravity{});
  add_floor(w);
  for (int i = 0; i < 12; ++i) {
    BodyDef b = cube({1.3 * (i % 4), 1 + 1.4 * double(i / 4), 0.2 * (i % 3)});
    b.spin = {Real(i % 3), Real(1), Real(i % 2)};
    w.add(b);
  }
  return w;
}

TEST(UnseenPair, ARestoredWorldGoesOnWithTheSameBits) {
  for (const Solver solver : {Solver::impulse_2007, Solver::soft_step}) {
    World w = tumbling(solver);
    for (int i = 0; i < 150; ++i) {
      World restored;
      restored.load(w.save());
      w.step(), restored.step();
      ASSERT_EQ(restored.hash(), w.hash()) << names(solver)[int(solver)] << ", step " << i;
    }
  }
}

TEST(UnseenPair, IsSeenAfterAnExchangeOfTheBroadPhase) {
  World w(steady());
  const Body flier = w.add({.shape = box({1, 1, 1}), .velocity = {10, 0, 0}, .mass = 1});
  w.add({.shape = box({1, 4, 4}), .at = {30, 0, 0}, .motion = Motion::fixed});
  step(w, 275);
  for (int i = 0; i < 50; ++i) {  // the wall is met after the 290th step
    Config c = w.config();
    c.broad = c.broad == Broad::grid ? Broad::sweep : Broad::grid;
    w.set_config(c);
    w.step();
  }
  EXPECT_LT(w[flier].pose().p.x, 29.1);
}

}
}
