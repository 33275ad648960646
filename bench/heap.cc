// The heap as a scenario, for bench/window.py. It shows nothing of physics, so it is not among the others:
//   sudar --scenarios build/release/lib/bench heap
#include "bench/heap.h"

#include <sudar/scenario.h>

using namespace sudar;

struct Heap : Scenario {
  static constexpr double seconds = 5;
  static constexpr double picture = 1;
  static constexpr const char* about = "a heap of many boxes and balls, to time pictures with";
  int bodies = 2000;
  void params(Params& p) override { p("bodies", bodies, 1, 20000); }
  void config(Config& c) override { c = heap_config(); }
  void build(World& w) override { add_heap(w, bodies); }
  void check(const World& w, Check& c) override { c.below("overlap", w.quality().penetration_max, 0.5, "m"); }
};
SUDAR_SCENARIO(Heap, "Bench/Heap")
