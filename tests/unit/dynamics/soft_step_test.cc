// The fast solver by what it promises: stacks that do not sink, loads that add up, friction and impacts where they are
// known in closed form, and the same bits however it is run.
#include <gtest/gtest.h>
#include <sudar/world.h>

#include <sstream>

using namespace sudar;

namespace {

Config soft() {
  Config c;
  c.solver = Solver::soft_step;
  c.sleep = false;
  return c;
}

World on_floor(const Config& c, const Material& material = {}) {
  World w(c);
  w.add(Gravity{{0, -10, 0}});
  w.add({.shape = half_space(), .material = material, .motion = Motion::fixed});
  return w;
}

std::vector<Body> tower(World& w, int cubes) {
  std::vector<Body> all;
  for (int i = 0; i < cubes; ++i) all.push_back(w.add({.shape = box({1, 1, 1}), .at = {0, i + 0.5, 0}, .density = 100}));
  return all;
}

void run(World& w, int steps) {
  for (int i = 0; i < steps; ++i) w.step();
}

double sink(Config c) {
  World w = on_floor(c);
  const std::vector<Body> cubes = tower(w, 25);
  run(w, 300);
  return 24.5 - w[cubes.back()].center().y;
}

}

// A soft contact of 30 Hz sinks by Σ 2kg/ω²: 0.17 m for 25 cubes. Contacts that know their load do not.
TEST(SoftStep, ATowerDoesNotSink) {
  EXPECT_LT(sink(soft()), 1e-3);
  Config plain = soft();
  plain.soft_step.carry_loads = false;
  EXPECT_NEAR(sink(plain), 0.17, 0.02);
}

TEST(SoftStep, AContactCarriesWhatStandsOnIt) {
  World w = on_floor(soft());
  const std::vector<Body> cubes = tower(w, 5);
  run(w, 300);
  const double h = w.config().dt / w.config().substeps, weight = double(w[cubes[0]].mass()) * 10;
  const std::vector<Contact> contacts = w.contacts();
  ASSERT_EQ(contacts.size(), 5u);
  double sum = 0;
  for (const Contact& c : contacts) {
    for (int k = 0; k < c.count; ++k) sum += double(c.points[std::size_t(k)].normal_impulse);
  }
  EXPECT_NEAR(sum, (1 + 2 + 3 + 4 + 5) * weight * h, 1e-3 * 15 * weight * h);
}

// v = v₀ − μgt, until it sticks.
TEST(SoftStep, FrictionBrakesByTheDynamicCoefficientAndThenHolds) {
  const Material material{Real(0.5), Real(0.3)};
  World w = on_floor(soft(), material);
  const Body b = w.add({.shape = box({1, 1, 1}), .at = {0, 0.5, 0}, .velocity = {3, 0, 0}, .material = material});
  run(w, 30);
  EXPECT_NEAR(w[b].velocity().x, 3 - 0.3 * 10 * 0.5, 0.02);
  run(w, 60);
  EXPECT_NEAR(w[b].center().x, 9 / (2 * 0.3 * 10), 0.02);
  EXPECT_LT(length(w[b].velocity()), 1e-4);
}

TEST(SoftStep, ABallRisesByTheSquareOfRestitution) {
  for (const double e : {1.0, 0.8, 0.5}) {
    const Material material{.restitution = Real(e)};
    World w = on_floor(soft(), material);
    const Body b = w.add({.shape = sphere(0.5), .at = {0, 2.5, 0}, .material = material});
    double apex = 0;
    bool bounced = false;
    for (int i = 0; i < 120; ++i) {
      w.step();
      bounced |= w[b].velocity().y > 0;
      if (bounced) apex = std::max(apex, w[b].center().y - 0.5);
      if (bounced && w[b].velocity().y < 0) break;
    }
    EXPECT_NEAR(apex, e * e * 2, 0.02) << e;
  }
}

// An impact between equals passes the speed on, whatever their order in the list.
TEST(SoftStep, ElasticBallsPassTheirSpeedOn) {
  for (const double from : {-1.0, 1.0}) {
    Config c = soft();
    World w(c);
    const Material elastic{0, 0, 1};
    std::vector<Body> balls;
    for (int i = 0; i < 5; ++i) balls.push_back(w.add({.shape = sphere(0.5), .at = {1.001 * i, 0, 0}, .material = elastic}));
    const Body hit = w.add({.shape = sphere(0.5), .at = {2.002 + from * 4, 0, 0}, .velocity = {Real(-2 * from), 0, 0},
                            .material = elastic});
    run(w, 120);
    const Body last = from < 0 ? balls.back() : balls.front();
    EXPECT_NEAR(w[last].velocity().x, -2 * from, 1e-4);
    EXPECT_NEAR(length(w[hit].velocity()), 0, 1e-4);
  }
}

// What rides on a turntable is carried round, not outwards.
TEST(SoftStep, FrictionCarriesRoundInACircle) {
  World w(soft());
  w.add(Gravity{{0, -10, 0}});
  const Body table = w.add({.shape = cylinder(4, 0.5), .at = {0, -0.25, 0}, .spin = {0, 1, 0}, .motion = Motion::kinematic});
  const Body rider = w.add({.shape = box({0.4, 0.4, 0.4}), .at = {2, 0.2, 0}, .velocity = {0, 0, -2}, .spin = {0, 1, 0}});
  run(w, 1200);
  const Pos p = w[rider].center(), c = w[table].center();
  EXPECT_NEAR(sqrt(square(p.x - c.x) + square(p.z - c.z)), 2, 0.01);
}

// Free bodies and thrusters move as with the other solver: the same physics between contacts.
TEST(SoftStep, FreeMotionAgreesWithTheReference) {
  const auto end = [](Solver solver) {
    Config c = soft();
    c.solver = solver;
    World w(c);
    w.add(Drag{.linear = Real(0.1), .quadratic = Real(0.05), .angular = Real(0.2)});
    const Body b = w.add({.shape = box({1, 2, 3}), .velocity = {4, 1, 0}, .spin = {1, 2, 3}});
    w.add(Thruster{.body = b, .force = {500, 0, 0}, .at = {0, Real(0.2), 0}});
    run(w, 60);
    return std::pair(w[b].center(), w[b].spin());
  };
  const auto [p, w] = end(Solver::soft_step);
  const auto [q, v] = end(Solver::impulse_2007);
  EXPECT_LT(length(p - q), 1e-4);
  EXPECT_LT(length(w - v), 1e-3);
}

namespace {

World heap(int lanes, int workers) {
  Config c = soft();
  c.soft_step.lanes = lanes, c.workers = workers;
  World w = on_floor(c, {.restitution = Real(0.2), .rolling = Real(0.01)});
  for (int i = 0; i < 120; ++i) {
    const Shape shape = i % 3 == 0 ? box({0.5, 0.4, 0.6}) : i % 3 == 1 ? capsule(0.2, 0.4) : sphere(0.3);
    w.add({.shape = shape, .at = {0.6 * (i % 5) + 0.01 * i, 0.5 + 0.5 * (i / 10), 0.7 * (i / 5 % 2)}, .spin = {0, Real(i), 0}});
  }
  return w;
}

// A net of balls that hangs from its upper edge: more joints than the reference solver is asked for.
World net(int lanes, int workers) {
  constexpr int side = 40;
  Config c = soft();
  c.soft_step.lanes = lanes, c.workers = workers;
  World w(c);
  w.add(Gravity{{0, -10, 0}});
  std::vector<Body> balls;
  for (int k = 0; k < side; ++k) {
    for (int i = 0; i < side; ++i) {
      const Motion motion = i == 0 ? Motion::fixed : Motion::dynamic;
      balls.push_back(w.add({.shape = sphere(0.4), .at = {double(k), double(-i), 0}, .motion = motion}));
      if (i > 0) w.join(Ball{.a = balls[balls.size() - 2], .b = balls.back(), .at = {double(k), 0.5 - i, 0}});
      if (i > 0 && k > 0) w.join(Ball{.a = balls[balls.size() - 1 - side], .b = balls.back(), .at = {k - 0.5, double(-i), 0}});
    }
  }
  return w;
}

}

TEST(SoftStep, LanesAndWorkersChangeNoBit) {
  for (const auto make : {heap, net}) {
    World one = make(1, 1);
    run(one, 60);
    for (const auto& [lanes, workers] : {std::pair(4, 1), {8, 2}, {16, 3}, {0, 1}}) {
      World other = make(lanes, workers);
      run(other, 60);
      EXPECT_EQ(other.motion_hash(), one.motion_hash()) << lanes << " lanes, " << workers << " workers";
    }
  }
}

// Joints of a net give way by millimetres, and its upper edge carries all of it: ∫ F dt = weight · time + momentum gained.
TEST(SoftStep, ANetHangsFromItsEdge) {
  World w = net(0, 1);
  double carried = 0, weight = 0;
  for (const Body b : w.bodies()) {
    if (w[b].motion() == Motion::dynamic) weight += 10 * double(w[b].mass());
  }
  const int steps = 120;
  double worst = 0;
  for (int i = 0; i < steps; ++i) {
    w.step();
    worst = std::max(worst, double(w.quality().joint_gap_max));
    for (const Joint j : w.joints()) {
      const JointDef def = w[j].definition();
      if (w[std::get<Ball>(def).a].motion() == Motion::fixed) carried += double(w[j].load().force.y) * w.config().dt;
    }
  }
  EXPECT_LT(worst, 0.01);
  const double gained = w.momentum().linear.y;
  EXPECT_NEAR(carried, weight * steps * w.config().dt + gained, 0.03 * weight * steps * w.config().dt);
}

// Everything that decides a later bit is saved.
TEST(SoftStep, GoesOnFromASnapshotAsIfNothingHadBeen) {
  World w = heap(0, 1);
  run(w, 40);
  World copy;
  copy.load(w.save());
  run(w, 60), run(copy, 60);
  EXPECT_EQ(copy.hash(), w.hash());
}

// A body that is pushed beyond all numbers stops alone.
TEST(SoftStep, QuarantinesWhatIsNotFinite) {
  World w = on_floor(soft());
  const std::vector<Body> cubes = tower(w, 3);
  const Body wild = w.add({.shape = sphere(0.5), .at = {5, 3, 0}, .mass = Real(1e-20)});
  w.add(Thruster{.body = wild, .force = {std::numeric_limits<Real>::max() / 4, 0, 0}});
  run(w, 5);
  EXPECT_TRUE(w[wild].quarantined());
  for (const Body b : cubes) EXPECT_FALSE(w[b].quarantined());
}
