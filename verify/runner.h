// Runs cases: each in worlds of its own, so as many at once as there are threads.
#pragma once

#include <optional>

#include "verify/case.h"

namespace sudar::verify {

// The 63 cases of the catalogue by groups, and the extra ones after them.
const std::vector<Case>& all_cases();
const Case& find_case(std::string_view id);  // throws Error

struct Result {
  const Case* of;
  std::string set;  // name of the parameter set
  Values parameters;
  std::optional<Solver> solver;  // none: the case is geometry
  std::string_view without{};    // what was taken away
  bool sweeps = true;            // whether it measures the order
  std::vector<Quantity> quantities{};
  std::deque<Plot> plots{};
  std::string picture{};                           // SVG
  std::vector<std::pair<double, double>> sweep{};  // length of a sub-step, deviation
  double seconds = 0;                              // it took
  std::string failure{};                           // why it could not be run to its end
  bool passed() const;
};

struct Options {
  std::vector<std::string> cases{};  // by id; none: all that the effort allows
  Effort effort = Effort::normal;
  Values set{};  // instead of the cases' own sets: their defaults with these
  std::vector<Solver> solvers{Solver::impulse_2007};
  unsigned jobs = 0;      // 0: as many as the processor has
  bool pictures = false;  // for the report
  bool bites = false;     // instead: each case with its bite, as it is and with each part of its physics taken away
};

// How many cases pass: a case does when it does so with every set of parameters and every solver. The catalogue's are
// V…; beside them stand SimBenchmark's tasks and the thesis's errata.
struct Tally {
  int cases = 0, passed = 0;  // of the catalogue
  int beside = 0, beside_passed = 0;
  std::string text() const;
};
Tally count(const std::vector<Result>&);

// What the list of known failures (known_failures.h) does not expect: cases that fail and are not in it, and cases in it
// that pass; not with `set` parameters, with which nobody knows.
struct Surprise {
  const Case* of;
  std::optional<Solver> solver;
  bool operator==(const Surprise&) const = default;
};
struct Surprises {
  std::vector<Surprise> failed, passed;
  bool none() const { return failed.empty() && passed.empty(); }
};
Surprises surprises(const std::vector<Result>&, const Options&);

const char* solver_name(Solver);

// In the order of the cases, whatever finishes first. `progress` is told the share that is done, now and then, on the
// thread that called.
std::vector<Result> run_cases(
    const Options&, const std::function<void(double share)>& progress = [](double) {});

}
