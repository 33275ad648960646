// Limits stop a joint's free coordinate; drives move it, with no more than their force.
#include "unit/worlds.h"

namespace sudar_test {
namespace {

constexpr Vec3 x_axis{1, 0, 0}, z_axis{0, 0, 1};

struct Rail {  // a cube of 1 kg on a rail along x
  World w{steady(0.01)};
  Body b = w.add(cube({0, 0, 0}));
  Joint j;
  explicit Rail(const Limit& limit = {}, const Drive& drive = {})
      : j(w.join(Slider{.b = b, .at = {0, 0, 0}, .axis = x_axis, .limit = limit, .drive = drive})) {}
  double x() const { return w[j].coordinate(); }
  double speed() const { return w[b].velocity().x; }
};

TEST(Limit, StopsASlider) {
  for (const double way : {-1.0, 1.0}) {
    Rail rail({.low = Real(-1), .high = 2});
    rail.w.set_velocity(rail.b, {Real(3 * way), 0, 0}, {});
    double low = 0, high = 0;
    for (int i = 0; i < 300; ++i) {
      rail.w.step();
      low = std::min(low, rail.x()), high = std::max(high, rail.x());
    }
    EXPECT_GT(low, -1.001);
    EXPECT_LT(high, 2.001);
    EXPECT_NEAR(rail.x(), way > 0 ? 2 : -1, 1e-3);
    EXPECT_NEAR(rail.speed(), 0, 1e-5);
  }
}

TEST(Limit, CarriesAWeight) {
  World w(steady(1.0 / 60, 4));
  w.add(Gravity{});
  const Body b = w.add(cube({0, 0, 0}));
  const Joint j = w.join(Slider{.b = b, .at = {0, 0, 0}, .axis = {0, 1, 0}, .limit = {.low = Real(-0.5)}});
  step(w, 120);
  EXPECT_NEAR(w[j].coordinate(), -0.5, 1e-3);
  expect_near(w[j].load().force, Vec3d{0, 9.81, 0}, 0.01);
}

TEST(Limit, StopsAHinge) {
  World w(steady(1.0 / 60, 4));
  w.add(Gravity{});
  const Body b = w.add({.shape = box({1, Real(0.1), Real(0.1)}), .at = {0.5, 0, 0}, .mass = 1});
  const Joint j = w.join(Hinge{.b = b, .at = {0, 0, 0}, .axis = z_axis, .limit = {.low = Real(-0.6), .high = 1}});
  step(w, 300);
  EXPECT_NEAR(w[j].coordinate(), -0.6, 2e-3);
  EXPECT_NEAR(w[j].load().torque.z, 9.81 * 0.5 * std::cos(0.6), 0.02);
}

// Out of its range at creation: comes back in, without a jump of the real velocity.
TEST(Limit, PullsBackWithoutSpeed) {
  Rail rail({.low = Real(0.5), .high = 2});
  rail.w.step();
  EXPECT_NEAR(rail.speed(), 0, 1e-5);
  step(rail.w, 100);
  EXPECT_NEAR(rail.x(), 0.5, 1e-3);
  EXPECT_NEAR(rail.speed(), 0, 1e-5);
}

// With force F the mass m gains F/m every second, and no more than the target.
TEST(Drive, ReachesItsSpeedWithItsForce) {
  Rail rail({}, {.mode = DriveMode::speed, .target = 2, .force = 4});
  step(rail.w, 25);
  EXPECT_NEAR(rail.speed(), 1, 1e-4);
  step(rail.w, 25);
  EXPECT_NEAR(rail.speed(), 2, 1e-4);
  step(rail.w, 100);
  EXPECT_NEAR(rail.speed(), 2, 1e-4);
}

TEST(Drive, ReachesItsSpeedAtOnceWithoutAForceLimit) {
  Rail rail({}, {.mode = DriveMode::speed, .target = -3, .force = std::numeric_limits<Real>::infinity()});
  rail.w.step();
  EXPECT_NEAR(rail.speed(), -3, 1e-5);
}

TEST(Drive, TurnsAHinge) {
  World w(steady(0.01));
  const Body b = w.add({.shape = sphere(1), .mass = 10});  // I = 4 kg m²
  const Joint j = w.join(
      Hinge{.b = b, .at = {0, 0, 0}, .axis = z_axis, .drive = {.mode = DriveMode::speed, .target = 5, .force = 8}});
  step(w, 100);
  EXPECT_NEAR(w[b].spin().z, 2, 1e-3);
  EXPECT_NEAR(w[j].load().torque.z, 8, 1e-2);
  step(w, 200);
  EXPECT_NEAR(w[b].spin().z, 5, 1e-3);
}

// A weight that is more than the drive's force falls, one that is less is held where it is.
TEST(Drive, HoldsWhatItsForceCanHold) {
  for (const double force : {9.0, 11.0}) {
    World w(steady(0.01));
    w.add(Gravity{});
    const Body b = w.add(cube({0, 0, 0}));
    w.join(Slider{.b = b,
                  .at = {0, 0, 0},
                  .axis = {0, 1, 0},
                  .drive = {.mode = DriveMode::speed, .target = 0, .force = Real(force)}});
    step(w, 100);
    EXPECT_NEAR(w[b].velocity().y, std::min(0.0, force - 9.81), 1e-3);
  }
}

TEST(Drive, OffIsFree) {
  Rail rail({}, {.mode = DriveMode::off, .target = 2, .force = 4});
  rail.w.set_velocity(rail.b, {1, 0, 0}, {});
  step(rail.w, 100);
  EXPECT_NEAR(rail.speed(), 1, 1e-5);
}

// From rest to rest over the way d with the force F takes 2 √(d m/F) at best: a servo needs that, and a few steps; and
// it does not overshoot.
TEST(Servo, IsTimeOptimal) {
  for (const double distance : {0.1, 5.0}) {
    Rail rail({}, {.mode = DriveMode::servo, .target = Real(distance), .force = 1});
    double settled = 0, overshoot = 0;
    for (int i = 0; i < 1000; ++i) {
      rail.w.step();
      overshoot = std::max(overshoot, rail.x() - distance);
      if (std::abs(rail.x() - distance) > 0.002 * distance) settled = rail.w.time();
    }
    const double best = 2 * std::sqrt(distance);
    EXPECT_LT(overshoot, 1e-4) << distance;
    EXPECT_NEAR(settled, best, 0.06 * best + 0.02) << distance;
    EXPECT_NEAR(rail.x(), distance, 1e-4);
    EXPECT_NEAR(rail.speed(), 0, 1e-4);
  }
}

TEST(Servo, KeepsItsSpeedLimit) {
  Rail rail({}, {.mode = DriveMode::servo, .target = 10, .force = 100, .max_speed = 2});
  double fastest = 0;
  for (int i = 0; i < 700; ++i) rail.w.step(), fastest = std::max(fastest, rail.speed());
  EXPECT_NEAR(fastest, 2, 1e-4);
  EXPECT_NEAR(rail.x(), 10, 1e-3);
}

TEST(Servo, HoldsAHingeAgainstAWeight) {
  World w(steady(1.0 / 60, 4));
  w.add(Gravity{});
  const Body arm = w.add({.shape = box({1, Real(0.1), Real(0.1)}), .at = {0.5, 0, 0}, .mass = 1});
  const Joint j = w.join(Hinge{.b = arm,
                               .at = {0, 0, 0},
                               .axis = z_axis,
                               .drive = {.mode = DriveMode::servo, .target = Real(0.5), .force = 20}});
  step(w, 180);
  EXPECT_NEAR(w[j].coordinate(), 0.5, 5e-3);
  w.set_drive(j, {.mode = DriveMode::servo, .target = Real(-0.5), .force = 20});
  step(w, 180);
  EXPECT_NEAR(w[j].coordinate(), -0.5, 5e-3);
  EXPECT_NEAR(w[j].load().torque.z, 9.81 * 0.5 * std::cos(0.5), 0.05);
}

TEST(Servo, StopsAtALimit) {
  Rail rail({.high = 1}, {.mode = DriveMode::servo, .target = 3, .force = 5});
  step(rail.w, 300);
  EXPECT_NEAR(rail.x(), 1, 2e-3);
}

// A drive between two free bodies moves them apart by action and reaction.
TEST(Drive, PushesBothBodies) {
  World w(steady(0.01));
  const Body a = w.add({.shape = box({1, 1, 1}), .mass = 3}),
             b = w.add({.shape = box({1, 1, 1}), .at = {2, 0, 0}, .mass = 1});
  w.join(Slider{
      .a = a, .b = b, .at = {1, 0, 0}, .axis = x_axis, .drive = {.mode = DriveMode::speed, .target = 100, .force = 3}});
  step(w, 100);
  EXPECT_NEAR(w[a].velocity().x, -1, 1e-3);
  EXPECT_NEAR(w[b].velocity().x, 3, 1e-3);
}

// A muscle is a servo of the distance between its two points: it lifts the weight that its force can, and holds it.
TEST(Muscle, LiftsAndHolds) {
  for (const double force : {9.0, 15.0}) {
    World w(steady(0.01));
    w.add(Gravity{});
    const Body b = w.add(cube({0, -2, 0}));
    const Joint j = w.join(
        Muscle{.b = b, .at_b = {0, -2, 0}, .drive = {.mode = DriveMode::servo, .target = 1, .force = Real(force)}});
    EXPECT_NEAR(w[j].coordinate(), 2, 1e-6);
    step(w, 400);
    if (force > 9.81) {
      EXPECT_NEAR(w[j].coordinate(), 1, 1e-3);
      expect_near(w[j].load().force, Vec3d{0, 9.81, 0}, 0.05);
    } else {
      EXPECT_GT(w[j].coordinate(), 5);
    }
  }
}

}

// A spring obeys the implicit recursion v ← (m v + h k (target − x))/(m + h c + h² k), and no more than its force.
TEST(Spring, IsImplicit) {
  const double h = 0.01, k = 40, c = 3, m = 2;
  World w(steady(h));
  const Body b = w.add({.shape = box({1, 1, 1}), .mass = Real(m)});
  const Drive spring{.mode = DriveMode::spring, .target = 1, .force = 1000, .stiffness = Real(k), .damping = Real(c)};
  const Joint j = w.join(Slider{.b = b, .axis = x_axis, .drive = spring});
  double x = 0, v = 0;
  for (int i = 0; i < 200; ++i) {
    w.step();
    v = (m * v + h * k * (1 - x)) / (m + h * c + h * h * k);
    x += h * v;
    ASSERT_NEAR(w[b].center().x, x, 2e-5);
  }
  w.set_drive(j, {.mode = DriveMode::spring, .target = 100, .force = 4, .stiffness = Real(k)});
  const double before = w[b].velocity().x;
  step(w, 10);
  EXPECT_NEAR(w[b].velocity().x - before, 4 / m * 0.1, 1e-4);
}

// Damping alone pulls to a rate: v̇ = c (rate − v) / m, implicitly.
TEST(Spring, PullsToARate) {
  const double h = 0.01, c = 3, m = 2, rate = 1.5;
  World w(steady(h));
  const Body b = w.add({.shape = box({1, 1, 1}), .mass = Real(m)});
  w.join(Slider{.b = b,
                .axis = x_axis,
                .drive = {.mode = DriveMode::spring, .force = 1000, .damping = Real(c), .rate = Real(rate)}});
  double v = 0;
  for (int i = 0; i < 200; ++i) {
    w.step();
    v = (m * v + h * c * rate) / (m + h * c);
    ASSERT_NEAR(w[b].velocity().x, v, 1e-5);
  }
}

// A block and tackle: with ratio 2 a weight holds the double one, and a moves twice as fast as b.
TEST(Pulley, IsABlockAndTackle) {
  World w(steady(0.01));
  w.add(Gravity{});
  const Body a = w.add({.shape = sphere(1), .at = {-3, 0, 0}, .mass = 1});
  const Body b = w.add({.shape = sphere(1), .at = {3, 0, 0}, .mass = 2});
  const Joint j = w.join(Pulley{
      .a = a, .b = b, .at_a = {-3, 0, 0}, .over_a = {-3, 9, 0}, .over_b = {3, 9, 0}, .at_b = {3, 0, 0}, .ratio = 2});
  step(w, 100);
  EXPECT_NEAR(w[a].center().y, 0, 1e-4);
  EXPECT_NEAR(w[b].center().y, 0, 1e-4);
  expect_near(w[j].load().force, Vec3d{0, 2 * 9.81, 0}, 1e-3);
  w.set_velocity(a, {0, -2, 0}, {});
  w.set_velocity(b, {0, 1, 0}, {});
  step(w, 100);
  EXPECT_NEAR(w[a].velocity().y, -2, 1e-3);
  EXPECT_NEAR(w[b].velocity().y, 1, 1e-3);
  w.set_velocity(a, {0, 3, 0}, {});  // slack: both fall freely
  step(w, 10);
  EXPECT_NEAR(w[a].velocity().y, 3 - 0.981, 1e-3);
}

// What a yo-yo's rope lets out, its turning gives, through whole turns of the axle.
TEST(Reel, LetsOutWhatTheAxleTurns) {
  World w(steady(0.005));
  w.add(Gravity{});
  const double r = 0.25;
  const Body b = w.add({.shape = sphere(1), .at = {Real(-r), 0, 0}, .mass = 1});
  const Joint j = w.join(Reel{.b = b, .at_a = {0, 2, 0}, .at = {Real(-r), 0, 0}, .axis = z_axis, .radius = Real(r)});
  double turned = 0;
  for (int i = 0; i < 400; ++i) {
    w.step();
    turned += w[b].spin().z * 0.005;
  }
  EXPECT_GT(turned, 3 * pi);
  EXPECT_NEAR(-w[b].center().y, r * turned, 1e-3 * r * turned);
  EXPECT_LT(w[j].gap(), 1e-3);
}

}
