// The scenes whose speed the thesis's prototype is known for, with its figures: µs per step, one thread, median of 1000
// steps after warm-up, Java 17 on two virtual cores.
#pragma once

#include <sudar/session.h>

#include <functional>

#include "bench/meter.h"

namespace sudar::bench {

struct ThesisCase {
  const char* title;
  const char* scene;
  std::map<std::string, double> set;
  std::optional<double> prototype_us;  // none: not known
};
std::span<const ThesisCase> thesis_cases();

inline constexpr int warm_up_steps = 100, measured_steps = 1000;

// Runs the case with sleeping off, `repeat` times, and keeps the fastest median: other programs can only slow a run
// down. `progress` is told how many of the steps of all repetitions are done.
struct ThesisResult {
  Session session;  // after its last step
  Meter meter;
};
ThesisResult measure(const ThesisCase&, const Catalogue&, int repeat, const std::function<void(int)>& progress);

}
