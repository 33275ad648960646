#include "bench/thesis.h"

namespace sudar::bench {

std::span<const ThesisCase> thesis_cases() {
  static const ThesisCase cases[] = {
      {"wall + ball", "wall", {}, 498},
      {"wall", "wall", {{"ball", 0}}, 565},
      {"tower of 10", "towers", {{"left", 10}, {"middle", 1}, {"right", 1}}, 52},
      {"tower of 15", "towers", {{"left", 1}, {"middle", 15}, {"right", 1}}, 82},
      {"tower of 25", "towers", {{"left", 1}, {"middle", 1}, {"right", 25}}, 134},
      {"net", "net", {}, 523},
      {"dominoes", "dominoes", {}, 309},
      {"sticks", "sticks", {}, 48},
      {"chain (hinges)", "chain", {}, 104},
  };
  return cases;
}

namespace {

ThesisResult measure_once(const ThesisCase& c, const Catalogue& catalogue, const std::function<void(int)>& progress,
                          int done) {
  Session session(catalogue.find(c.scene), {.set = c.set, .config = {{"sleep", "false"}}, .seconds = {}});
  for (int i = 0; i < warm_up_steps; ++i) session.step();
  Meter meter(session.world());
  for (int i = 0; i < measured_steps; ++i) {
    session.step();
    meter.after_step(session.world());
    progress(done + warm_up_steps + i + 1);
  }
  return {std::move(session), std::move(meter)};
}

}

ThesisResult measure(const ThesisCase& c, const Catalogue& catalogue, int repeat,
                     const std::function<void(int)>& progress) {
  ThesisResult best = measure_once(c, catalogue, progress, 0);
  for (int r = 1; r < repeat; ++r) {
    ThesisResult next = measure_once(c, catalogue, progress, r * (warm_up_steps + measured_steps));
    if (next.meter.step_us_median() < best.meter.step_us_median()) best = std::move(next);
  }
  return best;
}

}
