// A block of 0.5 × 2 m that rocks was put to sleep at its turning point when it was stepped with 3840 Hz, and never came
// back; a mass on a spring was stopped before its equilibrium, and a can on a slope fell asleep after four steps. The
// rule counted steps and looked at speed alone. What sleeps was quiet for half a second, whatever the steps, and is where
// it would have come to rest.
#include <functional>

#include "unit/worlds.h"

namespace sudar_test {
namespace {

struct Scene {
  World w;
  Body body;
};
using Build = std::function<Scene(const Config&)>;

Config stepped(double dt, int substeps, bool sleeps) {
  Config c = steady(dt, substeps);
  c.sleep = sleeps;
  return c;
}

// Runs the scene with sleep and without; returns how far apart they are at the end, and when it fell asleep (−1: never).
struct Outcome {
  double apart = 0, turned = 0, asleep = -1;
};
Outcome compare(const Build& build, double dt, int substeps, double seconds, double longer = 0) {
  Scene with = build(stepped(dt, substeps, true)), without = build(stepped(dt, substeps, false));
  Outcome out;
  for (int n = 0; n * dt < seconds; ++n) {
    with.w.step();
    if (with.w[with.body].asleep() && out.asleep < 0) out.asleep = with.w.time();
  }
  for (int n = 0; n * dt < seconds + longer; ++n) without.w.step();
  out.apart = distance(with.w[with.body].center(), without.w[without.body].center());
  const Quat p = with.w[with.body].pose().q, q = without.w[without.body].pose().q;
  out.turned = double(length(rotation_vector(p * conjugate(q))));
  return out;
}

struct Steps {
  double dt;
  int substeps;
};
constexpr Steps all_steps[] = {{1.0 / 60, 1}, {1.0 / 60, 4}, {1.0 / 240, 4}, {1.0 / 3840, 1}};

void expect_same(const Build& build, double seconds, bool sleeps, const char* what, double longer = 0) {
  for (const Steps& s : all_steps) {
    const Outcome o = compare(build, s.dt, s.substeps, seconds, longer);
    EXPECT_LT(o.apart, 1e-5) << what << ", " << s.dt << " × " << s.substeps << ", asleep at " << o.asleep;
    EXPECT_LT(o.turned, 2e-5) << what << ", " << s.dt << " × " << s.substeps << ", asleep at " << o.asleep;
    if (sleeps) {
      EXPECT_GT(o.asleep, 0.5) << what << ", " << s.dt << " × " << s.substeps;
    } else {
      EXPECT_LT(o.asleep, 0) << what << ", " << s.dt << " × " << s.substeps;
    }
  }
}

TEST(EarlySleep, ARockingBlockComesBack) {
  expect_same(
      [](const Config& c) {
        Scene s{World(c), {}};
        s.w.add(Gravity{});
        add_floor(s.w);
        const double tilt = 0.2, x = 0.25, y = 1;  // less than atan(0.25): it falls back, turning about its edge
        const Pos center{-x * std::cos(tilt) + y * std::sin(tilt), x * std::sin(tilt) + y * std::cos(tilt), 0};
        s.body = s.w.add({.shape = box({Real(0.5), 2, Real(0.5)}),
                          .at = center,
                          .turn = rotation(Vec3{0, 0, Real(-tilt)}),
                          .spin = {0, 0, 0}});
        return s;
      },
      1, false, "rocking block");
}

TEST(EarlySleep, SpringsReachTheirEquilibrium) {
  for (const double damping : {0.5, 6.0, 60.0}) {
    expect_same(
        [&](const Config& c) {
          Scene s{World(c), {}};
          s.body = s.w.add(cube({0, 0, 0}));
          s.w.join(Slider{.b = s.body,
                          .drive = {.mode = DriveMode::spring,
                                    .target = 1,
                                    .force = 1000,
                                    .stiffness = 10,
                                    .damping = Real(damping)}});
          return s;
        },
        damping < 1 ? 80 : 100, true, "spring", 40);
  }
}

TEST(EarlySleep, APendulumThatSwingsOutInAir) {
  for (const double length : {0.5, 10.0}) {
    expect_same(
        [&](const Config& c) {
          Scene s{World(c), {}};
          s.w.add(Gravity{});
          s.w.add(Drag{.linear = 1, .angular = 1});
          s.body = s.w.add(cube({length * std::sin(0.1), -length * std::cos(0.1), 0}));
          s.w.join(Hinge{.b = s.body});
          return s;
        },
        60, true, "pendulum", 10);
  }
}

// It rolls on, however slowly.
TEST(EarlySleep, SlowRollersRollOn) {
  expect_same(
      [](const Config& c) {
        Scene s{World(c), {}};
        s.w.add(Gravity{});
        add_floor(s.w);
        s.body = s.w.add({.shape = sphere(Real(0.5)), .at = {0, 0.5, 0}, .velocity = {Real(1e-3), 0, 0},
                          .spin = {0, 0, Real(-2e-3)}});
        return s;
      },
      5, false, "roller");
}

TEST(EarlySleep, ACanOnASlopeStarts) {
  expect_same(
      [](const Config& c) {
        Scene s{World(c), {}};
        s.w.add(Gravity{{Real(9.81 * std::sin(0.001)), Real(-9.81 * std::cos(0.001)), 0}});
        add_floor(s.w);
        s.body = s.w.add({.shape = cylinder(Real(0.5), 1), .at = {0, 0.5, 0}, .turn = rotation(Vec3{Real(pi / 2), 0, 0})});
        return s;
      },
      2, false, "can");
}

// What rests sleeps soon, whatever the steps.
TEST(EarlySleep, StacksSleep) {
  for (const Steps& s : all_steps) {
    World w(stepped(s.dt, s.substeps, true));
    w.add(Gravity{});
    add_floor(w);
    Body cubes[5];
    for (int i = 0; i < 5; ++i) cubes[i] = w.add(cube({0, i + 0.5, 0}));
    while (w.time() < 5) w.step();
    for (const Body b : cubes) EXPECT_TRUE(w[b].asleep()) << s.dt << " × " << s.substeps;
  }
}

}
}
