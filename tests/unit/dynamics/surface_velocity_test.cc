// Bodies whose surface moves though they stand: belts, tracks.
#include "unit/worlds.h"

namespace sudar_test {
namespace {

const BodyDef belt{.shape = box({40, 1, 4}), .at = {0, -0.5, 0}, .surface_velocity = {2, 0, 0}, .motion = Motion::fixed};

// What is laid on a belt slips until t = v/μg, then rides along; the belt stays.
TEST(SurfaceVelocity, ABeltCarries) {
  World w(steady());
  w.add(Gravity{{0, -10, 0}});
  const Body below = w.add(belt);
  const Body load = w.add(cube({0, 0.5, 0}, {.friction_static = Real(0.5), .friction_dynamic = Real(0.5)}));
  w.set_pair_material(below, load, w[load].material());
  step(w, 20);
  expect_near(w[load].velocity(), Vec3d{0.5 * 10 * 0.2, 0, 0}, 0.06);
  EXPECT_TRUE(w.contacts().at(0).slipping);
  step(w, 80);
  expect_near(w[load].velocity(), Vec3d{2, 0, 0}, 1e-4);
  expect_near(w[load].spin(), Vec3d{}, 1e-4);
  EXPECT_FALSE(w.contacts().at(0).slipping);
  EXPECT_EQ(w[below].pose().p, belt.at);
}

// The velocity turns with the shape, and what points into the contact neither lifts nor presses.
TEST(SurfaceVelocity, IsTheShapesAndTangential) {
  World w(steady());
  w.add(Gravity{});
  BodyDef turned = belt;
  turned.turn = axis_angle(Vec3{0, 1, 0}, Real(pi) / 2);
  turned.surface_velocity = {1, 5, 0};
  w.add(turned);
  const Body load = w.add(cube({0, 0.5, 0}));
  step(w, 100);
  expect_near(w[load].velocity(), Vec3d{0, 0, -1}, 1e-4);
  EXPECT_NEAR(w[load].center().y, 0.5, 1e-4);
}

// Of two bodies that push each other off both move: a tracked vehicle on a plank on ice.
TEST(SurfaceVelocity, TracksDriveAndPushBack) {
  World w(steady());
  w.add(Gravity{});
  add_floor(w, 0, {.friction_static = 0, .friction_dynamic = 0});
  const Body plank = w.add({.shape = box({20, 1, 4}), .at = {0, 0.5, 0}, .mass = 3});
  BodyDef def = cube({0, 1.5, 0});
  def.surface_velocity = {-1, 0, 0};
  const Body vehicle = w.add(def);
  step(w, 200);
  EXPECT_NEAR(w[vehicle].velocity().x, 0.75, 1e-3);
  EXPECT_NEAR(w[plank].velocity().x, -0.25, 1e-3);
}

// Nothing falls asleep on a running belt, however slow; it does on one that stands, and wakes when that starts.
TEST(SurfaceVelocity, KeepsAwakeAndWakes) {
  World w(sleepy());
  w.add(Gravity{});
  BodyDef slow = belt;
  slow.surface_velocity = {Real(1e-3), 0, 0};
  const Body below = w.add(slow), load = w.add(cube({0, 0.5, 0}));
  step(w, 200);
  EXPECT_FALSE(w[load].asleep());
  w.set_surface_velocity(below, {});
  step(w, 200);
  EXPECT_TRUE(w[load].asleep());
  w.set_surface_velocity(below, {0, 0, 1});
  step(w, 100);
  EXPECT_NEAR(w[load].velocity().z, 1, 1e-4);
  EXPECT_EQ(w[below].surface_velocity(), (Vec3{0, 0, 1}));
}

}
}
