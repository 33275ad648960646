// Many islands that collide, hang on each other, fly apart and fall asleep, shared by several threads.
#include <sudar/record.h>

#include "unit/worlds.h"

#include <gtest/gtest.h>

#include <functional>

using namespace sudar;
using namespace sudar_test;

namespace {

World heaps(int workers, Solver solver = Config{}.solver) {
  Config c;
  c.workers = workers;
  c.solver = solver;
  World w(c);
  w.add(Gravity{});
  add_floor(w);
  const Body carrier = w.add({.shape = box({1, 1, 1}), .at = {0, 30, 0}, .spin = {0, 1, 0}, .motion = Motion::kinematic});
  for (int heap = 0; heap < 6; ++heap) {
    const double x = 6 * (heap % 6), z = 6 * (heap / 6) + 8;
    for (int k = 0; k < 8; ++k) w.add(cube({x + 0.1 * (k % 3), 0.6 + 1.1 * k, z}));
    Body above = heap % 3 == 0 ? carrier : Body{};
    for (int k = 0; k < 3; ++k) {
      const Body link = w.add({.shape = sphere(Real(0.2)), .at = {x + 0.6 * k, 30, z}});
      if (k > 0 || heap % 3 == 0) w.join(Ball{.a = above, .b = link, .at = {x + 0.6 * k - 0.3, 30, z}});
      above = link;
    }
  }
  return w;
}

void change_no_bit(const std::function<World(int workers)>& make) {
  std::vector<std::uint64_t> hashes;
  for (const int workers : {1, 2, 3, 5}) {
    World w = make(workers);
    std::uint64_t all = 0;
    for (int i = 0; i < 25; ++i) {
      w.step();
      all = all * 31 + w.hash() + w.events().hits.size() * 7 + w.events().begun.size();
    }
    hashes.push_back(all);
  }
  for (const std::uint64_t h : hashes) EXPECT_EQ(h, hashes[0]);
}

TEST(Workers, ChangeNoBit) {
  change_no_bit([](int workers) { return heaps(workers); });
}

// Towers enough for several batches of soft_step.
TEST(Workers, ChangeNoBitOfTheFastSolver) {
  change_no_bit([](int workers) { return heaps(workers, Solver::soft_step); });
  change_no_bit([](int workers) {
    Config c;
    c.workers = workers;
    c.solver = Solver::soft_step;
    World w(c);
    w.add(Gravity{});
    add_floor(w);
    for (int k = 0; k < 400; ++k) w.add(cube({3.0 * (k % 10), 0.6 + 1.1 * (k / 100), 3.0 * (k / 10 % 10)}));
    return w;
  });
}

TEST(Workers, AreNoPartOfTheState) {
  World one = heaps(1), three = heaps(3);
  step(one, 20), step(three, 20);
  EXPECT_EQ(one.hash(), three.hash());
  three.load(one.save());
  EXPECT_EQ(three.config().workers, 3);
  step(one, 20), step(three, 20);
  EXPECT_EQ(one.hash(), three.hash());
}

// A recording replays with the workers of the machine that replays it, settings changed on the way or not.
TEST(Workers, AreNoPartOfARecording) {
  World w = heaps(2);
  Recorder recorder(w, "heaps");
  for (int i = 0; i < 20; ++i) {
    if (i == 10) {
      Config c = w.config();
      c.substeps = 3;
      w.set_config(c);
    }
    w.step(), recorder.after_step();
  }
  for (const int workers : {1, 3}) {
    Replay replay(recorder.bytes(), workers);
    while (!replay.done()) ASSERT_FALSE(replay.step());
    EXPECT_EQ(replay.world().config().workers, workers);
    EXPECT_EQ(replay.world().config().substeps, 3);
    EXPECT_EQ(replay.world().hash(), w.hash());
  }
  EXPECT_THROW(Replay(recorder.bytes(), 0), Error);
}

}
