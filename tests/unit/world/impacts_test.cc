// Fast bodies, with both solvers: nothing passes through anything (docs/impact.md).
#include <cmath>

#include "broad_kinds.h"
#include "unit/worlds.h"

namespace sudar_test {
namespace {

class Impacts : public WithEachSolver {};
INSTANTIATE_TEST_SUITE_P(Solvers, Impacts, each_solver(), solver_name);

Material material(double friction, double restitution) { return {Real(friction), Real(friction), Real(restitution)}; }

Body add_wall(World& w, double x, double thickness, const Material& m) {
  return w.add({.shape = box({Real(thickness), 4, 4}), .at = {x, 0, 0}, .material = m, .motion = Motion::fixed});
}

Body add_bullet(World& w, double x, double speed, const Material& m, double r = 0.01) {
  return w.add(
      {.shape = sphere(Real(r)), .at = {x, 0, 0}, .velocity = {Real(speed), 0, 0}, .mass = Real(0.01), .material = m});
}

TEST_P(Impacts, ABulletStopsAtAThinWallOrFliesBack) {
  for (const double speed : {100.0, 1000.0, 1e4}) {
    for (const double e : {0.0, 0.5, 1.0}) {
      World w(config());
      const Material m = material(0, e);
      add_wall(w, 50, 0.001, m);
      const Body b = add_bullet(w, 0, speed, m);
      const int steps = int(2 * 50 / speed * 60) + 3;
      step(w, steps);
      EXPECT_NEAR(double(w[b].velocity().x), -e * speed, 1e-3 * speed) << speed << " m/s, e = " << e;
      const double moment = (50 - 0.01 - 0.0005) / speed, x = 50 - 0.0105 - e * speed * (w.time() - moment);
      EXPECT_NEAR(w[b].center().x, x, 0.005 + 1e-4 * speed) << speed << " m/s, e = " << e;
      EXPECT_LT(w[b].center().x, 50 - 0.0095) << speed << " m/s, e = " << e;
    }
  }
}

TEST_P(Impacts, AFastBallStaysInAClosedBox) {
  const Vec3 v[] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}};
  const std::uint32_t inward[] = {0, 1, 2, 0, 2, 3, 4, 6, 5, 4, 7, 6, 0, 4, 5, 0, 5, 1,
                                  3, 2, 6, 3, 6, 7, 0, 3, 7, 0, 7, 4, 1, 5, 6, 1, 6, 2};
  for (const double e : {0.9, 1.0}) {
    World w(config());
    const Material m = material(0, e);
    w.add({.shape = mesh(v, inward), .material = m, .motion = Motion::fixed});
    const Body b = w.add({.shape = sphere(Real(0.05)), .velocity = {173, 211, 97}, .material = m});
    double energy = w[b].kinetic_energy();
    const double all = energy;
    for (int s = 0; s < 600; ++s) {
      w.step();
      const Pos p = w[b].center();
      ASSERT_LT(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}), 0.9876) << "step " << s;
      ASSERT_LE(w[b].kinetic_energy(), energy * (1 + 1e-5));
      energy = w[b].kinetic_energy();
    }
    EXPECT_GE(energy, e == 1 ? all * (1 - 1e-3) : 0);
  }
}

// A post beside the hub: the rod comes round once in 12.6 ms.
TEST_P(Impacts, ASpinningRodMeetsAThinPost) {
  for (const double spin : {50.0, 500.0, -500.0}) {
    World w(config());
    const Material m = material(0, 1);
    const Body rod = w.add({.shape = capsule(Real(0.01), 1),
                            .turn = axis_angle(Vec3{0, 0, 1}, Real(0.3)),
                            .spin = {0, 0, Real(spin)},
                            .mass = 1,
                            .material = m});
    w.add({.shape = cylinder(Real(0.005), 1),
           .at = {0.3, 0, 0},
           .turn = axis_angle(Vec3{1, 0, 0}, Real(pi / 2)),
           .material = m,
           .motion = Motion::fixed});
    const double energy = w[rod].kinetic_energy();
    bool met = false;
    for (int s = 0; s < 12 && !met; ++s) {
      w.step();
      met = std::abs(double(w[rod].spin().z) - spin) > 0.1 * std::abs(spin);
      EXPECT_LE(w[rod].kinetic_energy(), energy * 1.001);
    }
    EXPECT_TRUE(met) << spin << " rad/s";
  }
}

TEST_P(Impacts, TwoBulletsMeetHeadOn) {
  for (const double speed : {50.0, 1e4}) {
    World w(config());
    const Material m = material(0, 1);
    const Body a = add_bullet(w, -31, speed, m), b = add_bullet(w, 30, -speed, m);
    step(w, int(61 / speed * 60) + 2);
    EXPECT_NEAR(double(w[a].velocity().x), -speed, 1e-3 * speed);
    EXPECT_NEAR(double(w[b].velocity().x), speed, 1e-3 * speed);
    EXPECT_LT(w[a].center().x, w[b].center().x);
  }
}

TEST_P(Impacts, ABulletIntoAHeapGivesItsMomentum) {
  World w(config());
  std::vector<Body> heap;
  for (int k = 0; k < 27; ++k) {
    heap.push_back(w.add(
        {.shape = box({1, 1, 1}), .at = {1.001 * (k % 3), 1.001 * (k / 3 % 3), 1.001 * double(k / 9)}, .mass = 1}));
  }
  const Body b = w.add({.shape = sphere(Real(0.1)), .at = {-20, 1, 1}, .velocity = {2000, 3, 2}, .mass = Real(0.1)});
  const double energy = w.energy().kinetic, momentum = w.momentum().linear.x;
  for (int s = 0; s < 60; ++s) {
    w.step();
    EXPECT_LE(w.energy().kinetic, energy * 1.001) << s;
  }
  EXPECT_NEAR(w.momentum().linear.x, momentum, 1e-3 * momentum);
  EXPECT_LT(w[b].center().x, w[heap[12]].center().x);  // it met this one
}

TEST_P(Impacts, ThinPlatesDoNotPassEachOther) {
  for (const double speed : {30.0, 1000.0}) {
    World w(config());
    const Material m = material(0.3, 0);
    const Shape plate = box({Real(0.002), 1, 1});
    const Body a = w.add({.shape = plate,
                          .at = {-10, 0, 0},
                          .turn = axis_angle(Vec3{0, 1, 0}, Real(0.01)),
                          .velocity = {Real(speed), 0, 0},
                          .mass = 1,
                          .material = m});
    const Body b = w.add({.shape = plate,
                          .at = {10, 0, 0},
                          .turn = axis_angle(Vec3{0, 0, 1}, Real(-0.02)),
                          .velocity = {Real(-speed), 0, 0},
                          .mass = 1,
                          .material = m});
    step(w, int(20 / speed * 60) + 2);
    EXPECT_LT(w[a].center().x, w[b].center().x) << speed;
    EXPECT_LT(std::abs(double(w[a].velocity().x - w[b].velocity().x)), 1.5 * speed);
  }
}

// Bounces of a ball in a wedge have no end, if it is inelastic; the step has.
TEST_P(Impacts, AWedgeEndsTheBounces) {
  World w(config());
  const Material m = material(0, 0.7);
  for (const double side : {-1.0, 1.0}) {
    const double angle = side * 0.1;
    w.add({.shape = box({20, 1, 5}),
           .at = {0, side * 0.5, 0},
           .turn = axis_angle(Vec3{0, 0, 1}, Real(-angle)),
           .material = m,
           .motion = Motion::fixed});
  }
  const Body b =
      w.add({.shape = sphere(Real(0.1)), .at = {-8, 0.02, 0}, .velocity = {1000, 50, 0}, .mass = 1, .material = m});
  const double energy = w[b].kinetic_energy();
  for (int s = 0; s < 120; ++s) {
    w.step();
    ASSERT_LE(w[b].kinetic_energy(), energy);
    ASSERT_LT(w[b].center().x, 0.5) << s;
  }
}

// What a moving wall runs into is pushed along.
TEST_P(Impacts, AFastKinematicPlateTakesALightBallAlong) {
  World w(config());
  const Body ball = w.add({.shape = sphere(Real(0.05)), .at = {0, 0, 0}, .mass = 1});
  const Body plate = w.add(
      {.shape = box({Real(0.01), 1, 1}), .at = {-10, 0, 0}, .velocity = {300, 0, 0}, .motion = Motion::kinematic});
  step(w, 10);
  EXPECT_GT(w[ball].center().x, w[plate].center().x);
  EXPECT_NEAR(double(w[ball].velocity().x), 300, 3);
}

TEST_P(Impacts, AFastBallStaysInABowlAndAPipe) {
  const Material m = material(0, 1);
  for (const Shape& shape : {hollow_sphere(1), hollow_cylinder(1, 1e4)}) {
    World w(config());
    w.add({.shape = shape, .material = m, .motion = Motion::fixed});
    const Body b = w.add({.shape = sphere(Real(0.05)), .at = {0.3, 0.1, 0}, .velocity = {300, 60, 200}, .material = m});
    const double energy = w[b].kinetic_energy();
    for (int s = 0; s < 300; ++s) {
      w.step();
      const Pos p = w[b].center();
      const double y = shape.kind() == ShapeKind::hollow_sphere ? p.y : 0;
      ASSERT_LT(std::sqrt(p.x * p.x + y * y + p.z * p.z), 1) << s;
    }
    EXPECT_NEAR(w[b].kinetic_energy(), energy, 1e-3 * energy);
  }
}

// What it hangs on does not tear.
TEST_P(Impacts, AHingedRodDoesNotPassAPost) {
  for (const double spin : {30.0, 300.0}) {
    World w(config());
    const Material m = material(0, 0.5);
    const Body rod = w.add({.shape = box({1, Real(0.02), Real(0.02)}),
                            .at = {0.5, 0, 0},
                            .velocity = {0, Real(spin / 2), 0},
                            .spin = {0, 0, Real(spin)},
                            .mass = 1,
                            .material = m});
    const Joint hinge = w.join(Hinge{.b = rod, .at = {0, 0, 0}, .axis = {0, 0, 1}});
    w.add({.shape = cylinder(Real(0.01), 1),
           .at = {-0.6, 0, 0},
           .turn = axis_angle(Vec3{1, 0, 0}, Real(pi / 2)),
           .material = m,
           .motion = Motion::fixed});
    const double energy = w[rod].kinetic_energy();
    for (int s = 0; s < 60; ++s) {
      w.step();
      EXPECT_LE(w[rod].kinetic_energy(), energy * 1.001);
      EXPECT_LT(w.quality().joint_gap_max, 5e-4 * spin) << spin << ", step " << s;
      ASSERT_LT(std::abs(double(w[hinge].coordinate())), pi) << spin << ", step " << s;
    }
  }
}

TEST_P(Impacts, PartsOfABodyMeetAWall) {
  World w(config());
  const Material m = material(0, 0);
  add_wall(w, 50, 0.001, m);
  const auto ball = [](double x, double y) {
    return ShapeDef{.shape = sphere(Real(0.02)), .at = {Real(x), Real(y), 0}};
  };
  const Body b = w.add({.shapes = {ball(-0.2, 0), ball(0.2, 0), ball(0, 0.3)},
                        .velocity = {2000, 0, 0},
                        .spin = {0, 0, 30},
                        .mass = 1,
                        .material = m});
  for (int s = 0; s < 60; ++s) {
    w.step();
    for (const ShapeId part : w[b].shapes()) ASSERT_LT(w[part].pose().p.x, 50) << s;
  }
}

TEST_P(Impacts, AKinematicMeshLiftsWhatItMeets) {
  const Vec3 v[] = {{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}};
  const std::uint32_t up[] = {0, 2, 1, 0, 3, 2};
  World w(config());
  const Body plate =
      w.add({.shape = mesh(v, up), .at = {0, -5, 0}, .velocity = {0, 100, 0}, .motion = Motion::kinematic});
  const Body ball = w.add({.shape = sphere(Real(0.02)), .at = {0.3, 0, 0.2}, .mass = 1});
  step(w, 20);
  EXPECT_GT(w[ball].center().y, w[plate].center().y);
}

TEST_P(Impacts, ABallBreaksThroughAWallOfBricksAtAnySpeed) {
  for (const double speed : {200.0, 1000.0, 1e4}) {
    World w(config());
    w.add(Gravity{});
    add_floor(w);
    std::vector<Body> bricks;
    for (int k = 0; k < 30; ++k) {
      bricks.push_back(w.add({.shape = box({2, Real(0.6), 1}),
                              .at = {2.02 * (k % 5 - 2) + (k / 5 % 2), 0.3 + 0.6 * double(k / 5), 0},
                              .mass = 1}));
    }
    const Body ball =
        w.add({.shape = sphere(Real(0.6)), .at = {0.1, 1.4, 30}, .velocity = {0, 0, Real(-speed)}, .mass = 2});
    const double energy = w[ball].kinetic_energy();
    for (int s = 0; s < 30; ++s) {
      w.step();
      EXPECT_LT(w.energy().kinetic, 1.001 * energy + 30);
    }
    EXPECT_GT(double(w[ball].velocity().z), -0.9 * speed) << speed;
    int met = 0;
    for (const Body b : bricks) met += double(w[b].velocity().z) < -0.05 * speed;
    EXPECT_GT(met, 0) << speed;
  }
}

TEST_P(Impacts, SleepersWake) {
  World w;
  Config c = config();
  c.sleep = true;
  w.set_config(c);
  w.add(Gravity{});
  add_floor(w);
  const Body sleeper = w.add(cube({0, 0.5, 0}));
  step(w, 120);
  ASSERT_TRUE(w[sleeper].asleep());
  w.add({.shape = sphere(Real(0.05)), .at = {-20, 0.5, 0}, .velocity = {900, 0, 0}, .mass = Real(0.1)});
  step(w, 4);
  EXPECT_FALSE(w[sleeper].asleep());
  EXPECT_GT(double(w[sleeper].velocity().x), 10);
}

// The same bits.
World shrapnel(Config c) {
  World w(c);
  w.add(Gravity{});
  add_floor(w);
  for (int k = 0; k < 60; ++k) {
    const auto at = [&](int m) { return double((k * 37 + m) % 11 - 5); };
    BodyDef b{.shape = k % 2 == 0 ? sphere(Real(0.1)) : box({Real(0.02), Real(0.3), Real(0.3)}),
              .at = {at(0) * 2, 2 + at(3) / 4 + 0.07 * k, at(7) * 2}};
    b.velocity = {Real(-90 * at(0)), Real(3 * at(5)), Real(-70 * at(7))};
    b.spin = {Real(20 * at(1)), 5, Real(10 * at(2))};
    b.material.restitution = Real(0.5);
    b.mass = 1;
    w.add(b);
  }
  return w;
}

TEST_P(Impacts, HaveTheSameBitsHoweverTheyAreFound) {
  World reference = shrapnel(config());
  std::vector<std::uint64_t> hashes;
  std::size_t hits = 0;
  for (int s = 0; s < 30; ++s) hits += reference.step().hits.size(), hashes.push_back(reference.motion_hash());
  EXPECT_GT(hits, 10u);
  for (const Broad kind : broad_kinds()) {
    for (const int workers : {1, 3}) {
      Config c = config();
      c.broad = kind, c.workers = workers, c.soft_step.lanes = workers == 1 ? 4 : 0;
      World w = shrapnel(c);
      for (int s = 0; s < 30; ++s) {
        w.step();
        ASSERT_EQ(w.motion_hash(), hashes[std::size_t(s)])
            << name_of(kind) << ", " << workers << " workers, step " << s;
        World restored;
        restored.load(w.save());
        w = std::move(restored);
      }
    }
  }
}

}
}
