// In the window a user deleted a brick that the scene watches. From then on every step threw "body: is dead", half of
// it done: the simulation could not be resumed, and a recording of it missed a step. Now the world goes on alone, and
// the scene, which knows no verdict, has a bad one.
#include <sudar/session.h>

#include "unit/worlds.h"

namespace sudar_test {
namespace {

// Pushes a ball and watches it; at the end it must have moved.
struct Pusher : Scenario {
  static constexpr double seconds = 1;
  Body ball;
  void state(State& s) override { s("ball", ball); }
  void build(World& w) override { ball = w.add({.shape = sphere(1), .mass = 1}); }
  void control(World& w, const Input&) override { w.push(ball, {1, 0, 0}, w[ball].center()); }
  void observe(const World& w, Check& c) override { c.below("height", w[ball].center().y, 1, "m"); }
  void check(const World& w, Check& c) override { c.above("way", w[ball].center().x, 0.1, "m"); }
};
const ScenarioEntry pusher{abi_of_this_file(),
                           "pusher",
                           "Tests/Pusher",
                           "",
                           Pusher::seconds,
                           1,
                           [](const ScenarioEntry&) -> Scenario* { return new Pusher; },
                           [](Scenario* s) { delete s; }};

TEST(RemovedByHand, TheWorldGoesOn) {
  Session s(pusher);
  const Body other = s.world().add({.shape = sphere(1), .at = {9, 0, 0}, .velocity = {0, 1, 0}, .mass = 1});
  for (int i = 0; i < 10; ++i) s.step();
  EXPECT_EQ(s.abandoned(), "");
  s.world().remove(s.world().bodies().front());
  s.step();
  EXPECT_NE(s.abandoned(), "");

  Catalogue catalogue;
  catalogue.add(&pusher);
  Session restored = Session::load(catalogue, s.save());
  while (!s.done()) s.step(), restored.step();
  EXPECT_EQ(s.world().steps(), 60);
  EXPECT_NEAR(s.world()[other].center().y, 1, 1e-5);
  EXPECT_EQ(restored.world().hash(), s.world().hash());
  EXPECT_FALSE(s.finish().passed());
  EXPECT_EQ(restored.finish().entries().size(), s.check().entries().size());
}

TEST(RemovedByHand, OnlyAtTheEnd) {
  Session s(pusher);
  while (!s.done()) s.step();
  s.world().remove(s.world().bodies().front());
  EXPECT_FALSE(s.finish().passed());
}

}
}
