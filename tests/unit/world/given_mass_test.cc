// Centre of mass and inertia that a definition gives instead of its shape's.
#include <gtest/gtest.h>

#include <sudar/record.h>

using namespace sudar;

namespace {

const Vec3 center{0.1, -0.2, 0.3};
const Quat turn = rotation(Vec3{0.4, -1, 0.7});
// Not diagonal, so that the body's axes are not the shape's.
const Mat3 inertia{{3, 0.2, -0.1}, {0.2, 4, 0.3}, {-0.1, 0.3, 5}};

BodyDef definition() {
  return {.shape = box({1, 2, 3}), .at = {4, 5, 6}, .turn = turn, .mass = 2, .center = center, .inertia = inertia};
}

void expect_near(const Vec3& a, const Vec3& b) { EXPECT_LT(length(a - b), 1e-5) << a.x << ' ' << a.y << ' ' << a.z; }

TEST(GivenMass, IsWhereAndWhatItWasSaidToBe) {
  World w;
  const Body b = w.add(definition());
  expect_near(w[b].center() - Pos{4, 5, 6}, rotate(turn, center));
  expect_near(w[b].pose().p - Pos{4, 5, 6}, {});
  const Mat3 r = matrix(turn), expected = r * inertia * transpose(r), got = w[b].inertia();
  for (int k = 0; k < 3; ++k) expect_near(got[k], expected[k]);
  EXPECT_EQ(w[b].mass(), 2);
}

TEST(GivenMass, OneAloneLeavesTheOtherToTheShape) {
  World w;
  BodyDef def{.shape = box({1, 2, 3}), .mass = 12, .center = center};
  const Mat3 of_shape = w[w.add(def)].inertia();  // about the centre of mass, wherever that is
  expect_near({of_shape.c0.x, of_shape.c1.y, of_shape.c2.z}, {4 + 9, 1 + 9, 1 + 4});
  def = {.shape = wedge({1, 2, 3}), .mass = 1, .inertia = Mat3::identity()};
  const Body b = w.add(def);
  expect_near(w[b].center() - Pos{}, convert<Real>(def.shape.mass_properties().center));
}

TEST(GivenMass, ABodyTurnsAboutTheGivenCentre) {
  World w;
  const Body b = w.add({.shape = sphere(1), .spin = {0, 0, 1}, .center = Vec3{1, 0, 0}});
  for (int i = 0; i < 60; ++i) w.step();
  expect_near(w[b].center() - Pos{1, 0, 0}, {});
  expect_near(w[b].pose().p - Pos{}, Vec3{1, 0, 0} - Vec3{cos(Real(1)), sin(Real(1)), 0});
}

TEST(GivenMass, IsRecorded) {
  World w;
  Recorder recorder(w, "given mass");
  w.add(definition());
  w.step();
  recorder.after_step();
  Replay replay(recorder.bytes());
  EXPECT_FALSE(replay.step().has_value());
  EXPECT_EQ(replay.world().hash(), w.hash());
}

TEST(GivenMass, WhatNoBodyHasIsRefused) {
  World w;
  const auto refused = [&](const BodyDef& def) {
    try {
      w.add(def);
    } catch (const Error& e) { return e.field; }
    return std::string();
  };
  EXPECT_EQ(refused({.shape = sphere(1), .inertia = Mat3::diagonal({1, 2, 4})}), "inertia");  // 4 > 1 + 2
  EXPECT_EQ(refused({.shape = sphere(1), .inertia = Mat3::diagonal({1, -1, 1})}), "inertia");
  EXPECT_EQ(refused({.shape = sphere(1), .inertia = Mat3{{1, 0.5, 0}, {0, 1, 0}, {0, 0, 1}}}), "inertia");
  EXPECT_EQ(refused({.shape = sphere(1), .center = Vec3{std::numeric_limits<Real>::quiet_NaN(), 0, 0}}), "center");
  EXPECT_EQ(refused({.shape = half_space(), .center = Vec3{}, .motion = Motion::fixed}), "center");
  EXPECT_TRUE(w.bodies().empty());
  EXPECT_EQ(refused({.shape = sphere(1), .inertia = Mat3::diagonal({1, 2, 3})}), "");  // flat: the limit
}

}
