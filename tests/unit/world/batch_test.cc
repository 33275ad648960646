#include <sudar/batch.h>

#include <gtest/gtest.h>

#include "unit/worlds.h"

using namespace sudar;
using namespace sudar_test;

namespace {

World falling(int i) {
  World w;
  w.add(Gravity{});
  add_floor(w);
  for (int k = 0; k <= i; ++k) w.add(cube({0.1 * k, 1 + 1.1 * k, 0}));
  return w;
}

TEST(Batch, EveryWorldHasTheBitsThatItHasAlone) {
  Batch batch(3);
  EXPECT_EQ(batch.threads(), 3);
  std::vector<World> worlds;
  for (int i = 0; i < 7; ++i) worlds.push_back(falling(i));
  std::vector<World*> all;
  for (World& w : worlds) all.push_back(&w);
  batch.step(all, 20);
  batch.step(all);
  for (int i = 0; i < 7; ++i) {
    World alone = falling(i);
    for (int n = 0; n < 21; ++n) alone.step();
    EXPECT_EQ(worlds[std::size_t(i)].hash(), alone.hash());
  }
}

TEST(Batch, ThrowsWhatOneThrewWhenTheOthersAreDone) {
  World good = falling(0), empty = falling(0), last = falling(0);
  const World taken = std::move(empty);
  World* const all[] = {&good, &empty, &last};
  Batch batch(2);
  EXPECT_THROW(batch.step(all, 2), Error);
  EXPECT_EQ(good.steps(), 2);
  EXPECT_EQ(last.steps(), 2);
  EXPECT_NO_THROW(batch.step(std::span(all, 1)));
}

TEST(Batch, AsManyThreadsAsTheMachineHas) {
  EXPECT_GE(Batch().threads(), 1);
  EXPECT_THROW(Batch(-1), Error);
  EXPECT_THROW(Batch(1000), Error);
}

}
