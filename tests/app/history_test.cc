// The course of a run: back and on with the same bits, branches, undo, curves, bounded memory.
#include "history/history.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <random>

#include "main/plugins.h"
#include "unit/worlds.h"

namespace sudar_test {
namespace {

using namespace sudar::history;

// A pile that is swept by a paddle, one more ball with every tenth step; "up" lifts the first, "space" drops another.
struct Playground : Scenario {
  static constexpr double seconds = 1;
  int steps = 0;
  double width = 1;
  Body first;
  void params(Params& p) override { p("width", width, 0.5, 2, "m"); }
  void state(State& s) override { s("steps", steps), s("first", first); }
  void config(Config& c) override { c = sleepy(); }
  void build(World& w) override {
    w.add(Gravity{});
    sudar_test::add_floor(w);
    first = w.add(cube({0, 0.5, 0}));
    for (int i = 1; i < 5; ++i) w.add({.shape = box({Real(width), 1, 1}), .at = {0.1 * i, 0.5 + i, 0}, .mass = 1});
    const Body rod = w.add({.shape = box({2, Real(0.2), Real(0.2)}), .at = {4, 3, 0}, .mass = 1});
    w.join(Hinge{.b = rod, .at = {3, 3, 0}, .axis = {0, 0, 1}});
  }
  void drop(World& w) { w.add({.shape = sphere(0.3), .at = {0.3 * (steps % 7) - 1, 7, 0}, .mass = 1}); }
  void control(World& w, const Input& in) override {
    if (++steps % 25 == 0 || in.pressed("space")) drop(w);
    if (in.held("up") && w.alive(first)) w.push(first, {0, 30, 0}, w[first].center());
  }
};
const ScenarioEntry playground{abi_of_this_file(),
                               "playground",
                               "Tests/Playground",
                               "",
                               Playground::seconds,
                               1,
                               [](const ScenarioEntry&) -> Scenario* { return new Playground; },
                               [](Scenario* s) { delete s; }};

std::unique_ptr<Run> start_of(const ScenarioEntry& entry, const Settings& settings = {}) {
  return std::make_unique<Run>(entry, settings);
}
std::unique_ptr<Run> start(const Settings& settings = {}) { return start_of(playground, settings); }

const Ray down_on_first{{0, 20, 0}, {0, -1, 0}, {0, -1, 0}};
const Ray from_the_side{{-20, 2, 0}, {1, 0, 0}, {1, 0, 0}};

std::uint64_t state(const History& h) { return h.run().world().hash(); }

// What a hand does at these frames: keys, a drag with a twist, shots, additions, a removal, another setting.
void do_something(History& h, std::int64_t frame) {
  const Body first = h.run().world().bodies()[1];
  const auto tilted = [&](double dx) { return Ray{{0, 20, 0}, normalize(Vec3{Real(dx), -1, 0}), {0, -1, 0}}; };
  switch (frame) {
    case 12:
      return h.perform(Hold{{"up", "space"}, {0, 0, -1}});
    case 30:
      return h.perform(Hold{{}, {0, 0, -1}});
    case 41:
      return h.perform(Grab{h.run().world().bodies()[3], down_on_first});
    case 47:
      return h.perform(DragTo{tilted(0.1)}), h.perform(DragTo{tilted(0.15)}), h.perform(Twist{{0, 3, 0}});
    case 66:
      return h.perform(Release{});
    case 75:
      return h.perform(Shoot{from_the_side, 4});
    case 76:
      return h.perform(Insert{Solid::box, down_on_first, 4}), h.perform(Insert{Solid::sphere, from_the_side, 4});
    case 90:
      return h.perform(Remove{first});
    case 100: {
      Config c = h.run().world().config();
      c.substeps = 2;
      return h.perform(Configure{c});
    }
    default:
      return;
  }
}

constexpr std::int64_t last = 150;

// hashes[k]: of frame k, before what a hand does there.
std::vector<std::uint64_t> play(History& h) {
  std::vector<std::uint64_t> hashes;
  for (std::int64_t frame = 0; frame < last; ++frame) {
    hashes.push_back(state(h));
    do_something(h, frame);
    h.step();
  }
  hashes.push_back(state(h));
  return hashes;
}

TEST(History, GoesBackAndOnWithTheSameBits) {
  History h(start());
  const int main = h.here().branch;
  const std::vector<std::uint64_t> hashes = play(h);
  std::mt19937 random(1);
  for (int i = 0; i < 200; ++i) {
    const auto frame = std::int64_t(random() % (last + 1));
    ASSERT_TRUE(h.go({main, frame, 0}));
    ASSERT_EQ(h.here().frame, frame);
    ASSERT_EQ(state(h), hashes[std::size_t(frame)]) << "frame " << frame;
  }
  for (std::int64_t frame = last; frame-- > 0;) {  // backwards
    h.go({main, frame, 0});
    ASSERT_EQ(state(h), hashes[std::size_t(frame)]) << "frame " << frame;
  }
  h.go({main, 0});
  while (h.here().frame < last) h.step();  // what a hand did is done again
  EXPECT_EQ(state(h), hashes.back());
  EXPECT_EQ(h.branches().size(), 1u);
  for (int i = 0; i < 20; ++i) h.step();  // and beyond
  History other(start());
  play(other);
  for (int i = 0; i < 20; ++i) other.step();
  EXPECT_EQ(state(h), state(other));
}

TEST(History, EveryScenarioGoesBackAndOnWithTheSameBits) {
  const app::Plugins plugins("");
  for (const ScenarioEntry* entry : plugins.catalogue().all()) {
    History h(start_of(*entry));
    const int main = h.here().branch;
    const std::vector<KeyHelp> keys = h.run().session().scenario().keys();
    std::vector<std::uint64_t> hashes;
    for (int i = 0; i < 60; ++i) {
      if (i == 15 && !keys.empty()) h.perform(Hold{{"up"}, {0, 0, -1}});
      if (i == 33) h.perform(Shoot{{{-3, 2, 0}, {1, 0, 0}, {1, 0, 0}}, 2});
      hashes.push_back(state(h));
      h.step();
    }
    for (const std::int64_t frame : {7, 59, 31, 50, 0, 44}) {
      h.go({main, frame});
      ASSERT_EQ(state(h), hashes[std::size_t(frame)]) << entry->name << ", frame " << frame;
    }
    while (h.here().frame < 59) h.step();
    ASSERT_EQ(state(h), hashes.back()) << entry->name;
  }
}

TEST(History, ADeedInThePastBeginsABranch) {
  History h(start());
  const int main = h.here().branch;
  const std::vector<std::uint64_t> hashes = play(h);
  h.go({main, 80});
  h.perform(Shoot{from_the_side, 4});
  const int other = h.here().branch;
  EXPECT_NE(other, main);
  EXPECT_EQ(h.branches().size(), 2u);
  EXPECT_EQ(h.branch().parent, main);
  EXPECT_EQ(h.branch().from, 80);
  while (h.here().frame < 120) h.step();
  const std::uint64_t there = state(h);
  EXPECT_NE(there, hashes[120]);
  EXPECT_EQ(h.end(), 120);
  // The old future is there.
  ASSERT_TRUE(h.go({main, last}));
  EXPECT_EQ(state(h), hashes.back());
  ASSERT_TRUE(h.go({other, 120}));
  EXPECT_EQ(state(h), there);
  ASSERT_TRUE(h.go({other, 60, 0}));
  EXPECT_EQ(state(h), hashes[60]);
  // A branch that does the same beside the past is the same as a run that does it at once.
  History direct(start());
  for (std::int64_t frame = 0; frame < 120; ++frame) {
    if (frame <= 80) do_something(direct, frame);
    if (frame == 80) direct.perform(Shoot{from_the_side, 4});
    direct.step();
  }
  EXPECT_EQ(state(direct), there);
}

TEST(History, AGhostIsTheSameFrameOfAnotherBranch) {
  History h(start());
  const int main = h.here().branch;
  const std::vector<std::uint64_t> hashes = play(h);
  h.go({main, 80});
  h.perform(Shoot{from_the_side, 4});
  const auto whenever = Clock::time_point::max();
  for (const std::int64_t frame : {90, 110, 85, 100}) {
    while (h.here().frame < frame) h.step();
    h.go({h.here().branch, frame});
    const auto* ghost = h.ghost(main, whenever);
    ASSERT_NE(ghost, nullptr);
    // Behind what a hand did there, as the present one is.
    History same(start());
    for (std::int64_t k = 0; k < frame; ++k) do_something(same, k), same.step();
    do_something(same, frame);
    EXPECT_EQ(ghost->world().hash(), state(same)) << frame;
  }
  EXPECT_EQ(h.ghost(h.here().branch, whenever), nullptr) << "nothing is its own ghost";
  while (h.here().frame <= last) h.step();
  EXPECT_EQ(h.ghost(main, whenever), nullptr) << "beyond its end";
}

TEST(History, BranchesAreNamedAndRemoved) {
  History h(start());
  const int main = h.here().branch;
  play(h);
  h.go({main, 80});
  h.perform(Shoot{from_the_side, 4});
  const int second = h.here().branch;
  while (h.here().frame < 100) h.step();
  h.go({second, 90});
  h.perform(Shoot{from_the_side, 2});
  const int third = h.here().branch;
  while (h.here().frame < 110) h.step();
  const std::uint64_t there = state(h);
  h.rename(third, "two balls");
  EXPECT_EQ(h.branch().name, "two balls");
  EXPECT_THROW(h.remove(third), Error);
  const std::size_t before = h.bytes();
  h.remove(second);
  h.remove(main);  // what they led to stays
  EXPECT_EQ(h.branches().size(), 1u);
  EXPECT_LT(h.bytes(), before);
  h.go({third, 5}), h.go({third, 110});
  EXPECT_EQ(state(h), there);
  for (int i = 0; i < 30; ++i) {  // their number is bounded
    h.go({h.here().branch, 20 + i});
    h.perform(Shoot{from_the_side, 4});
    for (int k = 0; k < 10; ++k) h.step();
  }
  EXPECT_LE(h.branches().size(), 12u);
  EXPECT_TRUE(h.go({third, 110}));
  EXPECT_EQ(state(h), there) << "a named one stays";
}

TEST(History, UndoAndRedo) {
  History h(start());
  const std::vector<std::uint64_t> hashes = play(h);
  EXPECT_FALSE(h.redone());
  // The edits backwards: the setting, the removal, the two solids, the shot, the drag.
  const std::int64_t frames[] = {100, 90, 76, 76, 75, 41};
  std::vector<std::uint64_t> undone;
  for (const std::int64_t frame : frames) {
    const auto place = h.undone();
    ASSERT_TRUE(place && place->frame == frame) << frame;
    h.go(*place);
    undone.push_back(state(h));
    if (frame != 76) { EXPECT_EQ(state(h), hashes[std::size_t(frame)]); }
  }
  EXPECT_FALSE(h.undone());
  for (std::size_t i = std::size(frames) - 1; i-- > 0;) {
    h.go(*h.redone());
    h.go(*h.redone());
    h.go(*h.undone());
    EXPECT_EQ(state(h), undone[i]) << frames[i];
  }
  // What was undone is not done again: the run goes on without it.
  const Body first = start()->world().bodies()[1];
  const auto there = [&] {
    const std::vector<Body> all = h.run().world().bodies();
    return std::any_of(all.begin(), all.end(),
                       [&](const Body& b) { return b.index == first.index && b.generation == first.generation; });
  };
  EXPECT_FALSE(there());
  h.go(*h.undone());  // the removal
  h.step();
  EXPECT_TRUE(there());
  EXPECT_EQ(h.branches().size(), 2u);
  EXPECT_FALSE(h.redone());
}

TEST(History, RestartDoesNotRepeatTheHand) {
  History h(start());
  const int main = h.here().branch;
  const std::uint64_t fresh = state(h);
  for (int i = 0; i < 20; ++i) h.step();
  h.restart(h.run().settings());
  EXPECT_EQ(state(h), fresh);
  EXPECT_EQ(h.here().branch, main) << "nothing was done: it is the same run";
  play(h);
  EXPECT_EQ(h.branches().size(), 2u);
  Settings wider = h.run().settings();  // a setting was changed: another beginning
  wider.set = {{"width", 2}};
  h.restart(wider);
  EXPECT_EQ(h.branches().size(), 3u);
  EXPECT_EQ(h.begin(), 0);
  EXPECT_EQ(state(h), state(History(start(wider))));
  h.step();
  h.perform(Shoot{from_the_side, 4});
  for (int i = 0; i < 5; ++i) h.step();
  h.restart(h.run().settings());
  const std::size_t bodies = h.run().world().bodies().size();
  for (int i = 0; i < 6; ++i) h.step();
  EXPECT_EQ(h.run().world().bodies().size(), bodies) << "no ball was shot again";
  EXPECT_EQ(h.branches().size(), 4u);
}

TEST(History, KeysOfThePastAreNotHeldForEver) {
  History h(start());
  const int main = h.here().branch;
  for (int i = 0; i < 10; ++i) h.step();
  h.perform(Hold{{"up"}, {0, 0, -1}});
  h.perform(Grab{h.run().world().bodies()[2], down_on_first});
  for (int i = 0; i < 20; ++i) h.step();
  EXPECT_TRUE(h.run().grabs());
  h.go({main, 20});
  h.perform(Hold{{}, {0, 0, -1}});  // the hand lets go while the past is shown
  h.perform(Release{});
  EXPECT_EQ(h.branches().size(), 1u) << "which changes nothing of it";
  while (h.here().frame < 30) h.step();
  EXPECT_TRUE(h.run().session().input.held("up") && h.run().grabs());
  h.step();
  EXPECT_FALSE(h.run().session().input.held("up") || h.run().grabs());
  EXPECT_EQ(h.branches().size(), 1u);
}

TEST(History, AnErrorChangesNothing) {
  History h(start());
  for (int i = 0; i < 10; ++i) h.step();
  h.go({h.here().branch, 5});
  const std::uint64_t before = state(h);
  Config bad = h.run().world().config();
  bad.dt = -1;
  EXPECT_THROW(h.perform(Configure{bad}), Error);
  EXPECT_EQ(state(h), before);
  EXPECT_EQ(h.branches().size(), 1u);
  EXPECT_FALSE(h.undone());
}

TEST(History, MemoryIsBounded) {
  constexpr std::size_t most = 3'000'000;
  History h(start(), {.bytes = most});
  const int main = h.here().branch;
  std::vector<std::uint64_t> hashes;
  for (int i = 0; i < 3000; ++i) {
    hashes.push_back(state(h));
    h.step();
    ASSERT_LT(h.bytes(), 2 * most);
  }
  for (const std::int64_t frame : {0, 1, 2999, 1234, 2345, 77, 1500, 2990}) {
    h.go({main, frame});
    EXPECT_EQ(state(h), hashes[std::size_t(frame)]) << frame;
  }
  EXPECT_LT(h.bytes(), 2 * most);
}

// Hours of dragging: the beginning goes, and what goes out from there; the rest is as it was.
TEST(History, ForgetsTheBeginningOfTooManyDeeds) {
  History h(start(), {.deeds = 60});
  std::vector<std::uint64_t> hashes;
  for (int i = 0; i < 400; ++i) {
    hashes.push_back(state(h));
    if (i % 2 == 0) h.perform(Shoot{{{-20, 3 + 0.1 * (i % 9), 40.0 * i}, {1, 0, 0}, {1, 0, 0}}, 1});
    h.step();
    if (i == 20 || i == 300) {  // a branch from early on, and one from later
      const int here = h.here().branch;
      const std::int64_t frame = h.here().frame;
      h.go({here, frame - 8});
      h.perform(Shoot{from_the_side, 2});
      h.step();
      ASSERT_TRUE(h.go({here, frame}));
    }
  }
  EXPECT_GT(h.begin(), 100);
  const int here = h.here().branch;
  for (std::int64_t frame = 399; frame >= h.begin(); frame -= 7) {
    h.go({here, frame, 0});
    ASSERT_EQ(state(h), hashes[std::size_t(frame)]) << frame;
  }
  h.go({here, 0});
  EXPECT_EQ(h.here().frame, h.begin());
  const auto curve = h.curve(here, 1);
  ASSERT_FALSE(curve.empty());
  EXPECT_EQ(curve.front().frame, h.begin());
  for (const auto& b : h.branches()) {
    EXPECT_GE(b.from, h.begin());
    EXPECT_TRUE(h.go({b.number, b.end}));
  }
}

// Whatever is done in whatever order: a place that was seen before looks as it did.
TEST(History, TheSamePlaceIsAlwaysTheSame) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    std::mt19937 random(seed);
    const auto one_of = [&](std::size_t n) { return std::size_t(random() % n); };
    History h(start(), {.bytes = 400'000});
    std::map<std::array<std::int64_t, 3>, std::uint64_t> seen;
    for (int i = 0; i < 400; ++i) {
      const std::vector<History::Branch> all = h.branches();
      const History::Branch& b = all[one_of(all.size())];
      switch (one_of(9)) {
        case 0:
          h.perform(Shoot{from_the_side, 1 + double(one_of(4))});
          break;
        case 1:
          h.perform(one_of(2) == 0 ? Deed(Hold{{"up"}, {0, 0, -1}}) : Deed(Hold{{}, {0, 0, -1}}));
          break;
        case 2: {
          const std::vector<Body> bodies = h.run().world().bodies();
          h.perform(one_of(2) == 0 ? Deed(Grab{bodies[one_of(bodies.size())], down_on_first}) : Deed(Release{}));
          break;
        }
        case 3:
          h.go({b.number, b.from + std::int64_t(one_of(std::size_t(b.end - b.from) + 1))});
          break;
        case 4:
          if (const auto place = one_of(2) == 0 ? h.undone() : h.redone()) h.go(*place);
          break;
        case 5:
          if (one_of(8) == 0) h.restart(h.run().settings());
          if (one_of(4) == 0 && b.number != h.here().branch) h.remove(b.number);
          h.ghost(h.branches()[one_of(h.branches().size())].number, Clock::time_point::max());
          break;
        default:
          for (std::size_t n = one_of(12); n-- > 0;) h.step();
      }
      const Place here = h.here();
      const auto [known, fresh] = seen.try_emplace({here.branch, here.frame, std::int64_t(here.deeds)}, state(h));
      ASSERT_EQ(known->second, state(h)) << "seed " << seed << ", action " << i;
    }
    while (h.fill(Clock::time_point::max())) {}
  }
}

TEST(History, AWayBackCanBeInterrupted) {
  History h(start());
  const int main = h.here().branch;
  for (int i = 0; i < 100; ++i) h.step();
  int parts = 1;
  while (!h.go({main, 9}, Clock::time_point::min())) ++parts;
  EXPECT_EQ(parts, 9);  // a keyframe at 0, the rest step by step: no more is done than there is time for
}

TEST(History, CurvesOfThePastAreThoseOfThePresent) {
  History h(start());
  const Quantity height{.of = Quantity::Of::body, .which = 1, .a = h.run().world().bodies()[2]};
  const int at_once = h.watch(height), main = h.here().branch;
  while (h.fill(Clock::now())) {}  // the beginning is past already
  std::vector<double> heights;
  for (std::int64_t frame = 0; frame < last; ++frame) {
    heights.push_back(value(h.run().world(), height));
    do_something(h, frame);
    h.step();
  }
  h.go({main, 80});
  h.perform(Shoot{from_the_side, 4});
  while (h.here().frame < 100) h.step();
  const int branch = h.here().branch;
  // The same under another number, asked for only now.
  const auto before = h.curve(branch, at_once), of_main = h.curve(main, at_once);
  h.unwatch(at_once);
  const int later = h.watch(height);
  EXPECT_TRUE(h.curve(branch, later).empty());
  while (h.fill(Clock::now())) {}
  const auto same = [](const std::vector<History::Sample>& a, const std::vector<History::Sample>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_EQ(a[i].frame, b[i].frame);
      EXPECT_EQ(a[i].time, b[i].time);
      EXPECT_EQ(a[i].value.low, b[i].value.low) << a[i].frame;
    }
  };
  same(h.curve(branch, later), before);
  same(h.curve(main, later), of_main);
  ASSERT_EQ(of_main.size(), std::size_t(last) + 1);
  for (std::size_t i = 0; i < heights.size(); ++i) EXPECT_EQ(of_main[i].value.low, heights[i]);
  EXPECT_EQ(before.size(), 101u);
  for (std::size_t i = 0; i <= 80; ++i) EXPECT_EQ(before[i].value.low, heights[i]);
}

TEST(History, MarksTellWhatHappened) {
  History h(start());
  play(h);
  std::uint8_t all = 0;
  std::vector<std::int64_t> edits;
  for (const auto& m : h.marks()) {
    all |= m.mark.bits;
    if (m.mark.bits & Mark::edit) edits.push_back(m.frame);
  }
  EXPECT_EQ(edits, (std::vector<std::int64_t>{41, 75, 76, 90, 100}));
  EXPECT_TRUE(all & Mark::touch);
  EXPECT_TRUE(all & Mark::hit);
}

TEST(Thinned, KeepsExtremes) {
  Thinned<Span> t(5, 64);
  for (int i = 0; i < 1000; ++i) {
    const double v = i == 777 ? 50 : i % 10;
    t.append({v, v});
  }
  EXPECT_EQ(t.first(), 5);
  EXPECT_EQ(t.end(), 1005);
  EXPECT_LE(t.size(), 64u);
  double high = 0;
  for (std::size_t i = 0; i < t.size(); ++i) {
    high = std::max(high, t[i].high);
    EXPECT_EQ(t.frame(i), 5 + std::int64_t(i) * t.stride());
    EXPECT_EQ(t[i].high == 50, t.frame(i) <= 782 && 782 < t.frame(i) + t.stride());
  }
  EXPECT_EQ(high, 50);
}

}
}
