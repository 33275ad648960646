// Save, load and hash: a restored world goes on with the same bits from every step, and damaged data is refused.
#include "unit/worlds.h"

namespace sudar_test {
namespace {

// A bit of everything: shapes, joints, forces, sensors, sleepers, a kinematic, dead slots.
struct Everything {
  World w;
  Body ball, lift, box_on_lift, thrown, sleeper;
  Joint hinge;
  SensorId sensor;

  static Config config() {
    Config c = sleepy(0.01);
    c.substeps = 2;
    return c;
  }
  Everything() : w(config()) {
    w.add(Gravity{});
    w.add(Drag{.linear = Real(0.1)});
    add_floor(w);
    const Body gone = w.add(cube({9, 9, 9}));
    ball = w.add({.shape = sphere(Real(0.5)), .at = {0, 3, 0}, .material = {.restitution = Real(0.7)}, .name = "ball"});
    w.remove(gone);
    lift = w.add(
        {.shape = box({3, Real(0.2), 3}), .at = {5, 1, 0}, .velocity = {0, Real(0.1), 0}, .motion = Motion::kinematic});
    box_on_lift = w.add(cube({5, 1.6, 0}));
    thrown =
        w.add({.shape = capsule(Real(0.3), 1), .at = {-3, 1, 0}, .velocity = {3, 2, 0}, .spin = {1, 2, 3}, .mass = 2});
    sleeper = w.add(cube({0, 0.5, 6}));
    const Body arm = w.add({.shape = prism(6, Real(0.2), 2), .at = {-6, 4, 0}, .mass = 1});
    hinge = w.join(Hinge{.b = arm,
                         .at = {-6, 5, 0},
                         .limit = {.low = -1, .high = 2},
                         .drive = {.mode = DriveMode::servo, .target = 1, .force = 9}});
    const Body bob = w.add(cube({-6, 2, 0}));
    w.join(Rope{.a = arm, .b = bob, .at_a = {-6, 3, 0}, .at_b = {-6, 2.5, 0}});
    w.add(Thruster{.body = thrown, .force = {0, 1, 0}, .at = {Real(0.1), 0, 0}});
    sensor = w.add(Sensor{.kind = SensorKind::odometer, .a = ball, .name = "way"});
  }
  // Changes that a running program makes.
  void control(int i) {
    if (i == 30) w.push(ball, {200, 0, 0}, {0, 1, 0});
    if (i == 50) w.set_surface_velocity(lift, {Real(0.5), 0, 0});
    if (i == 55) w.set_pair_material(ball, lift, Material{.restitution = 1});
    if (i == 60) w.remove(box_on_lift);
    if (i == 61) box_on_lift = w.add(cube({5, 3, 0}));
    if (i == 80) w.set_drive(hinge, {.mode = DriveMode::speed, .target = -2, .force = 5});
    if (i == 90) w.place(thrown, {{-3, 4, 0}, {}});
    if (i == 100) w.set_velocity(lift, {0, Real(-0.1), 0}, {});
  }
};

// At every step, and between a change and its step.
TEST(Snapshot, GoesOnWithTheSameBits) {
  Everything e;
  bool slept = false;
  for (int i = 0; i < 130; ++i) {
    e.control(i);
    World restored;
    restored.load(e.w.save());
    ASSERT_EQ(restored.hash(), e.w.hash());
    ASSERT_EQ(restored.save(), e.w.save());
    World ahead;  // several steps on its own
    ahead.load(e.w.save());
    e.w.step(), restored.step(), ahead.step();
    ASSERT_EQ(restored.hash(), e.w.hash()) << "after step " << i;
    ASSERT_EQ(restored.value(e.sensor), e.w.value(e.sensor));
    slept |= e.w[e.sleeper].asleep();
    if (i % 20 != 0) continue;
    Everything other;
    other.w.load(e.w.save());
    for (int k = 0; k < 40; ++k) ahead.step(), other.w.step();
    EXPECT_EQ(ahead.hash(), other.w.hash());
  }
  EXPECT_TRUE(slept);
}

TEST(Snapshot, HashesRepeat) {
  Everything a, b;
  EXPECT_EQ(a.w.hash(), b.w.hash());
  for (int i = 0; i < 130; ++i) {
    a.control(i), b.control(i);
    a.w.step(), b.w.step();
    ASSERT_EQ(a.w.hash(), b.w.hash());
  }
  a.w.push(a.ball, {0, Real(1e-3), 0}, {0, 0, 0});
  EXPECT_NE(a.w.hash(), b.w.hash());
}

// Two worlds in one process, their steps interleaved, are two worlds.
TEST(Snapshot, WorldsAreIndependent) {
  Everything alone, one, two;
  for (int i = 0; i < 50; ++i) alone.control(i), alone.w.step();
  for (int i = 0; i < 50; ++i) {
    one.control(i), one.w.step();
    two.w.step(0.003);
  }
  EXPECT_EQ(one.w.hash(), alone.w.hash());
  EXPECT_NE(two.w.hash(), alone.w.hash());
}

TEST(Snapshot, WorldsMove) {
  Everything e;
  step(e.w, 20);
  World other;
  other.load(e.w.save());
  World moved = std::move(e.w);
  step(moved, 20), step(other, 20);
  EXPECT_EQ(moved.hash(), other.hash());
  other = std::move(moved);
  step(other, 1);
  EXPECT_TRUE(other.alive(e.ball));
}

// Handles outlive saving: what was alive is alive, what was dead stays dead.
TEST(Snapshot, KeepsHandles) {
  Everything e;
  const Body dead = e.box_on_lift;
  e.w.remove(dead);
  World restored;
  restored.load(e.w.save());
  EXPECT_FALSE(restored.alive(dead));
  EXPECT_TRUE(restored.alive(e.ball));
  EXPECT_EQ(restored.find("ball"), e.ball);
  EXPECT_EQ(restored.add(cube({0, 0, 0})), e.w.add(cube({0, 0, 0})));
}

// --- data that is not a snapshot ---

std::string refusal(std::span<const std::byte> data) {
  World w(steady());
  w.add(cube({0, 0, 0}));
  const std::uint64_t hash = w.hash();
  try {
    w.load(data);
    return "";
  } catch (const Error& e) {
    EXPECT_EQ(w.hash(), hash) << "a refused snapshot changed the world";
    return e.what();
  }
}

TEST(Snapshot, RefusesForeignData) {
  EXPECT_NE(refusal({}), "");
  EXPECT_EQ(refusal(Bytes(1000, std::byte{7})), "data: is not a snapshot of a world");
  Bytes data = World().save();
  data[8] = std::byte{99};
  EXPECT_EQ(refusal(data), "version: is 99, this program reads 2");
  data = World().save();
  data[12] = std::byte{sizeof(Real) == 4 ? 8 : 4};
  EXPECT_EQ(refusal(data), std::string("precision: is ") + (sizeof(Real) == 4 ? "double" : "float") +
                               ", this program has the other one");
}

}
}
