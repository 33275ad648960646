// A rod hinged at its end, with no gravity and a servo of 30 N m, was to turn by 45° and went to 70.4° first; 540°
// ended at 751.5°. The brake counted the inertia about the centre of mass of the two bodies alone, not that about the
// axis of all that hangs on it. Whatever a servo moves, it gets there without overshoot in the time of the bang-bang
// optimum: full force half the way, full brake the other half, 2 √(way · inertia / force).
#include <functional>

#include "unit/worlds.h"

namespace sudar_test {
namespace {

constexpr Vec3 x_axis{1, 0, 0}, z_axis{0, 0, 1};

// Where it went: as shares of the way and of the optimum.
struct Course {
  double overshoot = 0, time = 0, left = 0;
};

Course follow(World& w, Joint j, double target, double inertia, double force,
              const std::function<void(double)>& on_the_way = {}) {
  const double start = w[j].coordinate(), way = target - start, best = 2 * std::sqrt(std::fabs(way) * inertia / force);
  w.set_drive(j, {.mode = DriveMode::servo, .target = Real(target), .force = Real(force)});
  Course c;
  double farthest = 0, settled = 0;
  const double from = w.time();
  while (w.time() - from < 1.5 * best + 0.2) {
    w.step();
    const double done = (w[j].coordinate() - start) / way;
    farthest = std::max(farthest, done);
    if (std::fabs(done - 1) > 2e-4) settled = w.time() - from;
    if (on_the_way) on_the_way(done);
  }
  c.overshoot = farthest - 1, c.time = settled / best;
  c.left = std::fabs(w[j].coordinate() - target) / std::fabs(way);
  return c;
}

// Where 0.02 % of the way are left, a hundredth of the time is too; and time is seen once a step.
void expect_optimal(const Course& c, const std::string& what) {
  EXPECT_LT(c.overshoot, 1e-3) << what;
  EXPECT_LT(c.left, 1e-4) << what;
  EXPECT_LT(c.time, 1.02) << what;
  EXPECT_GT(c.time, 0.94) << what;
}

BodyDef rod(const Pos& at, double length = 1, double mass = 2) {
  return {.shape = box({Real(length), Real(0.1), Real(0.1)}), .at = at, .mass = Real(mass)};
}
double about_end(double length, double mass) {
  return mass * (length * length + 0.01) / 12 + mass * length * length / 4;
}

struct Steps {
  double dt;
  int substeps;
};
constexpr Steps all_steps[] = {{1.0 / 60, 4}, {1.0 / 60, 16}, {1.0 / 500, 1}};
std::string name(const Steps& s) { return std::to_string(1 / s.dt) + " Hz × " + std::to_string(s.substeps); }

TEST(ServoInertia, ARodHingedAtItsEnd) {
  for (const Steps& s : all_steps) {
    for (const double degrees : {45.0, 90.0, 180.0, 540.0}) {
      World w(steady(s.dt, s.substeps));
      const Body b = w.add(rod({0.5, 0, 0}));
      const Joint j = w.join(Hinge{.b = b, .axis = z_axis});
      expect_optimal(follow(w, j, degrees * pi / 180, about_end(1, 2), 30), name(s) + ", " + std::to_string(degrees));
    }
  }
}

TEST(ServoInertia, AFarAxis) {  // I/I_c = 1 + 12 · 2² = 47
  World w(steady(1.0 / 60, 4));
  const Body b = w.add(rod({2, 0, 0}));
  const double about_center = 2 * 1.01 / 12;
  expect_optimal(follow(w, w.join(Hinge{.b = b, .axis = z_axis}), 1, about_center + 2 * 4, 30), "far axis");
}

// Two free bodies: in the middle of the hinge's coordinate counts what both together answer.
TEST(ServoInertia, TwoFreeRods) {
  World w(steady(1.0 / 60, 8));
  const Body a = w.add(rod({-0.5, 0, 0})), b = w.add(rod({1, 0, 0}, 2, 1));
  const Joint j = w.join(Hinge{.a = a, .b = b, .axis = z_axis});
  const Course c = follow(w, j, 0.05, 1, 30);
  EXPECT_LT(c.overshoot, 1e-3);
  EXPECT_LT(c.left, 1e-3);
  for (const double target : {1.5, -0.5}) {
    const Course far = follow(w, j, target, 0.4, 30);
    EXPECT_LT(far.overshoot, 1e-3) << target;
    EXPECT_LT(far.left, 1e-3) << target;
  }
}
TEST(ServoInertia, TwoFreeDiscs) {  // side by side on one axle: 1/I = 1/I_a + 1/I_b
  World w(steady(1.0 / 60, 8));
  const Body a = w.add({.shape = sphere(1), .mass = 10}), b = w.add({.shape = sphere(1), .at = {0, 0, 2}, .mass = 5});
  expect_optimal(follow(w, w.join(Hinge{.a = a, .b = b, .axis = z_axis}), 3, 1 / (1 / 4.0 + 1 / 2.0), 8), "discs");
}

TEST(ServoInertia, AChainOfThreeThatIsLocked) {
  for (const Steps& s : all_steps) {
    World w(steady(s.dt, s.substeps));
    Body links[3];
    double inertia = 0;
    for (int i = 0; i < 3; ++i) {
      links[i] = w.add(rod({i + 0.5, 0, 0}));
      inertia += 2 * 1.01 / 12 + 2 * square(i + 0.5);
      if (i > 0) w.join(Fixed{.a = links[i - 1], .b = links[i], .at = {double(i), 0, 0}});
    }
    const Joint j = w.join(Hinge{.b = links[0], .axis = z_axis});
    expect_optimal(follow(w, j, 2, inertia, 100), name(s));
  }
}

// Two more servos hold the rest of the chain straight.
TEST(ServoInertia, AChainOfThreeThatServosHold) {
  World w(steady(1.0 / 60, 8));
  Body links[3];
  double inertia = 0;
  for (int i = 0; i < 3; ++i) {
    links[i] = w.add(rod({i + 0.5, 0, 0}));
    inertia += 2 * 1.01 / 12 + 2 * square(i + 0.5);
    if (i == 0) continue;
    w.join(Hinge{.a = links[i - 1],
                 .b = links[i],
                 .at = {double(i), 0, 0},
                 .axis = z_axis,
                 .drive = {.mode = DriveMode::servo, .force = 500}});
  }
  expect_optimal(follow(w, w.join(Hinge{.b = links[0], .axis = z_axis}), 2, inertia, 100), "held by servos");
}

// All three turn at once, to and fro; none goes past its goal.
TEST(ServoInertia, AChainOfThreeServos) {
  World w(steady(1.0 / 60, 8));
  Body links[3];
  Joint joints[3];
  for (int i = 0; i < 3; ++i) {
    links[i] = w.add(rod({i + 0.5, 0, 0}));
    joints[i] =
        w.join(Hinge{.a = i > 0 ? links[i - 1] : Body{}, .b = links[i], .at = {double(i), 0, 0}, .axis = z_axis});
  }
  const double goals[3] = {1, -0.8, 0.6};
  for (int i = 0; i < 3; ++i) {
    w.set_drive(joints[i], {.mode = DriveMode::servo, .target = Real(goals[i]), .force = Real(100 - 30 * i)});
  }
  double most = 0;
  for (int n = 0; n < 300; ++n) {
    w.step();
    for (int i = 0; i < 3; ++i) most = std::max(most, double(w[joints[i]].coordinate()) / goals[i] - 1);
  }
  EXPECT_LT(most, 0.02);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(w[joints[i]].coordinate(), goals[i], 1e-3);
}

// A load that is fixed to the moving rod on the way, heavier than the rod.
TEST(ServoInertia, ALoadPickedUpOnTheWay) {
  for (const double when : {0.1, 0.3, 0.45, 0.7}) {
    World w(steady(1.0 / 60, 8));
    const Body b = w.add(rod({0.5, 0, 0}));
    const Joint j = w.join(Hinge{.b = b, .axis = z_axis});
    bool carried = false;
    const Course c = follow(w, j, 2.5, about_end(1, 2) + 3, 30, [&](double done) {
      if (done < when || carried) return;
      carried = true;
      const double angle = w[j].coordinate();
      const Pos end{std::cos(angle), std::sin(angle), 0};
      const Body load = w.add({.shape = sphere(Real(0.1)), .at = end, .mass = 3, .filter = {.mask = 0}});
      w.join(Fixed{.a = b, .b = load, .at = end});
    });
    EXPECT_TRUE(carried);
    EXPECT_LT(c.overshoot, 1e-3) << when;
    EXPECT_LT(c.left, 1e-3) << when;
    EXPECT_LT(c.time, 1.05) << when;
  }
}

TEST(ServoInertia, ASliderThatCarriesMore) {
  for (const Steps& s : all_steps) {
    World w(steady(s.dt, s.substeps));
    const Body cart = w.add(rod({0, 0, 0})), load = w.add(rod({0, 3, 0}, 1, 5));
    w.join(Fixed{.a = cart, .b = load, .at = {0, 1, 0}});
    expect_optimal(follow(w, w.join(Slider{.b = cart, .axis = x_axis}), 4, 7, 20), name(s));
  }
}

TEST(ServoInertia, AMuscleOnAHangingLoad) {  // along the line: the mass; the bodies' turning does not count
  World w(steady(1.0 / 60, 8));
  const Body b = w.add(rod({0, -3, 0})), load = w.add(rod({0, -4, 0}, 1, 5));
  w.join(Fixed{.a = b, .b = load, .at = {0, -3.5, 0}});
  expect_optimal(follow(w, w.join(Muscle{.b = b, .at_b = {0, -3, 0}}), 1, 7, 20), "muscle");
}

// A muscle that turns a hinged rod by a short lever: the mass along it is I/lever², and changes on the way.
TEST(ServoInertia, AMuscleOnALever) {
  World w(steady(1.0 / 60, 8));
  const Body b = w.add(rod({0.5, 0, 0}));
  w.join(Hinge{.b = b, .axis = z_axis});
  const Joint j = w.join(Muscle{.b = b, .at_a = {0, 1, 0}, .at_b = {0.3, 0, 0}});
  const double start = w[j].coordinate();
  for (const double target : {start - 0.15, start + 0.1}) {
    const Course c = follow(w, j, target, about_end(1, 2) / square(0.28), 200);
    EXPECT_LT(c.overshoot, 2e-3) << target;
    EXPECT_LT(c.left, 1e-3) << target;
  }
}

// Gravity helps or hinders: the work that it does on the way counts.
TEST(ServoInertia, AnArmThatIsLiftedAndLowered) {
  World w(steady(1.0 / 60, 8));
  w.add(Gravity{});
  const Body b = w.add(rod({0.5, 0, 0}));
  const Joint j = w.join(Hinge{.b = b, .axis = z_axis});
  for (const double target : {1.2, -1.0, 2.0, -0.5}) {  // 9.81 N m at most
    const Course c = follow(w, j, target, 4 * about_end(1, 2), 30);
    EXPECT_LT(c.overshoot, 1e-3) << target;
    EXPECT_LT(c.left, 1e-3) << target;
  }
}

}
}
