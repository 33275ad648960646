// The test scenes of KHR_physics_rigid_bodies (eoineoineoin/glTF_Physics ac5c413), which nobody here wrote: each does
// what it is there to show, to the numbers that mechanics gives. They are not part of the project: without them all is
// skipped.
#include <cmath>

#include "unit/io/files.h"

namespace sudar_test {
namespace {

struct Scene {
  explicit Scene(const io::Model& model, double dt = 1.0 / 60)
      : w([&] {
          Config c = model.config;
          c.dt = dt;
          return c;
        }()) {
    built = io::build(model, w);
    for (const Body b : built.bodies) {
      if (w[b].motion() != Motion::fixed) moving.push_back(b);
    }
  }
  Pos at(std::size_t i = 0) const { return w[moving.at(i)].pose().p; }
  void run_to(double time) {
    while (w.time() < time - 1e-9) w.step();
  }

  World w;
  io::Built built;
  std::vector<Body> moving;
};

class GltfAssets : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "skipped: no ../shared/assets";
  }
  static io::Model model(const std::string& group, int number) {
    const std::string name = "RigidBodies_" + group;
    const std::string file = name + (number < 10 ? "_0" : "_") + std::to_string(number) + ".gltf";
    const io::Reading r = io::read(folder / name / file);
    EXPECT_TRUE(r.made) << file << "\n" << text_of(r);
    for (const io::Finding& f : r.findings) EXPECT_EQ(f.severity, io::Severity::note) << io::text(f);
    return r.made.value_or(io::Model{});
  }
  static inline const std::filesystem::path folder = std::filesystem::path(SUDAR_ASSETS) / "gltf/tests";
};

// Six shapes fall on six; what the static one's top and the falling one's foot say is where it rests. On a sphere or
// capsule the tetrahedron tips over, as nothing holds it: there it only must not fall through.
TEST_F(GltfAssets, ColliderTypes) {
  const double tops[] = {1, -0.5, 1, 1, 0, 0}, feet[] = {1, 0.5, 0.75, 0.5, 0, 0};
  for (int i = 0; i < 36; ++i) {
    SCOPED_TRACE(i);
    Scene s(model("ColliderTypeMatrix", i));
    const double expected = tops[i / 6] + feet[i % 6], slop = double(s.w.config().impulse_2007.slop);
    double lowest = 3;
    while (s.w.time() < 1.5 - 1e-9) s.w.step(), lowest = std::min(lowest, s.at().y);
    const bool tips = (i / 6 == 0 || i / 6 == 2) && i % 6 >= 4;
    if (tips) {
      EXPECT_GT(s.at().y, expected - slop);
    } else {
      EXPECT_NEAR(s.at().y, expected, slop);
    }
    EXPECT_GT(lowest, expected - 1.2 * slop - 0.02);  // an impact may press it in for a moment
    s.run_to(10);
    const bool level = i / 6 != 0 && i / 6 != 2;  // on what is round it may roll off
    EXPECT_GT(s.at().y, level ? expected - 0.51 : -1000);
  }
}

TEST_F(GltfAssets, CollisionFilters) {
  for (int i = 0; i < 4; ++i) {
    SCOPED_TRACE(i);
    Scene s(model("CollisionFilter", i));
    s.run_to(3);
    EXPECT_NEAR(s.at(0).y, i < 2 ? 1 : 1.5, 0.011);
    EXPECT_NEAR(s.at(1).y, i < 2 ? 5 - 4.905 * 9 : -0.5, i < 2 ? 0.2 : 0.011);
  }
}

// When the body turns back for the second time, s.
double period(Scene& s) {
  const Body b = s.moving.front();
  std::vector<double> turns;
  for (Vec3 before = s.w[b].spin(); turns.size() < 2 && s.w.time() < 10;) {
    s.w.step();
    const Vec3 now = s.w[b].spin();
    if (dot(now, before) < 0) {
      const double share = double(length(before)) / double(length(before) + length(now));
      turns.push_back(s.w.time() - s.w.config().dt * (1 - share));
    }
    before = now;
  }
  return turns.size() < 2 ? 0 : turns[1];
}

TEST_F(GltfAssets, JointsHoldAndSwing) {
  Scene fixed(model("Joint", 0));
  fixed.run_to(3);
  EXPECT_NEAR(fixed.at().y, -1, 1e-5);

  Scene ball(model("Joint", 1));
  const double energy = ball.w.energy().total();
  ball.run_to(5);
  EXPECT_NEAR(length(ball.at() - Pos{0.5, -0.5, 0.5}), std::sqrt(0.75), 1e-4);
  EXPECT_NEAR(ball.w.energy().total(), energy, 0.01 * 1000 * 9.81);

  for (const int i : {2, 3, 4}) {
    SCOPED_TRACE(i);
    Scene hinge(model("Joint", i));
    double fastest = 0;
    while (hinge.w.time() < 2)
      hinge.w.step(), fastest = std::max(fastest, double(length(hinge.w[hinge.moving[0]].spin())));
    EXPECT_NEAR(fastest, 2.46883628, 0.005);
    Scene again(model("Joint", i));
    EXPECT_NEAR(period(again), 2.02572012, 0.004);
  }
  Scene off_center(model("Joint", 8));  // the inertia is the shape's, about the centre that is given
  EXPECT_NEAR(period(off_center), 2.26703607, 0.005);
}

TEST_F(GltfAssets, JointsSlideToTheirEnds) {
  Scene slides(model("Joint", 5));
  while (slides.at().x < 1.4142 && slides.w.time() < 2) slides.w.step();
  EXPECT_NEAR(slides.w.time(), 1.07391025, 1.0 / 60);
  slides.run_to(3);
  EXPECT_NEAR(slides.at().x, 1.41421, 1e-3);
  EXPECT_NEAR(slides.at().y, -1.41421, 1e-3);
  Scene meets(model("Joint", 6));  // the two may touch
  meets.run_to(3);
  EXPECT_NEAR(meets.at().x, -0.70711, 0.01);
  EXPECT_NEAR(meets.at().y, 0.70711, 0.01);

  Scene rope(model("Joint", 7));
  double longest = 0;
  while (rope.w.time() < 10) {
    rope.w.step();
    longest = std::max(longest, double(length(rope.w[rope.built.joints[0]].anchor_b() - Pos{0, -0.5, 0})));
  }
  EXPECT_NEAR(longest, 1, 0.01);  // a ton that is caught by it
  rope.w.add(Drag{.linear = 1, .angular = 1});
  rope.run_to(40);
  EXPECT_NEAR(rope.at().y, -2.36602540, 2e-3);
}

TEST_F(GltfAssets, Drives) {
  Scene turns(model("Joint", 9), 1.0 / 240);
  turns.run_to(3);
  EXPECT_NEAR(turns.w[turns.moving[0]].spin().x, 1.49259098, 2e-4);
  Scene springs(model("Joint", 10), 1.0 / 960);
  double lowest = 2, when = 0;
  while (springs.w.time() < 2 - 1e-9) {
    springs.w.step();
    if (springs.at().y < lowest) lowest = springs.at().y, when = springs.w.time();
  }
  EXPECT_NEAR(springs.at().y, 1.91907723, 5e-4);
  EXPECT_NEAR(lowest, 1.8180767, 5e-4);
  EXPECT_NEAR(when, 0.31455, 2e-3);
}

// The first apex after the impact.
double apex(const io::Model& m, std::size_t i) {
  Scene s(m, 1.0 / 240);
  s.run_to(1);
  double highest = 0;
  while (s.w.time() < 2.2) s.w.step(), highest = std::max(highest, s.at(i).y);
  return highest;
}

// A material that does not say how it is combined has no say; so read, these scenes tell the ways apart.
TEST_F(GltfAssets, Materials) {
  const io::Model maximum = model("Materials", 0), either = model("Materials", 1);
  EXPECT_NEAR(apex(maximum, 0), 2, 0.02);
  EXPECT_NEAR(apex(maximum, 1), 5, 0.06);
  EXPECT_NEAR(apex(either, 0), 1, 0.011);
  EXPECT_NEAR(apex(either, 1), 2, 0.02);
  Scene slope(model("Materials", 2));
  const Pos before = slope.at(1);
  slope.run_to(1);
  const double mu = 0.3, s = std::sqrt(0.5);  // the average of 0 and of what is usual
  EXPECT_NEAR(-slope.at(0).y + 0.070710674, 0.5 * 9.81 * s * (1 - mu) * s, 0.02);
  EXPECT_LT(length(slope.at(1) - before), 1e-3);
}

TEST_F(GltfAssets, MotionProperties) {
  const auto after = [](int number, double time) {
    Scene s(model("MotionProperties", number));
    s.run_to(time);
    return s;
  };
  EXPECT_EQ(after(0, 1).at(), Pos{});
  EXPECT_NEAR(after(1, 2).at().x, 2, 1e-5);
  const auto spin = [](const Scene& s) { return s.w[s.moving[0]].spin(); };
  expect_near(spin(after(2, 2)), Vec3d{1, 0, 0}, 1e-6);
  EXPECT_NEAR(after(3, 2).at().x, 2, 1e-5);
  expect_near(spin(after(4, 2)), Vec3d{1, 0, 0}, 1e-6);
  EXPECT_EQ(after(5, 2).at(), (Pos{0, 0.5, 0}));
  const Scene hits = after(6, 1);
  const auto speed = [&](std::size_t i) { return hits.w[hits.moving[i]].velocity().x; };
  EXPECT_NEAR(speed(0), 2.5, 1e-3);
  EXPECT_NEAR(speed(2), 2.5, 1e-3);
  EXPECT_NEAR(speed(1), 4.95049505, 1e-3);
  EXPECT_NEAR(speed(3), 4.95049505, 1e-3);
  const Scene endless = after(7, 5);
  EXPECT_NEAR(endless.at().y, 1, 0.011);
  EXPECT_NEAR(std::abs(endless.w[endless.moving[0]].pose().q.w), 1, 1e-6);
}

// The samples are read; what is not supported of them is told, and nothing turns to dust.
TEST_F(GltfAssets, SamplesRun) {
  for (const char* name : {"Filtering", "JointTypes", "Materials_Friction", "Materials_Restitution", "MotionProperties",
                           "Robot_skinned", "ShapeTypes", "Triggers", "WaterWheel"}) {
    const io::Reading r = io::read(folder / "../samples" / name / (std::string(name) + ".gltf"));
    ASSERT_TRUE(r.made) << text_of(r);
    Scene s(*r.made);
    for (int i = 0; i < 60; ++i) {
      s.w.step();
      EXPECT_TRUE(s.w.events().quarantined.empty()) << name;
    }
    EXPECT_LT(s.w.quality().joint_gap_max, 0.05) << name;
  }
}

}
}
