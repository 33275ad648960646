// Joints that measure: single coordinates of bodies that other joints hold, or nobody, with limits and drives.
#include "unit/random.h"
#include "unit/worlds.h"

namespace sudar_test {
namespace {

constexpr Vec3 x_axis{1, 0, 0}, y_axis{0, 1, 0}, z_axis{0, 0, 1};

Quat turn(const Vec3& axis, double angle) { return axis_angle(axis, Real(angle)); }

TEST(Orientation, LetsABodyGoWhereItLikesButNotTurn) {
  World w(steady(0.01));
  const Body b = w.add(cube({0, 0, 0}));
  w.join(Orientation{.b = b});
  for (int i = 0; i < 100; ++i) w.push(b, {1, 2, 3}, {0.3, 0.5, -0.4}), w.step();
  expect_near(w[b].velocity(), Vec3d{1, 2, 3}, 1e-4);
  EXPECT_NEAR(double(w[b].pose().q.w), 1, 1e-5);
}

// What azimuths and tilt say of a body turned by three angles, each about an axis that the one before it turned.
TEST(Gimbal, MeasuresTheAnglesOfThreeHinges) {
  Random random;
  for (int trial = 0; trial < 50; ++trial) {
    World w(steady(1e-5));
    const Body b = w.add(cube({0, 0, 0}));
    w.join(Ball{.b = b});
    const Joint first = w.join(Azimuth{.b = b, .axis = x_axis, .direction = z_axis});
    const Joint second = w.join(Tilt{.b = b, .axis = x_axis, .direction = z_axis});
    const Joint third = w.join(Azimuth{.a = b, .axis = -z_axis, .direction = x_axis});
    const double p = random.between(-3, 3), q = random.between(-1, 1), r = random.between(-3, 3);
    w.place(b, {{0, 0, 0}, turn(x_axis, p) * turn(y_axis, q) * turn(z_axis, r)});
    // The rates must be those of the angles.
    const Vec3 rates{Real(random.between(-1, 1)), Real(random.between(-1, 1)), Real(random.between(-1, 1))};
    const Vec3 middle = rotate(turn(x_axis, p), y_axis), last = rotate(turn(x_axis, p) * turn(y_axis, q), z_axis);
    w.set_velocity(b, {}, x_axis * rates.x + middle * rates.y + last * rates.z);
    w.step();
    const auto coordinates = [&] {
      return Vec3d{w[first].coordinate(), w[second].coordinate(), w[third].coordinate()};
    };
    const Vec3d before = coordinates();
    expect_near(before, Vec3d{p, pi / 2 - q, r}, 1e-4);
    step(w, 1000);
    expect_near((coordinates() - before) / 0.01, Vec3d{rates.x, -rates.y, rates.z}, 0.03);
  }
}

TEST(Azimuth, HasALimitAndASpring) {
  World w(steady(0.005));
  const Body b = w.add(cube({0, 0, 0}));
  w.join(Ball{.b = b});
  const Joint j =
      w.join(Azimuth{.b = b, .axis = y_axis, .direction = x_axis, .limit = {.low = Real(-0.5), .high = Real(0.7)}});
  w.set_velocity(b, {}, {0, 2, 0});
  step(w, 200);
  EXPECT_NEAR(w[j].coordinate(), 0.7, 2e-3);
  w.set_drive(j, {.mode = DriveMode::spring, .target = Real(-0.2), .force = 100, .stiffness = 20, .damping = 3});
  step(w, 2000);
  EXPECT_NEAR(w[j].coordinate(), -0.2, 1e-3);
}

TEST(Tilt, IsACone) {
  World w(steady(0.005));
  w.add(Gravity{});
  const Body b = w.add({.shape = box({Real(0.1), 1, Real(0.1)}), .at = {0, 0.5, 0}, .mass = 1});
  w.join(Ball{.b = b});
  const Joint j = w.join(Tilt{.b = b, .axis = y_axis, .direction = y_axis, .limit = {.low = 0, .high = Real(0.5)}});
  w.set_velocity(b, {Real(0.2), 0, Real(0.1)}, {Real(0.2), 0, Real(-0.4)});
  step(w, 600);
  EXPECT_NEAR(w[j].coordinate(), 0.5, 2e-3);
}

TEST(Stroke, StopsAFreeBodyAlongOneAxis) {
  World w(steady(0.01));
  const Body b = w.add(cube({0, 0, 0}));
  const Joint j = w.join(Stroke{.b = b, .axis = x_axis, .limit = {.low = -1, .high = 1}});
  w.set_velocity(b, {2, 1, 0}, {});
  step(w, 200);
  EXPECT_NEAR(w[j].coordinate(), 1, 1e-3);
  EXPECT_NEAR(w[b].pose().p.y, 2, 1e-3);
}

// A mass on a rail whose motor has a rotor: the force moves both.
TEST(Armature, IsInertiaAlongTheCoordinateAlone) {
  World w(steady(0.01));
  w.add(Gravity{{4, -9, 0}});
  const Body b = w.add({.shape = box({1, 1, 1}), .at = {0, 0, 0}, .mass = 1});
  w.join(Slider{.b = b,
                .axis = x_axis,
                .drive = {.mode = DriveMode::spring, .force = std::numeric_limits<Real>::infinity(), .armature = 3}});
  const Body free = w.add({.shape = box({1, 1, 1}), .at = {0, 0, 9}, .mass = 1});
  w.join(Azimuth{
      .b = free,
      .axis = z_axis,
      .direction = x_axis,
      .drive = {.mode = DriveMode::spring, .force = std::numeric_limits<Real>::infinity(), .armature = Real(0.5)}});
  for (int i = 0; i < 100; ++i) w.twist(free, {0, 0, 2}), w.step();
  EXPECT_NEAR(double(w[b].velocity().x), 4 * 1. / (1 + 3), 1e-3);
  EXPECT_NEAR(double(w[free].spin().z), 2 / (1. / 6 + 0.5), 1e-2);
  EXPECT_NEAR(double(w[free].velocity().y), -9, 1e-2);
}

}
}
