// What differs is named, with both values: of two worlds, and of two recordings.
#include <sudar/difference.h>

#include "geometry/archive.h"
#include "unit/random.h"
#include "unit/worlds.h"

namespace sudar_test {
namespace {

struct Scene {
  World w;
  Body ground, ball, block;
  Joint rope;
  explicit Scene(const Config& config = steady(), Real radius = Real(0.5)) : w(config) {
    w.add(Gravity{});
    ground = add_floor(w);
    ball = w.add({.shape = sphere(radius), .at = {0, 3, 0}, .mass = 1, .name = "ball"});
    block = w.add(cube({2, 0.5, 0}));
    rope = w.join(Rope{.b = block, .at_a = {2, 4, 0}, .at_b = {2, 1, 0}});
  }
};

void expect_difference(const std::optional<Difference>& d, const char* field, Body body, std::int64_t index,
                       const char* a, const char* b) {
  ASSERT_TRUE(d);
  EXPECT_EQ(d->field, field);
  EXPECT_EQ(d->body.index, body.index);
  EXPECT_EQ(d->index, index);
  EXPECT_EQ(d->a, a);
  EXPECT_EQ(d->b, b);
}

TEST(DifferenceOfWorlds, NoneOfTheSame) {
  Scene a, b;
  EXPECT_FALSE(difference(a.w, b.w));
  step(a.w, 30), step(b.w, 30);
  EXPECT_FALSE(difference(a.w, b.w));
  EXPECT_EQ(a.w.hash(), b.w.hash());
}

TEST(DifferenceOfWorlds, NamesASetting) {
  Config other = steady();
  other.impulse_2007.contact_passes = 7;
  Scene a, b(other);
  expect_difference(difference(a.w, b.w), "config.impulse_2007.contact_passes", {}, -1, "80", "7");
  other = steady();
  other.broad = Broad::grid;
  Scene c(other);
  expect_difference(difference(a.w, c.w), "config.broad", {}, -1, "\"tree\"", "\"grid\"");
}

TEST(DifferenceOfWorlds, NamesABodysField) {
  Scene a, b;
  b.w.place(b.ball, {{0, 3.5, 0}, {}});
  expect_difference(difference(a.w, b.w), "position", a.ball, a.ball.index, "[0, 3, 0]", "[0, 3.5, 0]");
  Scene c;
  c.w.push(c.block, {0, 0, 8}, {2, 0.5, 0});
  expect_difference(difference(a.w, c.w), "force", a.block, a.block.index, "[0, 0, 0]", "[0, 0, 8]");
}

// Down to the part of a field that differs.
TEST(DifferenceOfWorlds, NamesAPartOfAField) {
  const auto world = [](Real rolling, const char* name) {
    World w(steady());
    w.add({.shape = sphere(1), .material = {.rolling = rolling}, .name = name});
    return w;
  };
  const World a = world(Real(0.25), "a"), b = world(Real(0.5), "a"), c = world(Real(0.25), "c \"quoted\"");
  const Body body = a.bodies().at(0);
  expect_difference(difference(a, b), "material.rolling", body, 0, "0.25", "0.5");
  expect_difference(difference(a, c), "name", body, 0, "\"a\"", "\"c \\\"quoted\\\"\"");
}

TEST(DifferenceOfWorlds, NamesJointsForcesSensorsAndPairs) {
  Scene a, b;
  const Joint servo = a.w.join(Hinge{.a = a.block, .at = {2, 0, 0}, .drive = {DriveMode::servo, 1, 9}});
  b.w.join(Hinge{.a = b.block, .at = {2, 0, 0}, .drive = {DriveMode::servo, 1, 8}});
  expect_difference(difference(a.w, b.w), "joints.definition.drive.force", {}, servo.index, "9", "8");
  Scene c, d;
  c.w.add(Drag{.linear = 1}), d.w.add(Drag{.linear = 2});
  expect_difference(difference(c.w, d.w), "forces.definition.linear", {}, 1, "1", "2");
  Scene e, f;
  e.w.add(Sensor{.a = e.ball}), f.w.add(Sensor{.a = f.block});
  const auto sensor = difference(e.w, f.w);
  ASSERT_TRUE(sensor);
  EXPECT_EQ(sensor->field, "sensors.a.index");
  Scene g, h;
  g.w.set_pair_material(g.ball, g.block, Material{.restitution = Real(0.5)});
  h.w.set_pair_material(h.ball, h.block, Material{.restitution = Real(0.75)});
  expect_difference(difference(g.w, h.w), "pair_materials.material.restitution", {}, 0, "0.5", "0.75");
}

TEST(DifferenceOfWorlds, NamesHowManyThereAre) {
  Scene a, b;
  b.w.add(cube({9, 9, 9}));
  expect_difference(difference(a.w, b.w), "bodies.live", {}, -1, "3", "4");
}

// The state holds only the number of a geometry. Two solids may have the same mass properties and reach.
TEST(DifferenceOfWorlds, SeesTheGeometry) {
  const auto world = [](Real edge) {
    const Vec3 corners[] = {{1, 0, 0}, {-1, 0, 0}, {0, edge, 0}, {0, 0, 1}, {0, 0, -1}};
    World w(steady());
    w.add({.shape = hull(corners), .mass = 1, .center = Vec3{}, .inertia = Mat3::identity(), .motion = Motion::fixed});
    return w;
  };
  const World a = world(Real(0.5)), b = world(Real(0.625));
  const auto d = difference(a, b);
  ASSERT_TRUE(d);
}

// Every field of every table is compared: what changes the hash is named.
TEST(DifferenceOfWorlds, NamesWhateverChangesTheHash) {
  Scene a, b;
  Random random(5);
  step(a.w, 60), step(b.w, 60);
  int named = 0;
  for (int i = 0; i < 60; ++i) {
    b.w.push(b.ball, convert<Real>(random.in_cube(50)), {0, 3, 0});
    b.w.step(), a.w.step();
    ASSERT_EQ(a.w.hash() == b.w.hash(), !difference(a.w, b.w).has_value());
    named += difference(a.w, b.w) ? 1 : 0;
  }
  EXPECT_GT(named, 0);
}

// --- recordings ---

// Pushes the ball before step 4, with the given force, and steps with the given length.
Bytes record(Real force, double last_dt = 0.01, int steps = 20, Scene scene = Scene()) {
  Recorder recorder(scene.w, "a scene");
  for (int i = 1; i <= steps; ++i) {
    if (i == 4) scene.w.push(scene.ball, {0, 0, force}, {0, 3, 0});
    scene.w.step(i == steps ? last_dt : 0.01);
    recorder.after_step();
  }
  return recorder.bytes();
}

std::optional<RecordingDifference> compare(const Bytes& a, const Bytes& b) {
  Replay of_a(a), of_b(b);
  return difference(of_a, of_b);
}

TEST(DifferenceOfRecordings, NoneOfTheSame) { EXPECT_FALSE(compare(record(5), record(5))); }

TEST(DifferenceOfRecordings, NamesWhatTheyBeginWith) {
  Config other = steady();
  other.substeps = 2;
  const auto setting = compare(record(5), record(5, 0.01, 20, Scene(other)));
  ASSERT_TRUE(setting);
  EXPECT_EQ(setting->step, 0);
  EXPECT_EQ(setting->stage, "start");
  expect_difference(setting->difference, "config.substeps", {}, -1, "1", "2");
  const auto body = compare(record(5), record(5, 0.01, 20, Scene(steady(), Real(0.75))));
  ASSERT_TRUE(body);
  EXPECT_EQ(body->step, 0);
  EXPECT_EQ(body->difference.body.index, Scene().ball.index);
}

TEST(DifferenceOfRecordings, NamesWhatTheUserDid) {
  const auto push = compare(record(5), record(6));
  ASSERT_TRUE(push);
  EXPECT_EQ(push->step, 4);
  EXPECT_EQ(push->stage, "operation");
  expect_difference(push->difference, "force", Scene().ball, Scene().ball.index, "[0, 0, 5]", "[0, 0, 6]");
  const auto longer = compare(record(5), record(5, 0.02));
  ASSERT_TRUE(longer);
  EXPECT_EQ(longer->step, 20);
  EXPECT_EQ(longer->stage, "operation");
  expect_difference(longer->difference, "dt", {}, -1, "0.01", "0.02");
}

TEST(DifferenceOfRecordings, NamesWhichIsLonger) {
  const auto d = compare(record(5), record(5, 0.01, 25));
  ASSERT_TRUE(d);
  EXPECT_EQ(d->step, 20);
  EXPECT_EQ(d->stage, "end");
  expect_difference(d->difference, "steps", {}, -1, "20", "25");
}

// As if another program had found something else: one recorded result is changed. This program agrees with the other.
TEST(DifferenceOfRecordings, NamesWhatAnotherProgramFound) {
  World w(steady());
  w.add(cube({0, 0, 0}));
  Bytes first, whole;
  {
    Recorder recorder(w, "");
    w.step(), recorder.after_step(), w.step(), recorder.after_step();
    first = recorder.bytes();
    w.step(), recorder.after_step();
    whole = recorder.bytes();
  }
  // Step 3 ends with the bodies' hashes, before the number of steps and the seal.
  const auto changed = [&](std::size_t from_end) {
    Bytes other = whole;
    other.resize(other.size() - 8);
    other[other.size() - 8 - from_end] ^= std::byte{1};
    ByteWriter sealed;
    sealed.raw(other);
    return sealed.take_sealed();
  };
  const std::size_t body_hash = 8, fields = body_hash + 8 + 8 * 20;  // some field's hash, counted from the end
  const auto d = compare(whole, changed(fields));
  ASSERT_TRUE(d);
  EXPECT_EQ(d->step, 3);
  EXPECT_NE(d->difference.field, "");
  const auto e = compare(changed(body_hash), whole);
  ASSERT_TRUE(e);
  EXPECT_EQ(e->step, 3);
  EXPECT_EQ(e->difference.body.index, w.bodies().at(0).index);
}

}
}
