#include "bench/quality.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace {

using namespace sudar;
using namespace sudar::bench;

std::vector<Pose> poses(const Scene& s) {
  std::vector<Pose> p;
  for (const SceneBody& b : s.bodies) p.push_back({b.at, convert<Real>(b.turn)});
  return p;
}

struct Counts {
  std::size_t bodies, dynamic, joints;
};

TEST(Scenes, AreAsLargeAsTheOnesThatOtherEnginesWereMeasuredOn) {
  const std::map<std::string_view, Counts> expected = {
      {"large_pyramid", {5051, 5050, 0}},
      {"many_pyramids", {10781, 10780, 0}},
      {"joint_grid", {10000, 9900, 19701}},
      {"convex_column", {5121, 5120, 0}},
      {"convex_pit", {8005, 8000, 0}},
      {"junkyard", {10590, 10584, 0}},
      {"large_world", {1000100, 100, 0}},
      {"pile1k", {1025, 1024, 0}},
      {"pile4k", {4097, 4096, 0}},
      {"pile16k", {16385, 16384, 0}},
      {"pile64k", {65537, 65536, 0}},
      {"tower10", {11, 10, 0}},
      {"tower15", {16, 15, 0}},
      {"tower25", {26, 25, 0}},
      {"wall_unit", {52, 51, 0}},
  };
  EXPECT_EQ(scene_names().size(), expected.size());
  for (const std::string_view name : scene_names()) {
    ASSERT_TRUE(expected.contains(name)) << name;
    const Counts& e = expected.at(name);
    const Scene s = make_scene(name);
    EXPECT_EQ(s.bodies.size(), e.bodies) << name;
    const auto dynamic =
        std::count_if(s.bodies.begin(), s.bodies.end(), [](const SceneBody& b) { return b.motion == Motion::dynamic; });
    EXPECT_EQ(std::size_t(dynamic), e.dynamic) << name;
    EXPECT_EQ(s.joints.size(), e.joints) << name;
    EXPECT_TRUE(std::is_sorted(s.bodies.begin(), s.bodies.end(), [](const SceneBody& a, const SceneBody& b) {
      return a.arrives < b.arrives;
    })) << name;
    const double overlap = name == "junkyard" ? 0.4 : 1e-6;
    EXPECT_LE(measure(s, poses(s)).penetration_max, overlap) << name;
  }
}

TEST(Scenes, HullsHaveAllOfTheirPoints) {
  for (const char* name : {"convex_column", "convex_pit", "junkyard"}) {
    for (const Solid& solid : make_scene(name).solids) {
      if (solid.kind == Solid::Kind::hull) { EXPECT_EQ(shape(solid).vertices().size(), solid.points.size()) << name; }
    }
  }
}

TEST(Scenes, OfAnySizeAndNoOther) {
  EXPECT_EQ(make_scene("pile2k").bodies.size(), 2049u);
  EXPECT_EQ(make_scene("tower30").bodies.size(), 31u);
  EXPECT_EQ(make_scene("pyramid4").bodies.size(), 11u);
  for (const char* name : {"tower", "tower0", "tower-3", "tower3x", "pile9999999k", "castle", ""})
    EXPECT_THROW(make_scene(name), Error) << name;
}

TEST(SceneCircle, ComesBackAfterAMinute) {
  const SceneCircle c = *make_scene("junkyard").circle;
  Vec3d at{c.radius, 0, 0};
  for (int step = 0; step < 3600; ++step) {
    at += velocity(c, step) * scene_dt;
    if (step == 899) {  // a quarter, from x against z
      EXPECT_NEAR(length(at - Vec3d{0, 0, -c.radius}), 0, 1e-9);
    }
  }
  EXPECT_NEAR(length(at - Vec3d{c.radius, 0, 0}), 0, 1e-9);
}

TEST(SceneQuality, OverlapsAreMeasuredOnTheShapes) {
  const Scene s = make_scene("tower3");
  std::vector<Pose> p = poses(s);
  p[2].p.y -= 0.25;  // into the one below, and away from the one above
  p[3].p.x += 0.5, p[3].p.z += 0.25;
  const SceneQuality q = measure(s, p);
  EXPECT_TRUE(q.finite);
  EXPECT_EQ(q.overlaps, 1);
  EXPECT_NEAR(q.penetration_max, 0.25, 1e-6);
  EXPECT_NEAR(q.penetration_mean, 0.25, 1e-6);
  EXPECT_NEAR(q.penetration_p99, 0.25, 1e-6);
  EXPECT_EQ(q.below_ground, 0);
  EXPECT_NEAR(q.drift.value(), sqrt(0.5 * 0.5 + 0.25 * 0.25), 1e-12);
  EXPECT_NEAR(q.sink.value(), 0.25, 1e-12);
  p[1].p.y -= 0.125;
  EXPECT_EQ(measure(s, p).overlaps, 2);
  EXPECT_NEAR(measure(s, p).penetration_mean, 0.125, 1e-6);
  p[1].p.y = -0.4;  // in the floor, not through it
  EXPECT_EQ(measure(s, p).below_ground, 0);
  p[1].p.y = -0.6;
  EXPECT_EQ(measure(s, p).below_ground, 1);
}

TEST(SceneQuality, GapsAreThoseOfTurnedAnchors) {
  const Scene s = make_scene("joint_grid");
  std::vector<Pose> p = poses(s);
  EXPECT_NEAR(measure(s, p).joint_gap_max, 0, 1e-7);
  p.back().q =
      axis_angle(Vec3{0, 0, 1}, Real(pi));  // the last one has two joints, whose anchors now are on its far side
  const SceneQuality q = measure(s, p);
  EXPECT_NEAR(q.joint_gap_max, 1, 1e-6);
  EXPECT_NEAR(q.joint_gap_mean, 2.0 / 19701, 1e-9);
  EXPECT_EQ(q.overlaps, 0);
}

TEST(SceneQuality, DriftMeansNothingWhereThingsFall) {
  const Scene s = make_scene("pile16");
  EXPECT_FALSE(measure(s, poses(s)).drift.has_value());
}

TEST(SceneQuality, SaysWhenItIsNotFinite) {
  const Scene s = make_scene("tower3");
  std::vector<Pose> p = poses(s);
  p[1].p.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(measure(s, p).finite);
}

}
