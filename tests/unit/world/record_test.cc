// Recordings: every operation is kept and replayed to the same bits; a difference is named; damage is refused.
#include <sudar/record.h>

#include "base/archive.h"
#include "unit/worlds.h"

namespace sudar_test {
namespace {

// Every line of world/ops.def at least once.
Bytes record_everything(World& w, int steps = 40) {
  w.add(Gravity{});
  const Body ground = add_floor(w);
  const Body before = w.add(cube({0, 3, 0}));
  Recorder recorder(w, "everything");
  const Body a = w.add(cube({2, 1, 0})), b = w.add({.shape = sphere(Real(0.5)), .at = {2, 3, 0}, .name = "ball"});
  const ForceId drag = w.add(Drag{.linear = 1});
  const SensorId sensor = w.add(Sensor{.a = a, .b = b});
  const Joint hinge = w.join(Hinge{.a = a, .b = b, .at = {2, 2, 0}});
  for (int i = 0; i < steps; ++i) {
    if (i == 3) w.push(before, {0, 0, 99}, {0, 3, 0});
    if (i == 4) w.twist(before, {5, 0, 0});
    if (i == 5) w.place(before, {{-2, 1, 0}, axis_angle(Vec3{0, 1, 0}, Real(1))});
    if (i == 7) w.set_velocity(a, {1, 2, 3}, {3, 2, 1});
    if (i == 8) w.set_surface_velocity(ground, {1, 0, 2}), w.set_pair_material(ground, b, Material{.restitution = 1});
    if (i == 9) w.set_drive(hinge, {.mode = DriveMode::speed, .target = 3, .force = 10});
    if (i == 11) {
      Config c = w.config();
      c.substeps = 3, c.impulse_2007.contact_passes = 33;
      w.set_config(c);
    }
    if (i == 12) w.add(a, {.shape = sphere(Real(0.2)), .at = {0, Real(0.7), 0}});
    if (i == 13) w.wake(before);
    if (i == 14) w.remove(w[a].shapes()[0]);
    if (i == 15) w.remove(sensor);
    if (i == 17) w.remove(drag);
    if (i == 19) w.remove(hinge);
    if (i == 21) w.remove(a);
    if (i == 23) w.remove(ground);
    if (i % 10 == 9)
      w.step(0.003);
    else
      w.step();
    recorder.after_step();
  }
  return recorder.bytes();
}

TEST(Recording, ReplaysEveryOperation) {
  World w(sleepy());
  Replay replay(record_everything(w));
  EXPECT_EQ(replay.title(), "everything");
  EXPECT_EQ(replay.steps(), 40);
  while (!replay.done()) {
    const auto difference = replay.step();
    ASSERT_FALSE(difference) << "step " << difference->step << ", stage " << difference->stage;
  }
  EXPECT_EQ(replay.world().hash(), w.hash());
  EXPECT_EQ(replay.world().time(), w.time());
  EXPECT_THROW(replay.step(), Error);
}

// Recording changes nothing, and ends with the recorder.
TEST(Recording, ChangesNothing) {
  World recorded(sleepy()), plain(sleepy());
  for (World* w : {&recorded, &plain}) w->add(Gravity{}), add_floor(*w), w->add(cube({0, 2, 0}));
  {
    Recorder recorder(recorded, "");
    for (int i = 0; i < 50; ++i) recorded.step(), recorder.after_step();
  }
  step(plain, 50);
  EXPECT_EQ(recorded.hash(), plain.hash());
  step(recorded, 5), step(plain, 5);
  EXPECT_EQ(recorded.hash(), plain.hash());
}

// Started in the midst of a run, of a world that sleeps.
TEST(Recording, StartsAnywhere) {
  World w(sleepy());
  w.add(Gravity{});
  add_floor(w);
  const Body b = w.add(cube({0, 0.5, 0}));
  step(w, 100);
  ASSERT_TRUE(w[b].asleep());
  w.push(b, {0, 500, 0}, {0, 0.5, 0});
  Recorder recorder(w, "");
  for (int i = 0; i < 20; ++i) w.step(), recorder.after_step();
  Replay replay(recorder.bytes());
  while (!replay.done()) EXPECT_FALSE(replay.step());
  EXPECT_EQ(replay.world().hash(), w.hash());
}

// What refused operations threw is not in it.
TEST(Recording, KeepsNoRefusedOperation) {
  World w(sleepy());
  const Body b = w.add(cube({0, 0, 0}));
  Recorder recorder(w, "");
  EXPECT_THROW(w.push(Body{}, {}, {}), Error);
  EXPECT_THROW(w.set_velocity(b, {std::numeric_limits<Real>::infinity(), 0, 0}, {}), Error);
  w.step(), recorder.after_step();
  Replay replay(recorder.bytes());
  EXPECT_FALSE(replay.step());
}

// A push of 99 N changed to 98 N: the replay names the step, the first stage, field and body that differ.
TEST(Recording, NamesTheFirstDifference) {
  World w(sleepy());
  Bytes recording = record_everything(w);
  const Real was = 99, is = 98;
  const auto pattern = std::as_bytes(std::span(&was, 1)), other = std::as_bytes(std::span(&is, 1));
  const auto at = std::search(recording.begin(), recording.end(), pattern.begin(), pattern.end());
  ASSERT_NE(at, recording.end());
  std::copy(other.begin(), other.end(), at);
  EXPECT_THROW(Replay{recording}, Error);  // its seal is broken
  recording.resize(recording.size() - 8);
  ByteWriter sealed;
  sealed.raw(recording);
  Replay replay(sealed.take_sealed());
  std::optional<Divergence> difference;
  while (!replay.done() && !difference) difference = replay.step();
  ASSERT_TRUE(difference);
  EXPECT_EQ(difference->step, 4);
  EXPECT_EQ(difference->stage, "pairs");  // the push itself differs before any stage runs
  EXPECT_EQ(difference->field, "position");
  EXPECT_EQ(difference->body, replay.world().bodies().at(1));
}

TEST(Recording, RefusesWhatIsNone) {
  EXPECT_THROW(Replay(Bytes{}), Error);
  EXPECT_THROW(Replay(Bytes(500, std::byte{1})), Error);
  World w(sleepy());
  const Bytes whole = record_everything(w, 5);
  for (std::size_t n = 0; n < whole.size(); n += 7) {
    EXPECT_THROW(Replay(Bytes(whole.begin(), whole.begin() + std::ptrdiff_t(n))), Error);
    Bytes turned = whole;
    turned[n] ^= std::byte{16};
    EXPECT_THROW(Replay{turned}, Error);
  }
}

// So far, at any time.
TEST(Recording, BytesSoFar) {
  World w(sleepy());
  w.add(Gravity{});
  w.add(cube({0, 0, 0}));
  Recorder recorder(w, "");
  for (int i = 0; i < 10; ++i) {
    w.step(), recorder.after_step();
    EXPECT_EQ(Replay(recorder.bytes()).steps(), i + 1);
  }
}

// A world that is recorded may move house.
TEST(Recording, FollowsAMovedWorld) {
  World w(sleepy());
  w.add(Gravity{});
  const Body b = w.add(cube({0, 0, 0}));
  World moved;  // made first: a world outlives its recorder
  Recorder recorder(w, "");
  w.step(), recorder.after_step();
  moved = std::move(w);
  moved.push(b, {5, 0, 0}, {0, 0, 0});
  moved.step(), recorder.after_step();
  Replay replay(recorder.bytes());
  while (!replay.done()) EXPECT_FALSE(replay.step());
  EXPECT_EQ(replay.world().hash(), moved.hash());
}

}
// Loading is recorded: the run may begin anew, in another world, and the recording goes on.
TEST(Recording, OfARunThatLoads) {
  World other(sleepy());
  other.add(Gravity{{1, 0, 0}});
  other.add(cube({4, 3, 2}));
  World w(sleepy());
  w.add(Gravity{});
  const Body b = w.add(cube({0, 0, 0}));
  Recorder recorder(w, "");
  w.push(b, {5, 0, 0}, {0, 0, 0});
  w.step(), recorder.after_step();
  w.push(b, {0, 0, 7}, {0, 0, 0});
  w.load(other.save());
  for (int i = 0; i < 3; ++i) w.step(), other.step(), recorder.after_step();
  EXPECT_EQ(w.hash(), other.hash());
  EXPECT_THROW(w.load(Bytes(100)), Error);
  w.step(), recorder.after_step();
  Replay replay(recorder.bytes());
  EXPECT_EQ(replay.steps(), 5);
  while (!replay.done()) EXPECT_FALSE(replay.step());
  EXPECT_EQ(replay.world().hash(), w.hash());
}

}
