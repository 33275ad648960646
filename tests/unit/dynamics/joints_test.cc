// Joints: each kind holds what it should, leaves free what it should, conserves momentum, and reports its load.
#include <functional>

#include "unit/random.h"
#include "unit/worlds.h"

namespace sudar_test {
namespace {

constexpr Vec3 x_axis{1, 0, 0}, y_axis{0, 1, 0}, z_axis{0, 0, 1};

// Every kind of joint between two bodies, the world where one is null, with its anchor at `at`.
struct Kind {
  const char* name;
  std::function<JointDef(Body, Body, const Pos&)> make;
  double gap;  // m, that a second of tumbling may leave
};
const Kind kinds[] = {
    {"bar", [](Body a, Body b, const Pos& p) { return Bar{.a = a, .b = b, .at_a = p, .at_b = p + y_axis}; }, 2e-3},
    {"rope", [](Body a, Body b, const Pos& p) { return Rope{.a = a, .b = b, .at_a = p, .at_b = p + y_axis}; }, 2e-3},
    {"ball", [](Body a, Body b, const Pos& p) { return Ball{.a = a, .b = b, .at = p}; }, 2e-3},
    {"hinge", [](Body a, Body b, const Pos& p) { return Hinge{.a = a, .b = b, .at = p}; }, 2e-3},
    {"slider", [](Body a, Body b, const Pos& p) { return Slider{.a = a, .b = b, .at = p, .axis = y_axis}; }, 5e-3},
    {"fixed", [](Body a, Body b, const Pos& p) { return Fixed{.a = a, .b = b, .at = p}; }, 2e-3},
    {"plane", [](Body a, Body b, const Pos& p) { return Plane{.a = a, .b = b, .at = p, .normal = y_axis}; }, 2e-3},
    {"muscle",
     [](Body a, Body b, const Pos& p) {
       return Muscle{.a = a, .b = b, .at_a = p, .at_b = p + y_axis, .drive = {DriveMode::servo, Real(0.5), 3}};
     },
     2e-3},
};

// Two different bodies that tumble freely, tied together, keep their momentum; the joint holds. Angular momentum is
// kept up to gap × impulse, and up to what the pseudo velocities move: a thousandth here.
TEST(Joints, ConserveMomentumAndHold) {
  Random random(5);
  for (const Kind& kind : kinds) {
    for (int k = 0; k < 5; ++k) {
      World w(steady(1.0 / 60, 4));
      const auto vector = [&](double size) { return convert<Real>(random.in_cube(size)); };
      const Body a = w.add({.shape = box({1, 2, 3}), .velocity = vector(1), .spin = vector(1), .density = 1});
      const Body b = w.add({.shape = box({2, 1, 1}),
                            .at = {2, 3, 0},
                            .turn = convert<Real>(random.rotation()),
                            .velocity = vector(1),
                            .spin = vector(1),
                            .density = 2});
      const Joint j = w.join(kind.make(a, b, {1, 1.5, 0.5}));
      const Momentum before = w.momentum();
      for (int i = 0; i < 60; ++i) {
        w.step();
        EXPECT_LT(w[j].gap(), kind.gap) << kind.name;
      }
      const Momentum after = w.momentum();
      expect_near(after.linear, before.linear, by_precision(1e-4, 1e-10));
      expect_near(after.angular, before.angular, 1e-3 * length(before.angular) + 0.01);
    }
  }
}

// The energy of that free pair does not grow.
TEST(Joints, DoNotMakeEnergy) {
  for (const Kind& kind : kinds) {
    World w(steady(1.0 / 60, 4));
    const Body a = w.add({.shape = box({1, 2, 3}), .spin = {1, 2, 1}, .density = 1});
    const Body b = w.add({.shape = box({2, 1, 1}), .at = {2, 3, 0}, .velocity = {0, 1, 1}, .density = 2});
    w.join(kind.make(a, b, {1, 1.5, 0.5}));
    w.step();  // the joint takes what it does not allow
    const double energy = w.energy().kinetic;
    for (int i = 0; i < 300; ++i) {
      w.step();
      ASSERT_LT(w.energy().kinetic, energy * (1 + 1e-3)) << kind.name << " after " << i;
    }
  }
}

// At rest under gravity each joint carries what it must: the load is force and torque on b about its anchor.
TEST(Load, OfAWeightAtRest) {
  const double weight = 2 * 9.81;
  for (const bool world_is_a : {true, false}) {
    World w(steady(1.0 / 60, 4));
    w.add(Gravity{});
    const Body b = w.add({.shape = box({1, 1, 1}), .at = {3, 0, 0}, .mass = 2});
    const Body first = world_is_a ? Body{} : b, second = world_is_a ? b : Body{};
    const Joint j = w.join(Fixed{.a = first, .b = second, .at = {1, 0, 0}});  // a cantilever of 2 m
    step(w, 120);
    const double sign = world_is_a ? 1 : -1;
    expect_near(w[j].load().force, Vec3d{0, sign * weight, 0}, 0.01 * weight);
    expect_near(w[j].load().torque, Vec3d{0, 0, sign * 2 * weight}, 0.01 * weight);
    EXPECT_LT(w[j].gap(), 1e-3);
    EXPECT_NEAR(w[b].pose().p.y, 0, 5e-3);
  }
}
TEST(Load, OfAHangingRod) {
  const auto hang = [](const std::function<JointDef(Body)>& make) {
    World w(steady(1.0 / 60, 4));
    w.add(Gravity{});
    const Body rod = w.add({.shape = box({Real(0.1), 2, Real(0.1)}), .at = {0, -1, 0}, .mass = 3});
    const Joint j = w.join(make(rod));
    step(w, 120);
    expect_near(w[j].load().force, Vec3d{0, 3 * 9.81, 0}, 1e-3 * 3 * 9.81);
    expect_near(w[j].load().torque, Vec3d{}, 1e-3);
    EXPECT_LT(w[j].gap(), 1e-4);
  };
  hang([](Body rod) { return Hinge{.b = rod, .at = {0, 0, 0}}; });
  hang([](Body rod) { return Ball{.b = rod, .at = {0, 0, 0}}; });
  hang([](Body rod) { return Bar{.b = rod, .at_a = {0, 2, 0}, .at_b = {0, 0, 0}}; });
  hang([](Body rod) { return Rope{.b = rod, .at_a = {0, 2, 0}, .at_b = {0, 0, 0}}; });
  hang([](Body rod) { return Plane{.b = rod, .at = {0, 0, 0}}; });
  hang([](Body rod) { return Slider{.b = rod, .at = {0, 0, 0}, .axis = x_axis}; });
}

// A chain's links each carry what hangs below.
TEST(Load, GrowsUpAChain) {
  World w(steady(1.0 / 60, 4));
  w.add(Gravity{});
  std::vector<Joint> joints;
  Body above;
  for (int i = 0; i < 5; ++i) {
    const Body link = w.add({.shape = box({Real(0.1), 1, Real(0.1)}), .at = {0, -0.5 - i, 0}, .mass = 1});
    joints.push_back(w.join(Ball{.a = above, .b = link, .at = {0, -double(i), 0}}));
    above = link;
  }
  step(w, 300);
  for (int i = 0; i < 5; ++i) {
    expect_near(w[joints[std::size_t(i)]].load().force, Vec3d{0, (5 - i) * 9.81, 0}, 0.01 * 9.81);
  }
}

TEST(Bar, KeepsItsLength) {
  World w(steady(1.0 / 60, 4));
  w.add(Gravity{});
  const Body b = w.add({.shape = sphere(0.1), .at = {2, 0, 0}, .mass = 1});
  const Joint j = w.join(Bar{.b = b, .at_a = {0, 0, 0}, .at_b = {2, 0, 0}});
  for (int i = 0; i < 600; ++i) {
    w.step();
    ASSERT_NEAR(distance(w[j].anchor_a(), w[j].anchor_b()), 2, 0.01);
  }
}

// Free fall until it is taut, then never longer than its length; shorter again whenever it likes.
TEST(Rope, IsFreeWhileSlack) {
  World w(steady(1.0 / 60, 4));
  w.add(Gravity{});
  const Body b = w.add({.shape = sphere(0.1), .at = {0, -1, 0}, .mass = 1});
  const Joint j = w.join(Rope{.b = b, .at_a = {0, 0, 0}, .at_b = {0, -1, 0}, .length = 3});
  for (int i = 0; i < 30; ++i) {
    w.step();
    ASSERT_EQ(length(w[j].load().force), 0);
  }
  const double h = 1.0 / 240, n = 120;
  EXPECT_NEAR(w[b].center().y, -1 - 0.5 * 9.81 * h * h * n * (n + 1), 1e-5);
  step(w, 90);
  EXPECT_NEAR(w[b].center().y, -3, 1e-3);
  EXPECT_NEAR(w[j].load().force.y, 9.81, 0.01);
  w.set_velocity(b, {0, 5, 0}, {});
  step(w, 15);
  EXPECT_GT(w[b].center().y, -2.5);
}

// A rod pendulum of 1 m: V07's period and energy.
TEST(Hinge, PendulumHasItsPeriod) {
  World w(steady(1.0 / 60, 16));
  w.add(Gravity{});
  const double angle = pi / 6;
  const Quat turn = axis_angle(z_axis, Real(angle));
  const Body rod = w.add({.shape = box({Real(0.02), 1, Real(0.02)}),
                          .at = Pos{} + rotate(turn, Vec3{0, Real(-0.5), 0}),
                          .turn = turn,
                          .mass = 1});
  const Joint j = w.join(Hinge{.b = rod, .at = {0, 0, 0}});
  const double start = w.energy().total();
  double previous = 0, period = 0;
  for (int i = 0; i < 120; ++i) {
    w.step();
    const double speed = w[rod].spin().z;
    if (previous < 0 && speed >= 0 && period == 0) period = 2 * (w.time() - speed / (speed - previous) / 60);
    previous = speed;
    ASSERT_NEAR(w[rod].spin().x, 0, 1e-4);
    EXPECT_LT(w[j].gap(), 1e-5);
  }
  EXPECT_NEAR(period, 1.6664612665, 0.0005);
  EXPECT_NEAR(w.energy().total() - start, 0, 0.0002 * 9.81 * 0.5 * (1 - std::cos(angle)));
}

// The coordinate counts turns: it does not jump at ±π.
TEST(Hinge, CoordinateUnwinds) {
  World w(steady(0.01));
  const Body b = w.add({.shape = sphere(1), .spin = {0, 0, 3}});
  const Joint j = w.join(Hinge{.b = b, .at = {0, 0, 0}});
  for (int i = 1; i <= 1000; ++i) {
    w.step();
    ASSERT_NEAR(w[j].coordinate(), 0.03 * i, 0.01 * i / 100 + 1e-3);
  }
}
TEST(Hinge, KeepsItsAxis) {
  World w(steady(0.01));
  const Vec3 axis = normalize(Vec3{1, 2, 3});
  const Body b = w.add({.shape = box({1, 2, 3}), .spin = axis * Real(2)});
  w.join(Hinge{.b = b, .at = {0, 0, 0}, .axis = axis});
  step(w, 300);
  EXPECT_NEAR(dot(rotate(w[b].pose().q, axis), axis), 1, 1e-5);
  EXPECT_NEAR(dot(w[b].spin(), axis), 2, 0.05);
}

// Down an incline of 45° without friction: g sin 45°; the travel is the way, and nothing turns.
TEST(Slider, SlidesAlongItsAxis) {
  World w(steady(0.01));
  w.add(Gravity{});
  const Vec3 axis = normalize(Vec3{1, -1, 0});
  const Body b = w.add({.shape = box({1, 2, 1}), .at = {0, 1, 0}, .mass = 2});
  const Joint j = w.join(Slider{.b = b, .at = {0, 0, 0}, .axis = axis});
  step(w, 100);
  const double way = 0.5 * 9.81 * std::sqrt(0.5);
  EXPECT_NEAR(w[j].coordinate(), way, 1e-3);
  expect_near(w[b].center(), Pos{way * std::sqrt(0.5), 1 - way * std::sqrt(0.5), 0}, 1e-3);
  EXPECT_NEAR(w[b].pose().q.w, 1, 1e-6);
}

// A ball on a plane through its centre: it slides freely there, and does not leave it.
TEST(Plane, LeavesTwoDirectionsFree) {
  World w(steady(0.01));
  w.add(Gravity{});
  const Body b = w.add({.shape = sphere(1), .velocity = {1, 0, 2}, .spin = {1, 2, 3}});
  w.join(Plane{.b = b, .at = {0, 0, 0}});
  step(w, 100);
  expect_near(w[b].center(), Pos{1, 0, 2}, 1e-4);
  expect_near(w[b].spin(), Vec3d{1, 2, 3}, 1e-4);
}

TEST(Ball, LeavesTurningFree) {
  World w(steady(0.01));
  const Body b = w.add({.shape = sphere(1), .spin = {1, 2, 3}});
  w.join(Ball{.b = b, .at = {0, 0, 0}});
  step(w, 100);
  expect_near(w[b].spin(), Vec3d{1, 2, 3}, 1e-4);
}

// Joined bodies touch each other only if the joint says so.
TEST(Joints, DecideWhetherTheirBodiesTouch) {
  for (const bool collide : {false, true}) {
    World w(steady(0.01));
    const Body a = w.add(cube({0, 0, 0})), b = w.add(cube({0.9, 0, 0}));
    const Joint j = w.join(Ball{.a = a, .b = b, .at = {0.45, 0, 0}, .collide = collide});
    w.step();
    EXPECT_EQ(w.touching(a, b), collide);
    w.remove(j);
    w.step();
    EXPECT_TRUE(w.touching(a, b));
  }
}

}
}
