// The load of a joint was zero in a world that had just been restored: the length of its last sub-step was not.
#include "unit/worlds.h"

namespace sudar_test {
namespace {

TEST(LoadAfterLoad, IsWhatItWas) {
  World w(steady(0.01, 4));
  w.add(Gravity{});
  const Body b = w.add(cube({0, 0, 0}));
  const Joint j = w.join(Fixed{.b = b, .at = {0, 1, 0}});
  step(w, 50);
  ASSERT_GT(w[j].load().force.y, 9);
  World restored;
  restored.load(w.save());
  EXPECT_EQ(restored[j].load().force, w[j].load().force);
  EXPECT_EQ(restored[j].load().torque, w[j].load().torque);
}

}
}
