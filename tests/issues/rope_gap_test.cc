// A rope's gap was always zero, however far it was stretched: a rope has no rows, only a limit, and the gap counted
// rows.
#include "unit/worlds.h"

namespace sudar_test {
namespace {

TEST(RopeGap, IsWhatItIsTooLong) {
  World w(steady());
  const Body b = w.add(cube({0, 0, 0}));
  const Joint j = w.join(Rope{.b = b, .at_a = {0, 3, 0}, .at_b = {0, 0, 0}, .length = 2});
  EXPECT_NEAR(w[j].gap(), 1, 1e-6);
  EXPECT_NEAR(w.quality().joint_gap_max, 1, 1e-6);
  w.place(b, {{0, 2.5, 0}, {}});
  EXPECT_EQ(w[j].gap(), 0);
}

// So with a slider beyond its limits.
TEST(RopeGap, SliderBeyondItsLimit) {
  World w(steady());
  const Body b = w.add(cube({0, 0, 0}));
  const Joint j = w.join(Slider{.b = b, .at = {0, 0, 0}, .limit = {.low = -1, .high = 1}});
  w.place(b, {{1.5, 0, 0}, {}});
  EXPECT_NEAR(w[j].gap(), 0.5, 1e-6);
}

}
}
