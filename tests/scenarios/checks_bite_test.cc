// Checks that cannot fail are worth nothing: every scenario runs with some of its physics taken away, and every check
// of it must fail in one of these runs.
#include "scenarios/catalogue.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>

using namespace sudar;

namespace {

// A way to take physics away.
struct Removal {
  const char* name;
  Settings settings;
  std::function<void(World&)> change = [](World&) {};
};

void remove_joints(World& w) {
  for (Joint j : w.joints()) w.remove(j);
}
void remove_gravity(World& w) {
  for (ForceId f : w.forces()) {
    if (std::holds_alternative<Gravity>(w[f]) || std::holds_alternative<NBody>(w[f])) w.remove(f);
  }
}
void add_air(World& w) { w.add(Drag{.linear = 0.1, .angular = 0.1}); }
void slope(World& w) { w.add(Gravity{{0.05, 0, 0}}); }  // half a degree: more than nothing resists

// What works in every scene: no impulses in contacts and joints, or too few; no joints, no gravity, air where there is
// none; and every parameter that begins with one of these words is set as low as it goes.
std::vector<Removal> removals(const std::vector<Params::Entry>& params) {
  std::vector<Removal> all = {
      {"no passes", {.config = {{"impulse_2007.collision_passes", "0"}, {"impulse_2007.contact_passes", "0"},
                                {"impulse_2007.exact_joints", "false"}}}},
      {"one pass", {.config = {{"impulse_2007.collision_passes", "1"}, {"impulse_2007.contact_passes", "1"},
                               {"impulse_2007.exact_joints", "false"}}}},
      {"no joints", {}, remove_joints},
      {"no gravity", {}, remove_gravity},
      {"air", {}, add_air},
  };
  for (const char* word : {"friction", "restitution", "speed", "spin", "steering", "force"}) {
    Settings lowest;
    for (const Params::Entry& p : params) {
      if (p.name.starts_with(word)) lowest.set[p.name] = p.low;
    }
    if (!lowest.set.empty()) all.push_back({word, lowest, slope});
  }
  return all;
}

void expect_bites(const ScenarioEntry& entry, const Settings& settings) {
  Session whole(entry, settings);
  std::set<std::string> unbroken;  // checks that have not failed yet
  for (const Check::Entry& e : run(whole).entries()) unbroken.insert(e.name);
  EXPECT_FALSE(unbroken.empty());
  for (const Removal& removal : removals(whole.params())) {
    Settings poorer = settings;
    poorer.config = removal.settings.config;
    for (const auto& [name, value] : removal.settings.set) poorer.set[name] = value;
    Session session(entry, poorer);
    removal.change(session.world());
    for (const Check::Entry& e : run(session).entries()) {
      if (e.pass == false) unbroken.erase(e.name);
    }
    if (unbroken.empty()) return;
  }
  for (const std::string& name : unbroken) ADD_FAILURE() << "never fails: " << name;
}

class Bite : public testing::Test {
 public:
  Bite(const ScenarioEntry& entry, const Settings& settings) : entry_(entry), settings_(settings) {}
  void TestBody() override { expect_bites(entry_, settings_); }

 private:
  const ScenarioEntry& entry_;
  Settings settings_;
};

void add_test(const ScenarioEntry& entry, const char* what, const Settings& settings) {
  testing::RegisterTest(entry.name, what, nullptr, nullptr, __FILE__, __LINE__,
                        [&entry, settings]() -> testing::Test* { return new Bite(entry, settings); });
}

}

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  for (const ScenarioEntry* entry : scenarios().all()) add_test(*entry, "checks_bite", {});
  for (const Variant& v : variants()) add_test(scenarios().find(v.scenario), v.what, v.settings);
  return RUN_ALL_TESTS();
}
