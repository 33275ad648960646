// Every scenario passes its checks, awake and asleep; goes on with the same bits after save and load; and its recording
// replays. One test each, so that CTest runs them side by side.
#include "scenarios/catalogue.h"

#include <gtest/gtest.h>

#include <sudar/record.h>

#include <algorithm>
#include <functional>

using namespace sudar;

namespace {

const Settings awake{.config = {{"sleep", "false"}}};
const Settings soft{.config = {{"solver", "soft_step"}}};

// Every check has a verdict, and it is good.
void expect_passed(const Check& check) {
  EXPECT_FALSE(check.entries().empty());
  for (const Check::Entry& e : check.entries()) {
    EXPECT_TRUE(e.pass.has_value()) << "not reached: " << text(e);
    EXPECT_TRUE(e.pass.value_or(true)) << text(e);
  }
}

void expect_passes(const ScenarioEntry& entry, const Settings& settings) {
  Session session(entry, settings);
  expect_passed(run(session));
}

// What is restored at step 100, in another instance of the scenario, has the same bits at step 200.
void expect_restores(const ScenarioEntry& entry, const Settings& settings) {
  Session original(entry, settings);
  for (int i = 0; i < 100; ++i) original.step();
  Session restored = Session::load(scenarios(), original.save());
  EXPECT_EQ(restored.world().hash(), original.world().hash());
  for (int i = 0; i < 100; ++i) original.step(), restored.step();
  EXPECT_EQ(restored.world().hash(), original.world().hash());
  EXPECT_EQ(restored.save(), original.save());
}

void expect_replays(const ScenarioEntry& entry) {
  Session session(entry);
  Bytes recording;
  {
    Recorder recorder(session.world(), entry.name);
    for (int i = 0; i < 200; ++i) session.step(), recorder.after_step();
    recording = recorder.bytes();
  }
  Replay replay(recording);
  while (!replay.done()) {
    const auto difference = replay.step();
    ASSERT_FALSE(difference) << "step " << difference->step << ", stage " << difference->stage << ", "
                             << difference->field;
  }
  EXPECT_EQ(replay.world().hash(), session.world().hash());
}

// Nothing in the world speaks of a body that is no more.
void expect_only_living(const World& w) {
  for (const Contact& c : w.contacts()) EXPECT_TRUE(w.alive(c.a) && w.alive(c.b));
  for (const Joint j : w.joints()) {
    std::visit(
        [&](const auto& d) {
          for (const Body body : {d.a, d.b}) EXPECT_TRUE(body.null() || w.alive(body));
        },
        w[j].definition());
  }
}

// A floor and a ball above it: where the ball is after each of 50 steps.
std::vector<Pos> bounces(World& w) {
  const Body floor = w.add({.shape = box({20, 2, 20}), .at = {0, -1, 0}, .motion = Motion::fixed});
  const Body ball = w.add({.shape = sphere(1), .at = {0, Real(1.01), 0}, .velocity = {1, -3, 0}});
  std::vector<Pos> way;
  bool met = false;
  for (int i = 0; i < 50; ++i) {
    w.step(1.0 / 60 / double(w.config().time_factor));
    met |= w.touching(floor, ball);
    way.push_back(w[ball].center());
  }
  EXPECT_TRUE(met);
  return way;
}

// Whatever is removed by hand, the world goes on: who is left stays alive and sane, and when all are gone, the world is
// as good as a new one.
void expect_goes_on(const ScenarioEntry& entry) {
  Session session(entry);
  World& w = session.world();
  const auto step = [&] {
    for (int i = 0; i < 50; ++i) {
      session.step();
      EXPECT_TRUE(w.events().quarantined.empty());
      expect_only_living(w);
    }
  };
  step();
  const std::vector<Body> bodies = w.bodies();
  std::vector<Body> left;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (i % 2 == 0) w.remove(bodies[i]);
    else left.push_back(bodies[i]);
  }
  step();
  for (const Body b : left) EXPECT_TRUE(w.alive(b));
  World restored;
  restored.load(w.save());
  EXPECT_EQ(restored.hash(), w.hash());

  for (const Body b : w.bodies()) w.remove(b);
  EXPECT_TRUE(w.bodies().empty());
  EXPECT_TRUE(w.joints().empty());
  EXPECT_TRUE(w.contacts().empty());
  EXPECT_TRUE(w.sensors().empty());
  World fresh(w.config());
  for (const ForceId f : w.forces()) fresh.add(w[f]);
  EXPECT_EQ(bounces(w), bounces(fresh));
}

// A slider may be drawn to either end of its range.
void expect_runs_at_the_ends(const ScenarioEntry& entry) {
  const Session usual(entry);
  for (const Params::Entry& p : usual.params()) {
    for (const double value : {p.low, p.high}) {
      SCOPED_TRACE(p.name + " = " + std::to_string(value));
      Session session(entry, {.set = {{p.name, value}}});
      for (int i = 0; i < 50; ++i) {
        session.step();
        EXPECT_TRUE(session.world().events().quarantined.empty());
      }
      session.finish();
      EXPECT_EQ(session.abandoned(), "");
    }
  }
}

class Run : public testing::Test {
 public:
  explicit Run(std::function<void()> body) : body_(std::move(body)) {}
  void TestBody() override { body_(); }

 private:
  std::function<void()> body_;
};

void add_test(const ScenarioEntry& entry, const char* what, std::function<void()> body) {
  testing::RegisterTest(entry.name, what, nullptr, nullptr, __FILE__, __LINE__,
                        [body]() -> testing::Test* { return new Run(body); });
}

// A key that the scenario names has an effect in the very next step.
void expect_answers(const ScenarioEntry& entry) {
  Session start(entry);
  for (int i = 0; i < 100; ++i) start.step();
  const Bytes saved = start.save();
  const auto after_key = [&](const char* key) {
    Session session = Session::load(scenarios(), saved);
    if (key != nullptr) session.input.set({key});
    session.step();
    return session.world().hash();
  };
  for (const KeyHelp& k : start.scenario().keys()) EXPECT_NE(after_key(k.key), after_key(nullptr)) << k.key;
}

}

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  for (const ScenarioEntry* entry : scenarios().all()) {
    add_test(*entry, "passes", [entry] { expect_passes(*entry, {}); });
    add_test(*entry, "passes_without_sleep", [entry] { expect_passes(*entry, awake); });
    add_test(*entry, "passes_with_soft_step", [entry] { expect_passes(*entry, soft); });
    add_test(*entry, "restores", [entry] { expect_restores(*entry, {}), expect_restores(*entry, awake), expect_restores(*entry, soft); });
    add_test(*entry, "replays", [entry] { expect_replays(*entry); });
    add_test(*entry, "goes_on", [entry] { expect_goes_on(*entry); });
    add_test(*entry, "ends_of_ranges", [entry] { expect_runs_at_the_ends(*entry); });
    add_test(*entry, "answers_keys", [entry] { expect_answers(*entry); });
  }
  for (const Variant& v : variants()) {
    const ScenarioEntry& entry = scenarios().find(v.scenario);
    add_test(entry, v.what, [&entry, &v] { expect_passes(entry, v.settings); });
  }
  return RUN_ALL_TESTS();
}
