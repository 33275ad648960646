// What a world tells: bodies, events, contacts, rays, sensors, sums, profile.
#include <functional>

#include "base/timer.h"
#include "unit/worlds.h"

namespace sudar_test {
namespace {

TEST(View, OfABody) {
  World w(steady());
  const Quat turn = axis_angle(normalize(Vec3{1, 2, 3}), Real(0.7));
  const std::vector<Vec3> corners{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}};  // its centre of mass is (.5, .5, .5)
  const Body b = w.add({.shape = hull(corners),
                        .at = {1, 2, 3},
                        .turn = turn,
                        .velocity = {1, 0, 0},
                        .spin = {0, 0, 2},
                        .density = 6,
                        .name = "corner"});
  const BodyView v = w[b];
  expect_near(v.pose().p, Pos{1, 2, 3}, 1e-6);
  EXPECT_NEAR(std::abs(v.pose().q.w), turn.w, 1e-6);
  expect_near(v.center(), Pos{1, 2, 3} + rotate(turn, Vec3{Real(0.5), Real(0.5), Real(0.5)}), 1e-6);
  EXPECT_NEAR(v.mass(), 6 * 8.0 / 6, 1e-5);
  expect_near(v.velocity_at(v.center() + Vec3{1, 0, 0}), Vec3d{1, 2, 0}, 1e-6);
  const Mat3d in_shape = v.shape().mass_properties().inertia;
  const Vec3 n{0, 0, 1}, local = rotate_back(turn, n);
  EXPECT_NEAR(dot(n, v.inertia() * n), 6 * dot(convert<double>(local), in_shape * convert<double>(local)), 1e-4);
  expect_near(v.angular_momentum(), v.inertia() * v.spin(), 1e-5);
  EXPECT_NEAR(v.kinetic_energy(), 0.5 * 8 + 0.5 * double(dot(v.spin(), v.angular_momentum())), 1e-4);
  EXPECT_EQ(v.name(), "corner");
  EXPECT_EQ(v.motion(), Motion::dynamic);
  EXPECT_EQ(w.find("corner"), b);
}

TEST(View, OfTheBroadPhase) {
  World w(steady());
  add_floor(w);
  const Body a = w.add(cube({0, 3, 0}));
  w.add(cube({5, 3, 0}));
  w.step();
  ASSERT_EQ(w.fat_boxes().size(), 2u);  // a half space has none
  EXPECT_TRUE(contains(w.fat_boxes()[0], Box{w[a].center(), w[a].center()}));
  ASSERT_EQ(w.broad_boxes().size(), 1u);  // the root of a tree of two
  EXPECT_TRUE(contains(w.broad_boxes()[0], w.fat_boxes()[0]));
  EXPECT_TRUE(contains(w.broad_boxes()[0], w.fat_boxes()[1]));
}

// Two stacks of two are two islands; the floor joins nothing, a joint does.
TEST(View, OfIslands) {
  World w(steady());
  w.add(Gravity{});
  add_floor(w);
  w.add(cube({0, 0.5, 0})), w.add(cube({5, 0.5, 0}));
  const Body c = w.add(cube({0, 1.5, 0})), d = w.add(cube({5, 1.5, 0}));
  step(w, 3);
  EXPECT_EQ(w.islands(), (std::vector<std::uint32_t>{0, 1, 2, 1, 2}));
  w.join(Rope{.a = c, .b = d, .at_a = w[c].center(), .at_b = w[d].center()});
  EXPECT_EQ(w.islands(), (std::vector<std::uint32_t>{0, 1, 1, 1, 1}));
}

// x of both frames is the axis, and the angle is that from a's y to b's.
TEST(View, OfAHingesFrames) {
  World w(steady());
  const Body a = w.add(cube({0, 0, 0})), b = w.add(cube({2, 0, 0}));
  const Vec3 axis = normalize(Vec3{1, 2, 2});
  const Joint j = w.join(Hinge{.a = a, .b = b, .at = {1, 0, 0}, .axis = axis});
  w.set_velocity(b, {}, axis * Real(0.5));
  step(w, 20);
  EXPECT_LT(length(rotate(w[j].frame_a(), Vec3{1, 0, 0}) - rotate(w[j].frame_b(), Vec3{1, 0, 0})), 1e-3);
  const Vec3 y = rotate(w[j].frame_a(), Vec3{0, 1, 0}), z = rotate(w[j].frame_a(), Vec3{0, 0, 1}),
             turned = rotate(w[j].frame_b(), Vec3{0, 1, 0});
  EXPECT_GT(abs(w[j].coordinate()), 0.02);
  EXPECT_NEAR(std::atan2(dot(turned, z), dot(turned, y)), w[j].coordinate(), 1e-3);
}

// What the joint's view tells of anchors and definition.
TEST(View, OfAJoint) {
  World w(steady());
  const Body b = w.add(cube({2, 0, 0}));
  const Joint j = w.join(Bar{.b = b, .at_a = {0, 1, 0}, .at_b = {2, Real(0.5), 0}});
  expect_near(w[j].anchor_a(), Pos{0, 1, 0}, 1e-6);
  expect_near(w[j].anchor_b(), Pos{2, 0.5, 0}, 1e-6);
  w.place(b, {{4, 0, 0}, {}});
  expect_near(w[j].anchor_b(), Pos{4, 0.5, 0}, 1e-6);
  EXPECT_NEAR(w[j].gap(), std::sqrt(16 + 0.25) - std::sqrt(4 + 0.25), 1e-5);
  EXPECT_TRUE(std::holds_alternative<Bar>(w[j].definition()));
}

// Begun, then ended, each once, ordered by the bodies; hits with place, normal and speed.
TEST(Events, BeginAndEndInOrder) {
  World w(steady());
  w.add(Gravity{});
  const Body ground = add_floor(w);
  Body balls[3];
  for (int i = 0; i < 3; ++i) {
    balls[i] = w.add({.shape = sphere(Real(0.5)), .at = {3.0 * i, 2, 0}, .material = {.restitution = Real(0.9)}});
  }
  int begun = 0, ended = 0, hits = 0;
  for (int i = 0; i < 100; ++i) {
    const Events& e = w.step();
    for (const auto* touches : {&e.begun, &e.ended}) {
      for (std::size_t k = 0; k < touches->size(); ++k) {
        EXPECT_EQ((*touches)[k].a, ground);
        EXPECT_EQ((*touches)[k].b, balls[k]);
      }
    }
    EXPECT_TRUE(e.begun.size() == 0 || e.begun.size() == 3);
    begun += int(e.begun.size()), ended += int(e.ended.size()), hits += int(e.hits.size());
    EXPECT_GE(begun, ended);
    for (const Events::Hit& hit : e.hits) {
      EXPECT_NEAR(hit.at.y, 0, 0.03);
      expect_near(hit.normal, Vec3d{0, -1, 0}, 1e-6);  // from b, the ball, to a
      EXPECT_NEAR(hit.speed, std::sqrt(2 * 9.81 * 1.5), 0.1);
    }
    EXPECT_EQ(&e, &w.events());
  }
  EXPECT_EQ(begun, 3);
  EXPECT_EQ(ended, 3);
  EXPECT_EQ(hits, 3);
}

// A box at rest touches and does not hit.
TEST(Events, RestIsNoHit) {
  World w(steady());
  w.add(Gravity{});
  const Body ground = add_floor(w), b = w.add(cube({0, 0.5, 0}));
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(w.step().hits.empty());
  EXPECT_TRUE(w.touching(ground, b));
  EXPECT_TRUE(w.touching(b, ground));
}

TEST(Filter, DecidesWhoTouches) {
  const auto touch = [](const sudar::Filter& first, const sudar::Filter& second) {
    World w(steady());
    BodyDef a = cube({0, 0, 0}), b = cube({0.9, 0, 0});
    a.filter = first, b.filter = second;
    const Body x = w.add(a), y = w.add(b);
    w.step();
    return w.touching(x, y);
  };
  EXPECT_TRUE(touch({}, {}));
  EXPECT_FALSE(touch({.mask = 2}, {}));
  EXPECT_FALSE(touch({}, {.mask = 2}));
  EXPECT_TRUE(touch({.category = 2, .mask = 4}, {.category = 4, .mask = 2}));
  EXPECT_FALSE(touch({.group = -1}, {.group = -1}));
  EXPECT_TRUE(touch({.mask = 0, .group = 3}, {.mask = 0, .group = 3}));
  EXPECT_TRUE(touch({.group = -1}, {.group = -2}));
}

TEST(Distance, BetweenBodies) {
  World w(steady());
  const Body floor = add_floor(w, 1), can = w.add({.shape = cylinder(1, 2), .at = {0, 4, 0}});
  const Body ball = w.add({.shape = sphere(1), .at = {5, 4, 0}});
  EXPECT_NEAR(w.distance(can, floor).value, 2, 1e-6);
  EXPECT_NEAR(w.distance(can, ball).value, 3, 1e-6);
  expect_near(w.distance(can, ball).on_b, Pos{4, 4, 0}, 1e-6);
  expect_near(w.distance(can, ball).normal, Vec3{-1, 0, 0}, 1e-6);
  w.remove(ball);
  EXPECT_THROW(w.distance(can, ball), Error);
}

// Against every shape, turned and moved: the nearest hit with its place and normal.
TEST(Ray, HitsEveryShape) {
  const struct {
    Shape shape;
    double top;  // above the shape's origin
  } cases[] = {{sphere(2), 2},        {capsule(Real(0.5), 3), 2}, {box({2, 4, 6}), 2},  {half_space(), 0},
               {prism(6, 2, 3), 1.5}, {pyramid(4, 2, 4), 3},      {cylinder(1, 5, 32), 2.5},
               {cylinder(1, 5), 2.5}, {cone(2, 4), 3},             {ellipsoid({1, 2, 3}), 2}};
  for (const auto& c : cases) {
    for (const double height : {0.0, 1e6}) {
      World w(steady());
      const Quat turn = axis_angle(Vec3{0, 0, 1}, Real(pi / 6));
      const Vec3 up = rotate(turn, Vec3{0, 1, 0});
      const Pos at{3, height, -2};
      const Body b = w.add({.shape = c.shape, .at = at, .turn = turn, .motion = Motion::fixed});
      const Vec3 aside = rotate(turn, Vec3{Real(1e-3), 0, Real(2e-3)});  // not exactly on an edge
      const auto hit = w.ray_cast(at + aside + up * Real(10), -up, 20);
      ASSERT_TRUE(hit) << int(c.shape.kind());
      EXPECT_EQ(hit->body, b);
      EXPECT_NEAR(hit->distance, 10 - c.top, 0.01);
      expect_near(hit->at, at + aside + up * (Real(10) - hit->distance), 1e-4);
      EXPECT_GT(dot(hit->normal, up), 0.3);
      EXPECT_NEAR(length(hit->normal), 1, 1e-5);
      EXPECT_FALSE(w.ray_cast(at + up * Real(10), -up, Real(10 - c.top - 0.1)));
      EXPECT_FALSE(w.ray_cast(at + up * Real(10), up, 100));
    }
  }
}
TEST(Ray, HitsTheNearest) {
  World w(steady());
  std::vector<Body> row;
  for (int i = 0; i < 5; ++i) row.push_back(w.add(cube({2.0 * (4 - i), 0, 0})));
  const auto hit = w.ray_cast({-5, 0, 0}, {1, 0, 0}, 100);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->body, row[4]);
  EXPECT_NEAR(hit->distance, 4.5, 1e-6);
  w.remove(row[4]);
  EXPECT_EQ(w.ray_cast({-5, 0, 0}, {1, 0, 0}, 100)->body, row[3]);
}

TEST(Sensors, MeasureTheirChannels) {
  World w(steady(0.01));
  w.add(Gravity{});
  const Body a = w.add(cube({0, 0, 0})), b = w.add(cube({3, 4, 0}));
  w.set_velocity(a, {0, 3, 0}, {});
  const SensorId acceleration = w.add(Sensor{.kind = SensorKind::acceleration, .a = a, .name = "a"});
  const SensorId apart = w.add(Sensor{.kind = SensorKind::distance, .a = a, .b = b});
  const SensorId origin = w.add(Sensor{.kind = SensorKind::distance, .a = b});
  const SensorId fastest = w.add(Sensor{.kind = SensorKind::maximum_speed, .a = a});
  const SensorId way = w.add(Sensor{.kind = SensorKind::odometer, .a = a});
  double length = 0, speed = 0;
  Pos before = w[a].center();
  for (int i = 0; i < 60; ++i) {
    w.step();
    length += distance(w[a].center(), before);
    before = w[a].center();
    speed = std::max(speed, std::abs(double(w[a].velocity().y)));
    ASSERT_NEAR(w.value(acceleration), 9.81, 1e-3);
    ASSERT_NEAR(w.value(apart), distance(w[a].center(), w[b].center()), 1e-6);
    ASSERT_NEAR(w.value(origin), distance(w[b].center(), {}), 1e-6);
    ASSERT_NEAR(w.value(fastest), speed, 1e-6);
    ASSERT_NEAR(w.value(way), length, 1e-6);
  }
  EXPECT_EQ(w[acceleration].name, "a");
  w.remove(way);
  EXPECT_EQ(w.sensors().size(), 4u);
}

TEST(Sums, EnergyAndMomentum) {
  World w(steady());
  w.add(Gravity{{0, -10, 0}});
  w.add({.shape = sphere(1), .at = {0, 3, 0}, .velocity = {2, 0, 0}, .spin = {0, 5, 0}, .mass = 4});
  w.add({.shape = sphere(1), .at = {0, 7, 0}, .velocity = {9, 0, 0}, .motion = Motion::kinematic});
  EXPECT_NEAR(w.energy().potential, 4 * 10 * 3, 1e-4);
  EXPECT_NEAR(w.energy().kinetic, 0.5 * 4 * 4 + 0.5 * 0.4 * 4 * 25, 1e-4);
  EXPECT_NEAR(w.energy().total(), 120 + 8 + 20, 1e-4);
  expect_near(w.momentum().linear, Vec3d{8, 0, 0}, 1e-6);
  expect_near(w.momentum().angular, Vec3d{0, 0.4 * 4 * 5, -3 * 8}, 1e-5);
}

TEST(Profile, NamesTheStagesAndCounts) {
  World w(steady(0.01, 2));
  w.add(Gravity{});
  add_floor(w);
  w.add(cube({0, 0.5, 0}));
  const Timer timer;
  w.step();
  const double whole = timer.microseconds();
  const Profile& p = w.profile();
  std::string names;
  double sum = 0;
  for (const Profile::Stage& stage : p.stages) {
    names += std::string(stage.name) + " ";
    EXPECT_GT(stage.microseconds, 0) << stage.name;
    sum += stage.microseconds;
  }
  EXPECT_LE(sum, whole);
  EXPECT_LE(p.collision.microseconds + p.contact.microseconds, sum);
  EXPECT_EQ(names, "pairs collide link solve impact refit sleep ");
  EXPECT_EQ(p.contacts, 1);
  EXPECT_EQ(p.points, 4);
  EXPECT_EQ(p.awake, 1);
  EXPECT_GE(p.contact.used, 2);
  EXPECT_GE(p.contact.visits, 8);
}

TEST(Quality, MeasuresOverlapAndGaps) {
  World w(steady());
  add_floor(w);
  const Body b = w.add(cube({0, 0.45, 0}));
  const Body c = w.add(cube({5, 3, 0}));
  w.join(Ball{.b = c, .at = {5, 3, 0}});
  w.step();
  EXPECT_NEAR(w.quality().penetration_max, 0.05, 1e-5);
  EXPECT_NEAR(w.quality().penetration_mean, 0.05, 1e-5);
  w.place(c, {{5.2, 3, 0}, {}});
  EXPECT_NEAR(w.quality().joint_gap_max, 0.2, 1e-5);
  EXPECT_TRUE(w.alive(b));
}

TEST(Time, IsStepsTimesDt) {
  World w(steady(0.1));
  step(w, 1000);
  EXPECT_DOUBLE_EQ(w.time(), 100);  // summed, it would be 99.9999999999986
  EXPECT_EQ(w.steps(), 1000);
  w.step(0.25);
  EXPECT_DOUBLE_EQ(w.time(), 100.25);
}

// A body that turns non-finite is reported once, frozen and no longer touched; the others do not notice.
TEST(Quarantine, LeavesTheOthersAlone) {
  const auto build = [](World& w) {
    w.add(Gravity{});
    add_floor(w);
    for (int i = 0; i < 5; ++i) w.add(cube({0, 0.5 + i, 0}));
  };
  World sane(steady()), mad(steady());
  build(sane), build(mad);
  const Body victim = mad.add(cube({9, 5, 0}));
  mad.add(Thruster{.body = victim, .force = {std::numeric_limits<Real>::max(), 0, 0}, .at = {0, 1, 0}});
  int reports = 0;
  for (int i = 0; i < 200; ++i) {
    sane.step();
    for (const Events::Quarantined& q : mad.step().quarantined) {
      EXPECT_EQ(q.body, victim);
      EXPECT_FALSE(q.reason.empty());
      ++reports;
    }
    const std::vector<Body> those = sane.bodies(), same = mad.bodies();
    for (std::size_t b = 0; b < those.size(); ++b) {
      ASSERT_EQ(sane[those[b]].pose(), mad[same[b]].pose()) << i;
      ASSERT_EQ(sane[those[b]].velocity(), mad[same[b]].velocity()) << i;
    }
  }
  EXPECT_EQ(reports, 1);
  EXPECT_TRUE(mad[victim].quarantined());
  expect_near(mad[victim].center(), Pos{9, 5, 0}, 1e-12);
  EXPECT_TRUE(std::isfinite(mad.energy().total()));
  const Body visitor = mad.add(cube({9.5, 5, 0}));
  mad.step();
  EXPECT_FALSE(mad.touching(victim, visitor));
  mad.remove(victim);
  mad.step();
}

}
}
