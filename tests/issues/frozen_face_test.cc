// With shock_propagation and ten passes a tower of 25 cubes fell: the round from the ground up froze the lower body in the
// rows of the points, but not in the row that a face's points share, which went on pushing it.
#include "unit/worlds.h"

using namespace sudar_test;

namespace {

TEST(FrozenFace, ATowerStandsLevelByLevel) {
  Config c = steady();
  c.impulse_2007.contact_passes = 10;
  c.impulse_2007.shock_propagation = true;
  World w(c);
  w.add(Gravity{{0, -5, 0}});
  const Material m{Real(0.5), Real(0.5), 0};
  add_floor(w, 0, m);
  Body top;
  for (int i = 0; i < 25; ++i)
    top = w.add({.shape = box({4, 4, 4}), .at = {0, 2.1 + 4.1 * i, 0}, .density = 1, .material = m});
  step(w, 1000);
  EXPECT_LT(distance(w[top].center(), {0, 98, 0}), 0.3);
}

}
