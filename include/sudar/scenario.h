// A scenario: a scene with parameters that is also a test. One file in scenarios/ is one scenario is one plugin:
//   struct Drop : Scenario {
//     static constexpr double seconds = 3;                       // what its checks need
//     static constexpr const char* about = "a ball that bounces";
//     Real height = 4;  Body ball;
//     void params(Params& p) override { p("height", height, 1, 10, "m"); }
//     void state(State& s) override { s("ball", ball); }
//     void build(World& w) override { ball = w.add({.shape = sphere(0.5), .at = {0, height, 0}}); }
//     void check(const World& w, Check& c) override { c.below("height", w[ball].pose().p.y, 0.51, "m"); }
//   };
//   SUDAR_SCENARIO(Drop, "Bouncing/Drop")
// Its name is the file's name, the string its place in the browser. Use sudar::sin, cos, … and never libm in here, so
// that a scenario has the same bits on every machine.
#pragma once

#include <sudar/layout.h>
#include <sudar/version.h>
#include <sudar/world.h>

#include <cstring>
#include <map>

namespace sudar::inline SUDAR_PRECISION {

// The parameters of a scenario: sliders, --set, studies. Lists them, or sets them, by visiting them.
class Params {
 public:
  enum class Kind { integer, real, boolean };
  struct Entry {
    std::string name;
    Kind kind;
    double value, low, high;
    std::string about;  // unit or meaning
  };
  Params() = default;  // lists
  explicit Params(const std::map<std::string, double>& values) : values_(values) {}  // sets; checks range and kind

  void operator()(std::string_view name, int& value, int low, int high, std::string_view about = "");
  void operator()(std::string_view name, float& value, double low, double high, std::string_view about = "");
  void operator()(std::string_view name, double& value, double low, double high, std::string_view about = "");
  void operator()(std::string_view name, bool& value, std::string_view about = "");

  const std::vector<Entry>& entries() const { return entries_; }
  void require_all_known() const;  // throws Error naming a given value that no parameter took, and what there is

 private:
  double visit(std::string_view name, Kind kind, double value, double low, double high, std::string_view about);
  std::map<std::string, double> values_;
  std::vector<Entry> entries_;
};

// What a scenario remembers between steps besides its parameters: saved, hashed, rewound.
class State {
 public:
  State() = default;                                          // writes
  explicit State(Bytes bytes) : bytes_(std::move(bytes)), reading_(true) {}  // reads

  template <class T>
    requires std::is_trivially_copyable_v<T>
  void operator()(std::string_view name, T& value) { raw(name, &value, sizeof value); }
  template <class T>
    requires std::is_trivially_copyable_v<T>
  void operator()(std::string_view name, std::vector<T>& values) {
    std::uint64_t n = values.size();
    raw(name, &n, sizeof n);
    if (reading_ && n > (bytes_.size() - position_) / sizeof(T)) missing(name);
    values.resize(n);
    raw(name, values.data(), n * sizeof(T));
  }
  const Bytes& bytes() const { return bytes_; }
  bool all_read() const { return position_ == bytes_.size(); }

 private:
  void raw(std::string_view name, void* data, std::size_t size);
  [[noreturn]] static void missing(std::string_view name);
  Bytes bytes_;
  std::size_t position_ = 0;
  bool reading_ = false;
};

// The keys that the user holds, and those that went down since the last step: "up", "down", "left", "right", "space",
// "a"…; and where the camera looks.
class Input {
 public:
  bool held(std::string_view key) const;
  const std::vector<std::string>& all_held() const { return held_; }
  bool pressed(std::string_view key) const;
  void set(std::vector<std::string> held);  // what is held from now on; what was not held before counts as pressed
  void clear_pressed() { pressed_.clear(); }
  static constexpr const char* named_keys = "up, down, left, right, space, enter, shift";
  static bool is_key(std::string_view);  // one of these, or "a" to "z", "0" to "9"
  Vec3 view{0, 0, -1};

  Bytes save() const;
  void load(const Bytes&);

 private:
  std::vector<std::string> held_, pressed_;
};

// The expectations of a scenario, as numbers. In observe() a check runs after every step and keeps its worst value; at()
// runs it once; in check() it runs at the end. One whose time was not reached has no verdict.
//   c.below("sink", sink, 0.1, "m");   c.at(10).below("drift at 10 s", drift, 0.1, "m");   c.from(5).near(…);
class Check {
 public:
  struct Entry {
    std::string name, op, unit;        // op: "<", ">", "=" (within tolerance), "holds"
    double value = 0, limit = 0, tolerance = 0;
    double at = 0;                     // simulated time of the value kept, s
    std::optional<bool> pass;          // none: its time was not reached
  };
  class When;

  void below(std::string_view name, double value, double limit, std::string_view unit = "");
  void above(std::string_view name, double value, double limit, std::string_view unit = "");
  void near(std::string_view name, double value, double expected, double tolerance, std::string_view unit = "");
  void that(std::string_view name, bool holds);

  When at(double time);                // only after the step that reaches `time`
  When from(double time);              // only at that time and later
  When between(double from, double to);

  const std::vector<Entry>& entries() const { return entries_; }
  bool passed() const;                 // every verdict there is, is good, and there is at least one

  // For whoever runs a scenario: the time of the coming visits, the length of the step that led there, and whether
  // visits only make their names known (check() of a run that was cut short).
  void visit(double time, double dt, bool active);
  Bytes save() const;
  void load(const Bytes&);

 private:
  void note(std::string_view name, const char* op, double value, double limit, double tolerance, std::string_view unit,
            bool active);
  std::vector<Entry> entries_;
  double time_ = 0, dt_ = 0;
  bool active_ = true;
};

class Check::When {
 public:
  When(Check& check, bool active) : check_(check), active_(active) {}
  void below(std::string_view name, double value, double limit, std::string_view unit = "") {
    check_.note(name, "<", value, limit, 0, unit, active_);
  }
  void above(std::string_view name, double value, double limit, std::string_view unit = "") {
    check_.note(name, ">", value, limit, 0, unit, active_);
  }
  void near(std::string_view name, double value, double expected, double tolerance, std::string_view unit = "") {
    check_.note(name, "=", value, expected, tolerance, unit, active_);
  }
  void that(std::string_view name, bool holds) { check_.note(name, "holds", holds ? 1 : 0, 1, 0, "", active_); }

 private:
  Check& check_;
  bool active_;
};

// Where a picture of the scenario is best taken from. A zero-sized one lets the viewer frame the scene.
struct Camera {
  Pos eye, target;
  Real field_of_view = Real(0.7);  // vertical, rad
};

struct KeyHelp {
  const char *key, *does;
};

class Scenario {
 public:
  static constexpr double seconds = 10;                  // what its checks need, simulated
  static constexpr double picture = 2;                   // s: the moment at which a picture tells what it is about
  static constexpr const char* about = "";
  virtual ~Scenario() = default;
  virtual void params(Params&) {}
  virtual void state(State&) {}
  virtual void config(Config&) {}
  virtual void build(World&) = 0;
  virtual void control(World&, const Input&) {}          // before every step
  virtual void observe(const World&, Check&) {}          // after every step
  virtual void check(const World&, Check&) {}            // at the end
  virtual std::optional<Camera> camera() const { return {}; }
  virtual std::vector<KeyHelp> keys() const { return {}; }
};

// What a plugin offers. `abi` comes first and never moves: a loader compares it before it trusts the rest.
struct ScenarioEntry {
  const char* abi;
  const char* name;   // of the file
  const char* place;  // "Group/Title" in the browser
  const char* about;  // one line
  double seconds;
  double picture;     // s
  Scenario* (*create)(const ScenarioEntry&);  // the entry itself: what is made may depend on what it belongs to
  void (*destroy)(Scenario*);
};

// Version, precision, compiler, standard library, sizes and layouts: what must agree between program and plugin.
std::string abi_of_this_engine();
template <int = 0>
const char* abi_of_this_file() {
  static const std::string text =
      std::string(SUDAR_VERSION) + (sizeof(Real) == 4 ? " float" : " double") +
#ifdef __clang__
      " clang " + std::to_string(__clang_major__) +
#else
      " g++ " + std::to_string(__GNUC__) +
#endif
#ifdef _LIBCPP_VERSION
      " libc++ " + std::to_string(_LIBCPP_VERSION) +
#else
      " libstdc++ " + std::to_string(_GLIBCXX_RELEASE) +
#endif
      " sizes " + std::to_string(sizeof(World)) + " " + std::to_string(sizeof(JointDef)) + " " +
      std::to_string(sizeof(Params)) + " " + std::to_string(sizeof(State)) + " " + std::to_string(sizeof(Check)) + " " +
      std::to_string(sizeof(Input)) + " layouts " + std::to_string(Layout::of<Config>()) + " " +
      std::to_string(Layout::of<BodyDef>()) + " " + std::to_string(Layout::of(JointDef{}));
  return text.c_str();
}

}

// CMake defines SUDAR_SCENARIO_NAME as the file's name. Linked in statically, each scenario's entry has a symbol of its
// own; in a plugin they all have the same, which the loader looks up.
#define SUDAR_SCENARIO_TEXT_(x) #x
#define SUDAR_SCENARIO_TEXT(x) SUDAR_SCENARIO_TEXT_(x)
#define SUDAR_SCENARIO_JOIN_(a, b) a##b
#define SUDAR_SCENARIO_JOIN(a, b) SUDAR_SCENARIO_JOIN_(a, b)
#ifdef SUDAR_STATIC_SCENARIOS
#define SUDAR_SCENARIO_SYMBOL SUDAR_SCENARIO_JOIN(sudar_scenario_, SUDAR_SCENARIO_NAME)
#else
#define SUDAR_SCENARIO_SYMBOL sudar_scenario
#endif
#define SUDAR_SCENARIO(Type, place)                                                                              \
  extern "C" __attribute__((visibility("default"))) const sudar::ScenarioEntry* SUDAR_SCENARIO_SYMBOL() {        \
    static const sudar::ScenarioEntry entry{sudar::abi_of_this_file(),                                           \
                                            SUDAR_SCENARIO_TEXT(SUDAR_SCENARIO_NAME),                            \
                                            place,                                                               \
                                            Type::about,                                                         \
                                            Type::seconds,                                                       \
                                            Type::picture,                                                       \
                                            [](const sudar::ScenarioEntry&) -> sudar::Scenario* { return new Type; },  \
                                            [](sudar::Scenario* s) { delete s; }};                               \
    return &entry;                                                                                               \
  }
