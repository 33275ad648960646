// The order of the integrators on smooth forces: the error of the fourth-order method falls 16 times when the step is
// halved, that of symplectic Euler twice.
#include <functional>

#include "unit/worlds.h"

namespace sudar_test {
namespace {

struct Problem {
  const char* name;
  std::function<Body(World&)> build;
  double seconds;
  int coarse;  // steps in that time, where the fourth-order method's error is far above rounding
};

Pos answer(const Problem& p, Integrator method, int steps) {
  Config c = steady(p.seconds / steps);
  c.integrator = method;
  World w(c);
  const Body b = p.build(w);
  step(w, steps);
  return w[b].pose().point({0, Real(0.25), 0});  // off the centre: an error of the turn counts too
}

double order(const Problem& p, Integrator method) {
  const Pos exact = answer(p, Integrator::rk4, 16 * p.coarse);
  const double coarse = distance(answer(p, method, p.coarse), exact),
               fine = distance(answer(p, method, 2 * p.coarse), exact);
  return std::log2(coarse / fine);
}

Body fly(World& w) {
  w.add(Gravity{});
  w.add(Drag{.linear = 0.4, .quadratic = Real(0.1), .angular = 1});
  return w.add({.shape = box({1, 2, 3}), .velocity = {10, 15, 0}, .spin = {1, 2, 3}});
}
Body orbit(World& w) {
  w.add(NBody{.gravitational_constant = 1});
  w.add({.shape = sphere(Real(0.01)), .velocity = {0, Real(-0.4), 0}, .mass = 1});
  return w.add({.shape = sphere(Real(0.01)), .at = {1, 0, 0}, .velocity = {0, Real(0.8), 0}, .mass = Real(0.5)});
}
Body thrust(World& w) {
  const Body b = w.add({.shape = box({1, 2, 3}), .spin = {0, 0, 1}, .mass = 1});
  w.add(Thruster{.body = b, .force = {1, Real(0.5), 0}, .at = {Real(0.2), Real(0.3), Real(0.1)}});
  return b;
}

const Problem problems[] = {
    {"gravity and drag", fly, 2, 12},
    {"two bodies", orbit, 3, 12},
    {"thruster", thrust, 4, 8},
};

TEST(Order, RungeKuttaHasFour) {
  for (const Problem& p : problems) EXPECT_NEAR(order(p, Integrator::rk4), 4, 0.5) << p.name;
}
TEST(Order, SymplecticEulerHasOne) {
  for (const Problem& p : problems)
    EXPECT_NEAR(order({p.name, p.build, p.seconds, 8 * p.coarse}, Integrator::symplectic_euler), 1, 0.2) << p.name;
}

// A closed form: a thruster through the centre of a ball that spins at ω moves it on a cycloid,
// x = F/(m ω²) (1 − cos ωt), y = F/(m ω²) (ωt − sin ωt).
TEST(Order, SpinningThrusterDrawsACycloid) {
  Config c = steady(0.01);
  c.integrator = Integrator::rk4;
  World w(c);
  const Body b = w.add({.shape = sphere(1), .spin = {0, 0, 3}, .mass = 2});
  w.add(Thruster{.body = b, .force = {4, 0, 0}});
  step(w, 200);
  const double angle = 6, r = 4 / (2 * 9.0);
  expect_near(w[b].center(), Pos{r * (1 - std::cos(angle)), r * (angle - std::sin(angle)), 0},
              by_precision(1e-5, 1e-7));
}

// Bodies that touch something or hang on something keep to symplectic Euler, the same bits as with it alone.
TEST(Order, RungeKuttaIsForFreeBodies) {
  Config c = steady(0.01);
  std::uint64_t hashes[2];
  for (const Integrator method : {Integrator::symplectic_euler, Integrator::rk4}) {
    c.integrator = method;
    World w(c);
    w.add(Gravity{});
    add_floor(w);
    w.add(cube({0, 0.5, 0}));
    const Body hanging = w.add(cube({5, 5, 0}));
    w.join(Ball{.b = hanging, .at = {6, 5, 0}});
    step(w, 100);
    hashes[method == Integrator::rk4] = w.motion_hash();
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

}
}
