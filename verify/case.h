// A case: a law of mechanics whose exact result is known, and the scene in which the engine has to obey it. The exact
// result is a closed form or a reference that the case computes on the spot (numerics.h) from its parameters, never a
// stored result of our own: a case is a law, not a number, and runs at least two sets of parameters.
//
// A case is a row of data with one function. It reads its parameters from a Run, makes a world, and states quantities:
//   void free_fall(Run& run) {
//     World w(run.config());
//     add_gravity(run, w);
//     const Body b = w.add({.shape = sphere(0.1), .at = {0, run["height"], 0}});
//     run.until(w, 2);
//     run.check("height", "m", fallen(…), w[b].center().y, 5e-5);
//   }
// Its physics can be taken away: `without` names what, with("gravity", x) then gives 0. "impulses" and "contact areas"
// are taken away by config(). A test demands that a case fails without any one of them.
#pragma once

#include <sudar/world.h>

#include "verify/picture.h"

#include <deque>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace sudar::verify {

using Values = std::map<std::string, double>;

struct Parameter {
  const char* name;
  double value, low, high;
  const char* unit;
  bool whole() const;         // a whole number
  std::string range() const;  // "0.1 … 10 m"
};
inline constexpr const char* whole_number = "whole number";  // as a unit

// How much is run: quick is part of the tests, full takes its time.
enum class Effort { quick, normal, full };

struct ParameterSet {
  const char* name;
  Values values;                  // what differs from the defaults
  Effort effort = Effort::quick;  // from which on it is run
  bool sweeps = true;             // false: rounding hides the order
};

// One compared number. It passes when it is within the tolerance, which has the quantity's unit; what shows a wrong
// formula, when it is not.
struct Quantity {
  std::string name, unit;
  double exact, got, tolerance;
  bool refuted = false;
  double error() const { return got > exact ? got - exact : exact - got; }  // NaN: could not be measured
  bool pass() const { return refuted ? error() > tolerance : error() <= tolerance; }
};

// What is drawn: the exact curve as a line, the simulation as dots over it.
struct Plot {
  std::string title, x, y;
  std::vector<std::pair<double, double>> theory{}, simulation{};
};

// What shows that a case bites: with these it fails when any of `without` is taken away. Less than the defaults where
// those take long, finer steps where four sub-steps fail whatever is taken away.
struct Bite {
  Values values{};
  int substeps = 4;
  Effort effort = Effort::quick;  // from which on it is tested
};

class Run;  // a case in one world of one solver with one set of parameters

struct Case {
  const char *id, *title, *group;
  const char* formula;  // the law
  const char* source;   // where it stands
  std::vector<Parameter> parameters{};
  std::vector<ParameterSet> sets{};  // beside the defaults
  void (*run)(Run&) = nullptr;
  std::vector<const char*> without{};  // what can be taken away, one at a time
  Bite bite{};
  Effort effort = Effort::quick;  // from which on it is run
  const char* others = "";        // what other engines reach
  bool uses_solver = true;        // false: geometry
  std::optional<Solver> only{};   // it is about this solver's method
  // What falls as h^order, where theory says so: the run states it by deviation(), and a sweep over step sizes measures
  // the order, with 1, 2, 4 and 8 times so many sub-steps.
  const char* sweep = "";
  double order = 0;
  int sweep_from = 1;
};

class Run {
 public:
  struct Setting {
    Solver solver = Solver::impulse_2007;
    std::string_view without{};  // what is taken away; nothing: the case as it is
    int substeps = 4;            // of a step of 1/60 s
    Effort effort = Effort::normal;
    bool pictures = false;  // of the first world, for the report
  };
  Run(const Case& c, const Values& set, const Setting& setting);

  double operator[](std::string_view parameter) const;
  const Setting& setting() const { return setting_; }
  bool without(std::string_view what) const { return setting_.without == what; }
  double with(std::string_view what, double value) const { return without(what) ? 0 : value; }

  // 60 Hz × 4 sub-steps, no sleeping, the chosen solver; without("impulses") it makes no passes, without("contact
  // areas") a contact is a point.
  Config config() const;
  // The same sub-steps, each a step of its own: for what must be seen more often.
  Config fine_config() const;
  double h() const { return config().dt / config().substeps; }  // length of a sub-step, s
  // Steps until the world's time has come to `seconds`, and visits after each step.
  void until(
      World& w, double seconds, const std::function<void()>& visit = [] {});
  // Into the report's picture, before and after; until() does it where nothing is drawn yet.
  void draw(const World& w);

  void check(std::string name, std::string unit, double exact, double got, double tolerance);
  // The same with a tolerance that is a share of the exact value.
  void relative(std::string name, std::string unit, double exact, double got, double share);
  void below(std::string name, std::string unit, double got, double limit) { check(name, unit, 0, got, limit); }
  // What a wrong formula gives, beside what is right: passes when it is off.
  void refutes(std::string name, std::string unit, double exact, double wrong, double tolerance);
  void holds(std::string name, bool got) { check(name, "", 1, got ? 1 : 0, 0); }
  void deviation(double d) { deviation_ = d; }
  double deviation() const { return deviation_; }
  Plot& plot(std::string title, std::string x, std::string y);

  const std::vector<Quantity>& quantities() const { return quantities_; }
  const std::deque<Plot>& plots() const { return plots_; }
  const Picture& picture() const { return picture_; }  // before and after

 private:
  Values values_;
  Setting setting_;
  std::vector<Quantity> quantities_;
  std::deque<Plot> plots_;  // a plot stays where it is while others are added
  double deviation_ = 0;
  Picture picture_;
};

// The value of the parameter in the set, or its default. Throws Error for one that the case does not know or allow.
Values values_of(const Case&, const Values& set);

}
