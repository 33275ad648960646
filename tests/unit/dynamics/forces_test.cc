// Gravity, resistance, n-body gravity, thrusters and pushes on bodies that touch nothing: closed forms.
#include "unit/worlds.h"

namespace sudar_test {
namespace {

// V01: symplectic Euler falls z₀ − ½ g h² N (N+1) exactly, with v = −g h N.
TEST(Gravity, FallsInTheDiscreteForm) {
  for (const int substeps : {1, 4}) {
    World w(steady(1.0 / 60, substeps));
    w.add(Gravity{});
    const Body b = w.add({.shape = sphere(1), .at = {0, 10, 0}});
    step(w, 120);
    const double h = 1.0 / 60 / substeps, n = 120 * substeps;
    EXPECT_NEAR(w[b].center().y, 10 - 0.5 * 9.81 * h * h * n * (n + 1), by_precision(5e-5, 1e-11));
    EXPECT_NEAR(w[b].velocity().y, -9.81 * h * n, by_precision(5e-5, 1e-11));
  }
}

// A balloon rises at half of g; what has factor 0 stays. Energy counts what acts.
class GravityFactor : public WithEachSolver {};
INSTANTIATE_TEST_SUITE_P(Solvers, GravityFactor, each_solver(), solver_name);
TEST_P(GravityFactor, TimesGravity) {
  World w(config());
  w.add(Gravity{});
  const Body balloon = w.add({.shape = sphere(1), .at = {0, 10, 0}, .mass = 2, .gravity_factor = Real(-0.5)});
  const Body still = w.add({.shape = sphere(1), .at = {9, 10, 0}, .gravity_factor = 0});
  const double energy = w.energy().total();
  step(w, 60);
  EXPECT_NEAR(w[balloon].velocity().y, 9.81 / 2, 1e-4);
  EXPECT_EQ(w[still].velocity(), Vec3{});
  EXPECT_NEAR(w.energy().total(), energy, 0.02 * 2 * 4.905 * 2.45);
  EXPECT_EQ(w[balloon].gravity_factor(), Real(-0.5));
}

// What rises rests under a ceiling, and a stack on a floor carries what is on it by its factor.
TEST_P(GravityFactor, RestsWhereItLeadsTo) {
  World w(config());
  w.add(Gravity{});
  w.add({.shape = box({9, 1, 9}), .at = {0, 4, 0}, .motion = Motion::fixed});
  BodyDef balloon = cube({0, 1, 0});
  balloon.gravity_factor = -1;
  const Body b = w.add(balloon);
  step(w, 300);
  EXPECT_NEAR(w[b].pose().p.y, 3, 0.012);
  EXPECT_LT(length(w[b].velocity()), 0.01);
}

// The parabola is in the fourth-order method's reach: exact.
TEST(Gravity, RungeKuttaFallsExactly) {
  Config c = steady(1.0 / 60);
  c.integrator = Integrator::rk4;
  World w(c);
  w.add(Gravity{});
  const Body b = w.add({.shape = sphere(1), .at = {0, 10, 0}});
  step(w, 120);
  EXPECT_NEAR(w[b].center().y, 10 - 0.5 * 9.81 * 4, by_precision(5e-5, 1e-11));
}

TEST(Gravity, TwoGravitiesAdd) {
  World w(steady());
  w.add(Gravity{{0, -3, 0}});
  const ForceId sideways = w.add(Gravity{{2, 0, 0}});
  const Body b = w.add(cube({}));
  step(w, 100);
  expect_near(w[b].velocity(), Vec3d{2, -3, 0}, 1e-5);
  w.remove(sideways);
  step(w, 100);
  expect_near(w[b].velocity(), Vec3d{2, -6, 0}, 2e-5);
}

// V02: v ← (v + g h)/(1 + k h), so v_N = v₀ rᴺ − g h r (1 − rᴺ)/(1 − r) with r = 1/(1 + k h).
TEST(Drag, LinearFollowsTheDiscreteForm) {
  World w(steady(1.0 / 60));
  w.add(Gravity{});
  w.add(Drag{.linear = 0.5});
  const Body b = w.add({.shape = sphere(1), .velocity = {10, 15, 0}});
  step(w, 120);
  const double h = 1.0 / 60, r = 1 / (1 + 0.5 * h), rn = std::pow(r, 120);
  EXPECT_NEAR(w[b].velocity().x, 10 * rn, 1e-5);
  EXPECT_NEAR(w[b].velocity().y, -6.8311306, 1e-5);
  EXPECT_NEAR(15 * rn - 9.81 * h * r * (1 - rn) / (1 - r), -6.8311306, 1e-6);
}

// V03: terminal speed 20 m/s. Fallen for 3 s; thrown up with 30 m/s until it turns. The error halves with h.
TEST(Drag, QuadraticFallsAsTanh) {
  double errors[2];
  for (const int k : {0, 1}) {
    const int rate = 60 << k;
    World w(steady(1.0 / rate));
    w.add(Gravity{});
    w.add(Drag{.quadratic = Real(9.81 / 400)});
    const Body b = w.add({.shape = sphere(1)});
    step(w, 3 * rate);
    EXPECT_NEAR(-w[b].center().y, 33.8315234, 0.01 * 33.8315234);
    EXPECT_NEAR(-w[b].velocity().y, 17.9972642, 0.01 * 17.9972642);
    errors[k] = -w[b].center().y - 33.8315234;
  }
  EXPECT_NEAR(errors[0] / errors[1], 2, 0.1);
}
TEST(Drag, QuadraticRisesAsTan) {
  World w(steady(1.0 / 960));
  w.add(Gravity{});
  w.add(Drag{.quadratic = Real(9.81 / 400)});
  const Body b = w.add({.shape = sphere(1), .velocity = {0, 30, 0}});
  while (w[b].velocity().y > 0) w.step();
  EXPECT_NEAR(w.time(), 2.0036569, 0.004);
  EXPECT_NEAR(w[b].center().y, 24.0296635, 0.03);
}

TEST(Drag, AngularFollowsTheDiscreteForm) {
  World w(steady(0.01));
  w.add(Drag{.angular = 1, .angular_quadratic = 0.5, .angular_per_radius = 2});
  const Body b = w.add({.shape = sphere(0.25), .spin = {0, 4, 0}});
  double spin = 4;
  for (int i = 0; i < 100; ++i) w.step(), spin /= 1 + 0.01 * (1 + 0.5 * spin + 2 * 0.25);
  EXPECT_NEAR(w[b].spin().y, spin, 1e-5);
}

TEST(Drag, ActsOnItsBodyOnly) {
  World w(steady());
  const Body slowed = w.add({.shape = sphere(1), .velocity = {1, 0, 0}});
  const Body free = w.add({.shape = sphere(1), .at = {0, 9, 0}, .velocity = {1, 0, 0}});
  w.add(Drag{.body = slowed, .linear = 1});
  step(w, 100);
  EXPECT_NEAR(w[slowed].velocity().x, std::pow(1.01, -100), 1e-5);
  EXPECT_EQ(w[free].velocity().x, 1);
}

// F = G m₁ m₂ / r² on both, opposite: the centre of mass stays, and angular momentum too.
TEST(NBody, TwoBodiesKeepTheirMomentum) {
  World w(steady(0.001));
  w.add(NBody{.gravitational_constant = 1});
  w.add({.shape = sphere(0.01), .velocity = {0, Real(-0.1), 0}, .mass = 10});
  w.add({.shape = sphere(0.01), .at = {1, 0, 0}, .velocity = {0, 3, 0}, .mass = 1});
  w.add({.shape = sphere(0.01), .at = {0, 2, 1}, .velocity = {1, 1, 0}, .mass = 2});
  const Momentum before = w.momentum();
  const double energy = w.energy().total();
  step(w, 2000);
  const Momentum after = w.momentum();
  expect_near(after.linear, before.linear, by_precision(2e-4, 1e-12));
  expect_near(after.angular, before.angular, by_precision(2e-4, 1e-12));
  EXPECT_NEAR(w.energy().total(), energy, 0.01 * std::abs(energy));
}

TEST(NBody, FixedBodiesAttract) {
  World w(steady(0.01));
  w.add(NBody{.gravitational_constant = 2});
  w.add({.shape = sphere(0.1), .mass = 8, .motion = Motion::fixed});
  const Body b = w.add({.shape = sphere(0.1), .at = {4, 0, 0}, .mass = 1});
  w.step();
  EXPECT_NEAR(w[b].velocity().x, -0.01 * 2 * 8 / 16, 1e-8);
}

// Plummer's softening: F = G m₁ m₂ r / (r² + s²)^(3/2), which the potential matches.
TEST(NBody, SoftensAsItsPotentialSays) {
  World w(steady(0.001));
  w.add(NBody{.gravitational_constant = 1, .softening = 3});
  w.add({.shape = sphere(0.1), .mass = 100, .motion = Motion::fixed});
  const Body b = w.add({.shape = sphere(0.1), .at = {4, 0, 0}, .mass = 1});
  EXPECT_NEAR(w.energy().potential, -100.0 / 5, 1e-6);
  w.step();
  EXPECT_NEAR(w[b].velocity().x, -0.001 * 100 * 4 / 125.0, 1e-8);
}

// V09: the staggered start v₀ = (x₀ − x₋₁)/h puts every position of symplectic Euler on the circle. In double the
// radius keeps its digits over 1000 orbits; in float the velocities' rounding walks at random: 10⁻⁴ is what it reaches.
TEST(NBody, PlanetKeepsItsRadiusOverAThousandOrbits) {
  constexpr double year = 365.25 * 86400, au = 1.495978707e11, gm = 4 * pi * pi * au * au * au / (year * year);
  constexpr int steps_an_orbit = 200;
  Config c = steady(1.0 / 60);
  c.time_factor = Real(year / steps_an_orbit * 60);  // k ≈ 10⁷
  World w(c);
  const double h = c.dt * double(c.time_factor);
  constexpr double big_g = 6.6743e-11;
  w.add(NBody{.gravitational_constant = Real(big_g)});
  const Real sun = Real(gm / big_g);
  w.add({.shape = sphere(1000), .mass = sun, .motion = Motion::fixed});
  const double omega = sqrt(double(Real(big_g)) * double(sun) / (au * au * au));
  const double step_angle = 2 * std::asin(omega * h / 2);
  const double x = au * (1 - std::cos(step_angle)) / h, y = au * std::sin(step_angle) / h;
  const Body b = w.add({.shape = sphere(1), .at = {au, 0, 0}, .velocity = {Real(x), Real(y), 0}, .mass = 1});
  double swing = 0;
  for (int i = 0; i < 1000 * steps_an_orbit; ++i) {
    w.step();
    swing = std::max(swing, std::abs(distance(w[b].center(), {}) / au - 1));
  }
  EXPECT_LT(swing, by_precision(1e-4, 1e-6));
}

// With the plain start the radius swings by ω h / 2, forth and back, and no further.
TEST(NBody, PlainStartSwings) {
  World w(steady(0.0033));
  w.add(NBody{.gravitational_constant = 1});
  w.add({.shape = sphere(0.01), .mass = 1, .motion = Motion::fixed});
  const Body b = w.add({.shape = sphere(0.01), .at = {1, 0, 0}, .velocity = {0, 1, 0}, .mass = Real(1e-3)});
  double swing = 0;
  for (int i = 0; i < 20000; ++i) w.step(), swing = std::max(swing, std::abs(distance(w[b].center(), {}) - 1));
  EXPECT_NEAR(swing, 0.0033 / 2, 0.0001);
}

// A force in the body's axes at a point off its centre: F h and r × F h.
TEST(Thruster, PushesAndTurnsInBodyAxes) {
  World w(steady(0.01));
  const Quat turn = axis_angle(Vec3{0, 0, 1}, Real(pi / 2));  // body x is world y
  const Body b = w.add({.shape = box({1, 2, 3}), .turn = turn, .mass = 2});
  w.add(Thruster{.body = b, .force = {4, 0, 0}, .at = {0, Real(0.5), 0}});
  w.step();
  expect_near(w[b].velocity(), Vec3d{0, 4 * 0.01 / 2, 0}, 1e-8);
  expect_near(w[b].angular_momentum(), Vec3d{0, 0, -0.5 * 4 * 0.01}, 1e-8);
}

// The place of a thruster counts from the shape's origin, which need not be the centre of mass.
TEST(Thruster, ThroughTheCentreOfMassDoesNotTurn) {
  World w(steady(0.01));
  const std::vector<Vec3> corners{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}};
  const Body b = w.add({.shape = hull(corners), .mass = 1});
  w.add(Thruster{.body = b, .force = {1, 2, 3}, .at = {Real(0.5), Real(0.5), Real(0.5)}});
  step(w, 100);
  expect_near(w[b].velocity(), Vec3d{1, 2, 3}, 1e-5);
  expect_near(w[b].spin(), Vec3d{}, 1e-5);
}

// A push acts during one step, all its sub-steps, and is forgotten.
TEST(Push, ActsForOneStep) {
  for (const int substeps : {1, 5}) {
    World w(steady(0.01, substeps));
    const Body b = w.add({.shape = sphere(0.5), .mass = 2});
    w.push(b, {0, 6, 0}, {1, 0, 0});
    w.push(b, {0, 2, 0}, {0, 0, 0});
    w.step();
    w.step();
    expect_near(w[b].velocity(), Vec3d{0, 8 * 0.01 / 2, 0}, 1e-8);
    expect_near(w[b].spin(), Vec3d{0, 0, 6 * 0.01 / (0.4 * 2 * 0.25)}, 1e-6);
  }
}

TEST(Twist, ActsForOneStep) {
  World w(steady(0.01, 5));
  const Body b = w.add({.shape = sphere(0.5), .mass = 2});
  w.twist(b, {0, 0, 6});
  w.step();
  w.step();
  expect_near(w[b].velocity(), Vec3d{}, 1e-8);
  expect_near(w[b].spin(), Vec3d{0, 0, 6 * 0.01 / (0.4 * 2 * 0.25)}, 1e-6);
}

// k multiplies the simulated step; sub-steps divide it.
TEST(TimeFactor, IsSimulatedTimePerStep) {
  Config fast = steady(0.01), slow = steady(0.03);
  fast.time_factor = 3;
  World a(fast), b(slow);
  for (World* w : {&a, &b}) {
    w->add(Gravity{});
    w->add({.shape = sphere(1), .velocity = {1, 5, 0}, .spin = {1, 2, 3}});
    step(*w, 50);
  }
  EXPECT_DOUBLE_EQ(a.time(), 1.5);
  EXPECT_DOUBLE_EQ(b.time(), 1.5);
  EXPECT_EQ(a.motion_hash(), b.motion_hash());
}

}
}
