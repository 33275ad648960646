// Who counts touches by begun − ended counted wrong: a body that was placed elsewhere, and a pair that a new joint
// keeps from touching, stopped touching without a word; and a body placed where it was began to touch a second time.
#include <map>

#include "unit/worlds.h"

namespace sudar_test {
namespace {

struct Counter {
  World& w;
  std::map<std::pair<Body, Body>, int> touches;
  void step() {
    const Events& e = w.step();
    for (const Events::Touch& t : e.begun) ++touches[{t.a, t.b}];
    for (const Events::Touch& t : e.ended) --touches[{t.a, t.b}];
    for (const auto& [pair, count] : touches) {
      EXPECT_TRUE(count == 0 || count == 1);
      EXPECT_EQ(count == 1, w.touching(pair.first, pair.second));
    }
  }
  int now() const {
    int sum = 0;
    for (const auto& [pair, count] : touches) sum += count;
    return sum;
  }
};

TEST(TouchEvents, OfPlacedBodies) {
  World w(steady());
  w.add(Gravity{});
  add_floor(w);
  const Body b = w.add(cube({0, 0.5, 0}));
  Counter counter{w, {}};
  counter.step();
  EXPECT_EQ(counter.now(), 1);
  w.place(b, {{3, 0.5, 0}, {}});  // still on the floor
  counter.step();
  EXPECT_EQ(counter.now(), 1);
  w.place(b, {{3, 5, 0}, {}});
  counter.step();
  EXPECT_EQ(counter.now(), 0);
}

TEST(TouchEvents, OfJoinedBodies) {
  World w(steady());
  const Body a = w.add(cube({0, 0, 0})), b = w.add(cube({0.999, 0, 0}));
  Counter counter{w, {}};
  counter.step();
  EXPECT_EQ(counter.now(), 1);
  const Joint j = w.join(Fixed{.a = a, .b = b, .at = {0.5, 0, 0}});
  counter.step();
  EXPECT_EQ(counter.now(), 0);
  w.remove(j);
  counter.step();
  EXPECT_EQ(counter.now(), 1);
}

// Saved between the change and the step that reports it: the same events.
TEST(TouchEvents, SurviveSaving) {
  World w(steady());
  w.add(Gravity{});
  add_floor(w);
  const Body b = w.add(cube({0, 0.5, 0}));
  w.step();
  w.place(b, {{3, 5, 0}, {}});
  World restored;
  restored.load(w.save());
  EXPECT_EQ(w.step().ended.size(), 1u);
  EXPECT_EQ(restored.step().ended.size(), 1u);
  EXPECT_EQ(restored.hash(), w.hash());
}

}
}
