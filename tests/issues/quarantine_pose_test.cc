// A body that spun too fast for its precision got an orientation that was no number. It was quarantined a step later,
// but its pose stayed broken, and in between it collided with others. With the fourth-order method a quarantined body
// was still moved, to nowhere. A body that turns non-finite stays where it last was.
#include "unit/worlds.h"

namespace sudar_test {
namespace {

void expect_frozen(World& w, Body broken, Body neighbour) {
  int reports = 0;
  for (int i = 0; i < 50; ++i) {
    for (const Events::Quarantined& q : w.step().quarantined) {
      EXPECT_EQ(q.body, broken);
      ++reports;
    }
    ASSERT_TRUE(is_finite(w[broken].pose().p) && is_finite(w[broken].pose().q)) << i;
    ASSERT_TRUE(is_finite(w[neighbour].pose().p) && is_finite(w[neighbour].pose().q)) << i;
  }
  EXPECT_EQ(reports, 1);
  EXPECT_TRUE(w[broken].quarantined());
  EXPECT_FALSE(w[neighbour].quarantined());
  EXPECT_EQ(w[broken].velocity(), Vec3{});
}

TEST(Quarantine, OfASpinTooFast) {
  for (const Integrator method : {Integrator::symplectic_euler, Integrator::rk4}) {
    Config c = steady();
    c.integrator = method;
    World w(c);
    w.add(Gravity{});
    const Body b = w.add({.shape = box({1, 2, 3}), .at = {0, 10, 0}, .mass = 1});
    const Real huge = Real(by_precision(1e30, 1e200));  // the spin is finite, its square is not
    w.add(Thruster{.body = b, .force = {0, huge, huge / 3}, .at = {1, Real(0.5), 0}});
    const Body neighbour = w.add(cube({1.2, 10, 0}));
    expect_frozen(w, b, neighbour);
  }
}
TEST(Quarantine, OfAForceTooGreat) {
  for (const Integrator method : {Integrator::symplectic_euler, Integrator::rk4}) {
    Config c = steady();
    c.integrator = method;
    World w(c);
    w.add(Gravity{});
    const Real huge = std::numeric_limits<Real>::max();
    const Body b = w.add({.shape = box({1, 1, 1}), .at = {0, 10, 0}, .mass = Real(1e-3)});
    w.add(Thruster{.body = b, .force = {huge, 0, 0}});
    const Body neighbour = w.add(cube({1.2, 10, 0}));
    expect_frozen(w, b, neighbour);
  }
}

// An angular momentum that overflows is refused, like any other quantity that the precision cannot hold.
TEST(Quarantine, AngularMomentumThatOverflowsIsRefused) {
  World w(steady());
  const Real huge = std::numeric_limits<Real>::max();
  EXPECT_THROW(w.add({.shape = box({10, 10, 10}), .spin = {huge, 0, 0}, .mass = 1}), Error);
  const Body b = w.add({.shape = box({10, 10, 10}), .mass = 1});
  EXPECT_THROW(w.set_velocity(b, {}, {huge, 0, 0}), Error);
}

}
}
