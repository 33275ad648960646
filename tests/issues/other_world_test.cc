// A handle of another world was taken for one's own: u.remove(b) removed whatever of u's had the same place. And a World
// that was moved from crashed at the first question.
#include <sudar/record.h>

#include <functional>

#include "unit/worlds.h"

namespace sudar_test {
namespace {

void expect_refused(World& w, const char* field, const std::function<void()>& what) {
  const std::uint64_t hash = w.hash();
  try {
    what();
    ADD_FAILURE() << field << " of another world was taken";
  } catch (const Error& e) {
    EXPECT_EQ(e.field, field) << e.what();
    EXPECT_NE(std::string(e.what()).find("another world"), std::string::npos) << e.what();
  }
  EXPECT_EQ(w.hash(), hash) << field;
}

// Two worlds that are built alike, so that every handle of one would fit into the other.
struct Pair {
  World w{steady()};
  Body a = w.add(cube({0, 0, 0})), b = w.add(cube({0, 3, 0}));
  Joint hinge = w.join(Hinge{.a = a, .b = b, .at = {0, 1, 0}});
  ForceId gravity = w.add(Gravity{});
  SensorId way = w.add(Sensor{.kind = SensorKind::odometer, .a = a});
};

TEST(OtherWorld, IsRefusedAtEveryEntry) {
  Pair mine, other;
  World& w = mine.w;
  const Body a = mine.a, b = mine.b, x = other.a;
  EXPECT_FALSE(w.alive(x));
  EXPECT_FALSE(w.alive(other.hinge));
  EXPECT_NE(a, x);
  expect_refused(w, "body", [&] { w.remove(x); });
  expect_refused(w, "joint", [&] { w.remove(other.hinge); });
  expect_refused(w, "force", [&] { w.remove(other.gravity); });
  expect_refused(w, "sensor", [&] { w.remove(other.way); });
  expect_refused(w, "body", [&] { w.push(x, {1, 0, 0}, {}); });
  expect_refused(w, "body", [&] { w.twist(x, {1, 0, 0}); });
  expect_refused(w, "body", [&] { w.place(x, {}); });
  expect_refused(w, "body", [&] { w.set_velocity(x, {}, {}); });
  expect_refused(w, "body", [&] { w.set_surface_velocity(x, {}); });
  expect_refused(w, "a", [&] { w.set_pair_material(x, b, {}); });
  expect_refused(w, "b", [&] { w.set_pair_material(a, other.b, {}); });
  expect_refused(w, "joint", [&] { w.set_drive(other.hinge, {}); });
  expect_refused(w, "body", [&] { w.wake(x); });
  expect_refused(w, "body", [&] { w.add(Drag{.body = x}); });
  expect_refused(w, "body", [&] { w.add(Thruster{.body = x}); });
  expect_refused(w, "a", [&] { w.add(Sensor{.a = x}); });
  expect_refused(w, "b", [&] { w.add(Sensor{.a = a, .b = x}); });
  expect_refused(w, "ball.a", [&] { w.join(Ball{.a = x, .b = b}); });
  expect_refused(w, "ball.b", [&] { w.join(Ball{.a = a, .b = x}); });
  expect_refused(w, "body", [&] { w[x]; });
  expect_refused(w, "joint", [&] { w[other.hinge]; });
  expect_refused(w, "force", [&] { w[other.gravity]; });
  expect_refused(w, "sensor", [&] { w[other.way]; });
  expect_refused(w, "sensor", [&] { w.value(other.way); });
  expect_refused(w, "a", [&] { w.touching(x, a); });
  expect_refused(w, "b", [&] { w.pair_material(a, other.b); });
  expect_refused(w, "body", [&] { w.distance(a, x); });
}

// What a world says of itself is its own: everything it lists, reports and gives back.
TEST(OtherWorld, OwnHandlesComeBackFromEverywhere) {
  Pair p;
  World& w = p.w;
  add_floor(w, -0.5);
  w.step();
  for (const Body b : w.bodies()) EXPECT_TRUE(w.alive(b));
  for (const Joint j : w.joints()) EXPECT_EQ(std::get<Hinge>(w[j].definition()).a, p.a);
  for (const SensorId s : w.sensors()) EXPECT_EQ(w[s].a, p.a);
  ASSERT_FALSE(w.contacts().empty());
  for (const Contact& c : w.contacts()) EXPECT_TRUE(w.alive(c.a) && w.alive(c.b));
  for (const Events::Touch& t : w.events().begun) EXPECT_TRUE(w.alive(t.a) && w.alive(t.b));
  EXPECT_TRUE(w.alive(w.ray_cast({0, 9, 0}, {0, -1, 0}, 99)->body));
}

// The handles of a world are good in one that was loaded from it, be it through a recording; its own are then dead.
TEST(OtherWorld, ALoadedWorldKnowsTheHandlesOfTheOneThatWasSaved) {
  Pair saved;
  Pair loaded;
  loaded.w.load(saved.w.save());
  EXPECT_TRUE(loaded.w.alive(saved.a));
  EXPECT_FALSE(loaded.w.alive(loaded.a));
  EXPECT_EQ(std::get<Hinge>(loaded.w[saved.hinge].definition()).b, saved.b);
  EXPECT_EQ(loaded.w[saved.way].a, saved.a);
  EXPECT_EQ(loaded.w[saved.way].b, Body{});
  loaded.w.remove(saved.a);
  EXPECT_TRUE(loaded.w.joints().empty());

  Recorder recorder(saved.w, "two");
  saved.w.push(saved.b, {1, 2, 3}, {});
  saved.w.step(), recorder.after_step();
  const Body late = saved.w.add(cube({9, 9, 9}));
  saved.w.remove(saved.hinge);
  saved.w.step(), recorder.after_step();
  saved.w.load(loaded.w.save());  // the same number
  Pair third;
  saved.w.load(third.w.save());  // another one, whose handles are good from here on
  saved.w.push(third.a, {1, 2, 3}, {});
  saved.w.step(), recorder.after_step();
  EXPECT_FALSE(saved.w.alive(late));
  Replay replay(recorder.bytes());
  while (!replay.done()) EXPECT_FALSE(replay.step());
  EXPECT_TRUE(replay.world().alive(third.a));
  EXPECT_FALSE(replay.world().alive(late));
}

// Which world a handle is of is in no hash: the same input gives the same bits.
TEST(OtherWorld, IsInNoHash) {
  Pair one, two;
  for (int i = 0; i < 20; ++i) one.w.step(), two.w.step();
  EXPECT_EQ(one.w.hash(), two.w.hash());
}

TEST(MovedFrom, IsAnErrorAndNoCrash) {
  Pair p;
  World moved = std::move(p.w);
  World& w = p.w;
  EXPECT_NO_THROW(moved[p.a]);
  const std::function<void()> questions[] = {
      [&] { w.step(); },      [&] { w.step(0.1); },          [&] { w.add(cube({0, 0, 0})); },
      [&] { w[p.a]; },        [&] { w.alive(p.a); },         [&] { w.alive(p.hinge); },
      [&] { w.bodies(); },    [&] { w.joints(); },           [&] { w.forces(); },
      [&] { w.sensors(); },   [&] { w.contacts(); },         [&] { w.events(); },
      [&] { w.config(); },    [&] { w.set_config({}); },     [&] { w.save(); },
      [&] { w.hash(); },      [&] { w.load(moved.save()); }, [&] { w.energy(); },
      [&] { w.momentum(); },  [&] { w.quality(); },          [&] { w.profile(); },
      [&] { w.time(); },      [&] { w.steps(); },            [&] { w.islands(); },
      [&] { w.fat_boxes(); }, [&] { w.broad_boxes(); },      [&] { w.find("x"); },
      [&] { w.remove(p.a); }, [&] { w.ray_cast({}, {1, 0, 0}, 1); },
      [&] { Recorder(w, ""); },
  };
  for (const auto& question : questions) {
    try {
      question();
      ADD_FAILURE() << "question " << &question - questions << " was answered";
    } catch (const Error& e) { EXPECT_EQ(e.field, "world") << e.what(); }
  }
  p.w = World(steady());  // and is a world again
  EXPECT_TRUE(p.w.bodies().empty());
}

}
}
