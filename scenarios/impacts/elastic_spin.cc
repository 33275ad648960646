// Two rods on pivots that turn into each other: an elastic impact between bodies that cannot fly off. Each turns back
// with the speed that it had.
#include "thesis.h"

using namespace sudar;

struct ElasticSpin : Scenario {
  static constexpr double seconds = 60;
  static constexpr double picture = 12;
  static constexpr const char* about = "two rods on pivots turn into each other, elastically";
  Real restitution = 1, friction = 0, spin = 0.1;
  Body rods[2];
  double first = -1;  // the first impact, s

  void params(Params& p) override {
    p("restitution", restitution, 0, 1), p("friction", friction, 0, 2), p("spin", spin, -2, 2, "rad/s");
  }
  void state(State& s) override { s("rods", rods), s("first", first); }
  void config(Config& c) override { c = thesis_config(); }

  void build(World& w) override {
    for (int i : {0, 1}) {
      const Pos at{i == 0 ? -2.2 : 2.2, 0, 0};
      rods[i] = add_box(w, {1, 5, 1}, at, {friction, friction, restitution});
      w.set_velocity(rods[i], {}, {0, 0, spin});
      w.join(Hinge{.b = rods[i], .at = at});
    }
  }

  void observe(const World& w, Check& c) override {
    if (first < 0 && !w.events().hits.empty()) first = w.time();
    const double moment = 5.0 * (1 + 25) / 12, start = moment * square(double(spin));  // m (a² + b²) / 12, two rods
    if (restitution == 1 && friction == 0) {
      c.near("kinetic energy", w.energy().kinetic, start, 1e-4 * start, "J");
    } else {
      c.below("kinetic energy", w.energy().kinetic, start * (1 + 1e-5), "J");
    }
  }
  // The rods meet when their faces do, 4.4 cos α = 1.
  void check(const World&, Check& c) override {
    if (spin > 0) c.near("the first impact", first, sudar::acos(1 / 4.4) / spin, 0.02, "s");
  }
  std::optional<Camera> camera() const override { return Camera{{3, 3, 12}, {0, 0, 0}}; }
};
SUDAR_SCENARIO(ElasticSpin, "Impacts/Elastic spin")
