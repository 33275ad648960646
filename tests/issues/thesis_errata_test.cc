// The mistakes of the thesis (docs/thesis.md lists them), each with a test that fails where it is made again.
#include <gtest/gtest.h>

#include <sudar/world.h>

#include <random>

using namespace sudar;

namespace {

Config thesis_steps(double dt = 0.01) {
  Config c;
  c.dt = dt;
  c.substeps = 1;
  c.sleep = false;
  c.friction_mix = Mix::min;
  return c;
}

BodyDef floor_at(double y) {
  return {.shape = half_space(), .at = {0, y, 0}, .material = {100, 100, 0}, .motion = Motion::fixed};
}

// thesis erratum volume: with a·(b × c)/4 this box had the volume 36.
TEST(ThesisErrata, VolumeOfATetrahedronIsASixth) {
  EXPECT_NEAR(box({2, 3, 4}).mass_properties().volume, 24, 24 * 1e-6);
  EXPECT_NEAR(tetrahedron(2).mass_properties().volume, 8 / (6 * sqrt(2.0)), 1e-6);
}

// thesis erratum drag: −B v² pushes a body that flies backwards ever faster.
TEST(ThesisErrata, DragOpposesMotionInBothDirections) {
  for (double way : {-1.0, 1.0}) {
    World w(thesis_steps());
    w.add(Drag{.quadratic = 0.5});
    const Body b = w.add({.shape = sphere(1), .velocity = {0, Real(10 * way), 0}});
    for (int i = 0; i < 100; ++i) w.step();
    EXPECT_NEAR(w[b].velocity().y, way * 10 / (1 + 0.5 * 10), 0.02);  // v = v₀ / (1 + B v₀ t)
  }
}

// The explicit form turns the velocity round as soon as h (A + B|v|) > 1.
TEST(ThesisErrata, DragNeverOvershoots) {
  Config c = thesis_steps();
  c.time_factor = 1e5;
  World w(c);
  w.add(Drag{.linear = 0.3, .quadratic = 0.5});
  const Body b = w.add({.shape = sphere(1), .velocity = {10, 0, 0}});
  w.step();
  EXPECT_GE(w[b].velocity().x, 0);
  EXPECT_LT(w[b].velocity().x, 0.01);
}

// thesis erratum sliding: a ball of 0.1 m meets the floor with (3, −4) m/s, e = 0.5, μ = 0.1. It slips throughout, so
// friction takes μ (1+e) 4 = 0.6 m/s, and gives the spin 5/2 · 0.6 / 0.1.
TEST(ThesisErrata, SlidingImpulseFollowsFromTheSpeedOfApproach) {
  for (bool per_increment : {false, true}) {
    Config c = thesis_steps();
    c.impulse_2007.friction_per_increment = per_increment;
    World w(c);
    w.add(floor_at(0));
    const Body b =
        w.add({.shape = sphere(0.1), .at = {0, 0.1, 0}, .velocity = {3, -4, 0}, .material = {0.1, 0.1, 0.5}});
    w.step();
    EXPECT_NEAR(w[b].velocity().x, 2.4, 1e-3);
    EXPECT_NEAR(w[b].velocity().y, 2.0, 1e-3);
    EXPECT_NEAR(w[b].spin().z, -15, 0.01);
  }
}

// thesis erratum bar: K⁻¹(−u_n n) is not parallel to the bar, and adds energy in every sixth random state.
TEST(ThesisErrata, BarPushesAlongItselfAndAddsNoEnergy) {
  std::mt19937 random(7);
  const auto uniform = [&random] { return Real(random()) / Real(random.max()) * 2 - 1; };
  const auto vector = [&uniform](Real scale) { return Vec3{uniform(), uniform(), uniform()} * scale; };
  for (int i = 0; i < 200; ++i) {
    World w(thesis_steps(1e-5));
    const Quat turn = rotation(vector(2));
    const Body a =
        w.add({.shape = box({4, 1, 1}), .turn = turn, .velocity = vector(3), .spin = vector(3), .density = 1});
    const Body b =
        w.add({.shape = box({1, 2, 3}), .at = {6, 1, 0}, .velocity = vector(3), .spin = vector(3), .density = 2});
    const Pos at_a = Pos{} + vector(2), at_b = Pos{6, 1, 0} + vector(2);
    w.join(Bar{.a = a, .b = b, .at_a = at_a, .at_b = at_b});
    const double before = w.energy().kinetic;
    const Vec3 velocity = w[a].velocity();
    w.step();
    EXPECT_LE(w.energy().kinetic, before * (1 + 1e-5));
    const Vec3 along = normalize(at_b - at_a), change = w[a].velocity() - velocity;
    EXPECT_LT(length(cross(change, along)), 1e-3 * (length(change) + 0.1)) << "state " << i;
  }
}

// thesis erratum correction: as an impulse, Δu_e would push a light body out fast and a heavy one slowly. As a velocity
// it takes every body the share b of its overlap beyond δ_max nearer, and leaves its real velocity alone.
TEST(ThesisErrata, CorrectionIsAVelocity) {
  for (double mass : {1.0, 1000.0}) {
    World w(thesis_steps());
    w.add(floor_at(0));
    const Body b = w.add({.shape = box({1, 1, 1}), .at = {0, 0.5 - 0.11, 0}, .mass = Real(mass)});
    w.step();
    EXPECT_NEAR(w[b].pose().p.y, 0.5 - 0.11 + 0.2 * (0.11 - 0.01), 1e-4);
    EXPECT_NEAR(w[b].velocity().y, 0, 1e-6);
  }
}

// thesis erratum cost: n sub-steps cost n times as much; the world does not run faster.
TEST(ThesisErrata, SubStepsMultiplyTheCost) {
  std::int64_t passes[2] = {};
  for (int n : {1, 4}) {
    Config c = thesis_steps();
    c.substeps = n;
    World w(c);
    w.add(Gravity{});
    w.add(floor_at(0));
    w.add({.shape = box({1, 1, 1}), .at = {0, 0.5, 0}, .velocity = {1, 0, 0}});
    w.step();
    EXPECT_DOUBLE_EQ(w.time(), 0.01);
    passes[n == 4] = w.profile().contact.used;
  }
  EXPECT_GE(passes[0], 1);
  EXPECT_GE(passes[1], 4);
  EXPECT_GT(passes[1], passes[0]);
}

// How far a train of ten wagons of 90 kg, pulled with 660 N where friction holds 675 N, has moved after 2 s.
double train_moved(bool friction_per_increment) {
  Config c = thesis_steps();
  c.impulse_2007.friction_per_increment = friction_per_increment;
  World w(c);
  w.add(Gravity{{0, -5, 0}});
  w.add(floor_at(-1.5));
  Body last, first;
  for (int i = 0; i < 10; ++i) {
    const Body wagon =
        w.add({.shape = box({10, 3, 3}), .at = {11.0 * i, 0, 0}, .density = 1, .material = {0.15, 0.1, 0}});
    if (i == 0) first = wagon;
    for (double y : {-1.0, 1.0}) {
      if (i > 0) w.join(Ball{.a = last, .b = wagon, .at = {11 * i - 5.5, y, 0}});
    }
    last = wagon;
  }
  w.add(Thruster{.body = first, .force = {-660, 0, 0}});
  for (int i = 0; i < 200; ++i) w.step();
  return -w[first].pose().p.x;
}

// thesis erratum cone
TEST(ThesisErrata, FrictionConeLimitsTheAccumulatedImpulse) {
  EXPECT_LT(abs(train_moved(false)), 1e-6);
  EXPECT_GT(train_moved(true), 1e-3);
}

// How far the worst cube of a slightly crooked tower of ten has moved sideways after 10 s, m.
double tower_drift(bool one_point_contact) {
  Config c = thesis_steps();
  c.impulse_2007.one_point_contact = one_point_contact;
  World w(c);
  w.add(Gravity{{0, -5, 0}});
  w.add(floor_at(-8));
  const auto place = [](int i) { return Pos{i % 2 == 0 ? 0.1 : -0.1, -5.9 + 4.1 * i, 0}; };
  std::vector<Body> cubes;
  for (int i = 0; i < 10; ++i) {
    cubes.push_back(w.add({.shape = box({4, 4, 4}), .at = place(i), .density = 1, .material = {0.5, 0.5, 0}}));
  }
  for (int i = 0; i < 1000; ++i) w.step();
  double worst = 0;
  for (int i = 0; i < 10; ++i) {
    const Vec3 way = w[cubes[std::size_t(i)]].pose().p - place(i);
    worst = max(worst, double(max(abs(way.x), abs(way.z))));
  }
  return worst;
}

// thesis erratum one-point
TEST(ThesisErrata, OnePointCarriesNoTiltingMoment) {
  EXPECT_LT(tower_drift(false), 0.02);
  EXPECT_GT(tower_drift(true), 1);
}

}
