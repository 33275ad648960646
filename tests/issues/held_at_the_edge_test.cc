// Pictures of the train showed red contacts, slipping, under wagons that did not move by a nanometre: the pull takes up
// the friction of one wagon after the other, and those at the edge of their cones were told to slip.
#include "unit/worlds.h"

namespace sudar_test {
namespace {

TEST(HeldAtTheEdge, DoesNotSlip) {
  Config c = steady(0.01);
  c.friction_mix = Mix::min;
  World w(c);
  w.add(Gravity{{0, -5, 0}});
  add_floor(w, -1.5, {100, 100});
  std::vector<Body> wagons;
  for (int i = 0; i < 10; ++i) {
    wagons.push_back(
        w.add({.shape = box({10, 3, 3}), .at = {11.0 * i, 0, 0}, .density = 1, .material = {Real(0.15), Real(0.1)}}));
    if (i == 0) continue;
    for (const double y : {-1.0, 1.0}) {
      w.join(Ball{.a = wagons[std::size_t(i) - 1], .b = wagons.back(), .at = {11 * i - 5.5, y, 0}});
    }
  }
  w.add(Thruster{.body = wagons[0], .force = {-600, 0, 0}});
  step(w, 100);
  ASSERT_EQ(w.contacts().size(), wagons.size());
  Real most = 0;
  for (const Contact& contact : w.contacts()) {
    EXPECT_FALSE(contact.slipping);
    for (int k = 0; k < contact.count; ++k) most = max(most, contact.points[std::size_t(k)].cone_share);
  }
  EXPECT_GT(most, 0.999);
  EXPECT_LT(length(w[wagons[0]].velocity()), 1e-5);
}

}
}
