// A scenario being run: what the command line, the window, the tests and the benchmarks share.
//   Session s(entry, {.set = {{"ball", 0}}});
//   while (s.world().time() < s.seconds()) s.step();
//   s.finish().passed();
#pragma once

#include <sudar/scenario.h>

#include <functional>

namespace sudar::inline SUDAR_PRECISION {

// A new instance; throws Error where the plugin makes none.
using ScenarioPointer = std::unique_ptr<Scenario, void (*)(Scenario*)>;
ScenarioPointer make_scenario(const ScenarioEntry&);

// Scenarios by name. Holds pointers: the plugins that own the entries outlive it.
class Catalogue {
 public:
  void add(const ScenarioEntry*);                             // throws Error: holes, a foreign ABI, a name that is taken
  const std::vector<const ScenarioEntry*>& all() const { return entries_; }  // by place
  const ScenarioEntry& find(std::string_view name) const;     // throws Error naming one that is near

  // Who may know scenes that are not listed, files say: asked before names are compared; null: knows none of that name.
  using Opener = std::function<const ScenarioEntry*(std::string_view name)>;
  void open_with(Opener opener) { opener_ = std::move(opener); }

 private:
  std::vector<const ScenarioEntry*> entries_;
  Opener opener_;
};

// Sets one described field by its path, e.g. "impulse_2007.contact_passes" to "20". Throws Error naming the field, the
// value and what was expected.
void set_field(Config&, std::string_view path, std::string_view value);
// All described fields as set_field() takes them: path and value.
std::vector<std::pair<std::string, std::string>> fields_of(const Config&);

struct Settings {
  std::map<std::string, double> set{};                        // parameters
  std::vector<std::pair<std::string, std::string>> config{};  // by path, in order, after the scenario's own config()
  std::optional<double> seconds{};                            // finite, not negative; else the scenario's own
};

// Keys by script: "0:up+left 12.5:none" — from 0 s up and left, from 12.5 s nothing.
class KeyScript {
 public:
  KeyScript() = default;
  explicit KeyScript(std::string_view text);                  // throws Error
  void apply(double time, Input&);                            // sets the keys held at `time`
  void skip(double time);                                     // leaves out what is due by then: it was applied before

 private:
  std::vector<std::pair<double, std::vector<std::string>>> entries_;
  std::size_t next_ = 0;
};

class Session {
 public:
  explicit Session(const ScenarioEntry&, const Settings& = {});
  // Goes on where save() was called, in a new instance of the scenario. `workers`: as Config's; those of the run that was
  // saved were its machine's.
  static Session load(const Catalogue&, std::span<const std::byte>, std::int32_t workers = 1);
  static bool begins(std::span<const std::byte> file);        // as what save() returns does

  void step();                                                // control, World::step, observe
  const Check& finish();                                      // runs check(); no verdict on what was not reached
  Bytes save() const;

  const ScenarioEntry& entry() const { return *entry_; }
  Scenario& scenario() { return *scenario_; }
  const Scenario& scenario() const { return *scenario_; }
  World& world() { return world_; }
  const World& world() const { return world_; }
  const Check& check() const { return check_; }
  const std::vector<Params::Entry>& params() const { return params_; }
  // Why the scenario neither acts nor watches any more, while the world goes on: it looks at something that was removed
  // by hand. Its verdict is bad then. Empty: it does.
  const std::string& abandoned() const { return abandoned_; }
  double seconds() const { return seconds_; }                 // simulated
  double dt() const;                                          // simulated seconds a step
  bool done() const;                                          // reached seconds()
  Input input;

 private:
  Session() = default;
  template <class F>
  void unless_abandoned(F);
  const ScenarioEntry* entry_ = nullptr;
  ScenarioPointer scenario_{nullptr, nullptr};
  std::vector<Params::Entry> params_;
  World world_;
  Check check_;
  double seconds_ = 0;
  std::string abandoned_;
};

}
