// Sleep: what is quiet is not computed, and whatever could move it wakes it.
#include <functional>

#include "unit/worlds.h"

namespace sudar_test {
namespace {

// A cube asleep on a table (fixed) or on another cube.
struct Bedroom {
  World w{sleepy()};
  Body table = w.add({.shape = box({4, 1, 4}), .at = {0, -0.5, 0}, .motion = Motion::fixed});
  Body lower = w.add(cube({0, 0.5, 0})), upper = w.add(cube({0, 1.5, 0}));
  Bedroom() {
    w.add(Gravity{});
    step(w, 200);
  }
  bool asleep() const { return w[lower].asleep() && w[upper].asleep(); }
  bool awake() const { return !w[lower].asleep() && !w[upper].asleep(); }
};

TEST(Sleep, QuietIslandsSleepAndStay) {
  Bedroom room;
  ASSERT_TRUE(room.asleep());
  EXPECT_EQ(room.w.profile().awake, 0);
  EXPECT_EQ(room.w.contacts().size(), 2u);
  const std::uint64_t hash = room.w.motion_hash();
  step(room.w, 100);
  EXPECT_EQ(room.w.motion_hash(), hash);
  EXPECT_EQ(room.w[room.upper].velocity(), Vec3{});
}

TEST(Sleep, NeverWhereItIsForbidden) {
  World off(steady());
  off.add(Gravity{});
  add_floor(off);
  const Body a = off.add(cube({0, 0.5, 0}));
  World on(sleepy());
  on.add(Gravity{});
  add_floor(on);
  BodyDef def = cube({0, 0.5, 0});
  def.sleeps = false;
  const Body b = on.add(def), c = on.add(cube({0, 1.5, 0}));  // what lies on it cannot sleep either
  step(off, 200), step(on, 200);
  EXPECT_FALSE(off[a].asleep());
  EXPECT_FALSE(on[b].asleep());
  EXPECT_FALSE(on[c].asleep());
}

// Every change that could move it wakes the whole island.
TEST(Sleep, EveryChangeWakes) {
  const std::function<void(Bedroom&)> changes[] = {
      [](Bedroom& r) {
        r.w.push(r.upper, {0, 1, 0}, {0, 1.5, 0});
      },
      [](Bedroom& r) {
        r.w.set_velocity(r.upper, {1, 0, 0}, {});
      },
      [](Bedroom& r) {
        r.w.place(r.upper, {{0, 1.6, 0}, {}});
      },
      [](Bedroom& r) { r.w.wake(r.upper); },
      [](Bedroom& r) {
        r.w.join(Ball{.b = r.upper, .at = {0, 2, 0}});
      },
      [](Bedroom& r) {
        r.w.add(Gravity{{1, 0, 0}});
      },
      [](Bedroom& r) {
        r.w.add(Thruster{.body = r.upper, .force = {1, 0, 0}});
      },
      [](Bedroom& r) { r.w.remove(r.w.forces().at(0)); },
      [](Bedroom& r) {
        Config c = r.w.config();
        c.length_unit = 2;
        r.w.set_config(c);
      },
      [](Bedroom& r) {
        r.w.place(r.table, {{0, -0.6, 0}, {}});
      },
      [](Bedroom& r) { r.w.remove(r.table); },
      [](Bedroom& r) {
        r.w.add(cube({0.5, 2.49, 0}));
        r.w.step();
      },
  };
  int number = 0;
  for (const auto& change : changes) {
    Bedroom room;
    ASSERT_TRUE(room.asleep());
    change(room);
    EXPECT_TRUE(room.awake()) << "change " << number;
    ++number;
  }
}

TEST(Sleep, RemovedSupportWakesWhatLayOnIt) {
  Bedroom room;
  room.w.remove(room.lower);
  EXPECT_FALSE(room.w[room.upper].asleep());
  step(room.w, 100);
  EXPECT_NEAR(room.w[room.upper].center().y, 0.5, 0.02);
}
TEST(Sleep, RemovedTableLetsEverythingFall) {
  Bedroom room;
  room.w.remove(room.table);
  step(room.w, 100);
  EXPECT_NEAR(room.w[room.upper].velocity().y, -9.81, 1e-3);
}

TEST(Sleep, RemovedJointWakes) {
  World w(sleepy());
  w.add(Gravity{});
  const Body b = w.add(cube({0, 0, 0}));
  const Joint j = w.join(Fixed{.b = b, .at = {0, 0.5, 0}});
  step(w, 200);
  ASSERT_TRUE(w[b].asleep());
  w.remove(j);
  step(w, 100);
  EXPECT_NEAR(w[b].velocity().y, -9.81, 1e-3);
}

TEST(Sleep, NewDriveWakes) {
  World w(sleepy());
  const Body b = w.add(cube({0, 0, 0}));
  const Joint j = w.join(Slider{.b = b, .at = {0, 0, 0}});
  step(w, 200);
  ASSERT_TRUE(w[b].asleep());
  w.set_drive(j, {.mode = DriveMode::servo, .target = 1, .force = 10});
  step(w, 300);
  EXPECT_NEAR(w[j].coordinate(), 1, 1e-3);
}

// A moving ball wakes what it hits; a neighbour that nothing touches sleeps on.
TEST(Sleep, ImpactWakesItsIslandOnly) {
  Bedroom room;
  const Body alone = room.w.add(cube({1.8, 0.5, 0}));
  step(room.w, 100);
  ASSERT_TRUE(room.w[alone].asleep());
  room.w.add({.shape = sphere(Real(0.1)), .at = {0, 1.5, 3}, .velocity = {0, 0, -20}, .mass = Real(0.1)});
  for (int i = 0; i < 30 && room.asleep(); ++i) room.w.step();
  EXPECT_TRUE(room.awake());
  EXPECT_TRUE(room.w[alone].asleep());
}

// A kinematic lift that begins to move takes what sleeps on it along.
TEST(Sleep, MovingKinematicWakes) {
  World w(sleepy());
  w.add(Gravity{});
  const Body lift = w.add({.shape = box({4, 1, 4}), .at = {0, -0.5, 0}, .motion = Motion::kinematic});
  const Body b = w.add(cube({0, 0.5, 0}));
  step(w, 200);
  ASSERT_TRUE(w[b].asleep());
  w.set_velocity(lift, {0, 1, 0}, {});
  step(w, 100);
  EXPECT_NEAR(w[b].center().y, 1.5, 0.02);
  w.set_velocity(lift, {0, -1, 0}, {});
  step(w, 100);
  EXPECT_NEAR(w[b].center().y, 0.5, 0.02);
}

// Asleep or not, the outcome is the same to the eye: a stack that is hit late.
TEST(Sleep, ChangesNothingThatCanBeSeen) {
  double x[2];
  for (const bool sleep : {false, true}) {
    World w(sleep ? sleepy() : steady());
    w.add(Gravity{});
    add_floor(w);
    const Body b = w.add(cube({0, 0.5, 0}));
    step(w, 200);
    w.push(b, {2000, 0, 0}, {0, 0.5, 0});
    step(w, 100);
    x[sleep] = w[b].center().x;
  }
  EXPECT_NEAR(x[0], x[1], 1e-3);
}

}
}
