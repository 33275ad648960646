// Seven cubes in a touching row between two walls. The first flies off, comes back and its speed runs through the row,
// as in Newton's cradle: nothing but the order of elastic impacts decides, and kinetic energy stays what it was.
#include "thesis.h"

using namespace sudar;

struct ElasticRow : Scenario {
  static constexpr double seconds = 60;
  static constexpr double picture = 11;
  static constexpr const char* about = "elastic cubes between walls pass their speed on for ever";
  int count = 7;
  Real restitution = 1, speed = 2;
  std::vector<Body> cubes;
  double start_energy() const { return 0.5 * 8 * square(double(speed)); }

  void params(Params& p) override {
    p("cubes", count, 1, 15), p("restitution", restitution, 0, 1), p("speed", speed, 0, 20, "m/s, of the first");
  }
  void state(State& s) override { s("cubes", cubes); }
  void config(Config& c) override {
    c = thesis_config();
    c.soft_step.substeps = 4;  // finds contacts once a step
  }

  void build(World& w) override {
    const Material material{Real(0.6), Real(0.4), restitution};
    for (double side : {-20.0, 20.0}) {
      w.add({.shape = box({4, 4, 4}), .at = {side, 0, 0}, .material = material, .motion = Motion::fixed});
    }
    for (int i = 0; i < count; ++i) { cubes.push_back(add_box(w, {2, 2, 2}, {2.0 * i - (count - 1), 0, 0}, material)); }
    w.set_velocity(cubes.front(), {-speed, 0, 0}, {});
  }

  void observe(const World& w, Check& c) override {
    if (restitution < 1) return;
    c.near("kinetic energy", w.energy().kinetic, start_energy(), 5e-5 / 16 * start_energy(), "J");
    double off = 0;
    int moving = 0;
    for (Body cube : cubes) {
      const Pos p = w[cube].pose().p;
      off = max(off, sqrt(square(p.y) + square(p.z)));
      moving += length(w[cube].velocity()) > 0.5 * speed;
    }
    c.near("cubes that move", moving, 1, 0);
    c.below("off the line", off, 1e-4, "m");
  }
  void check(const World& w, Check& c) override {
    if (restitution < 1) c.below("kinetic energy that is left", w.energy().kinetic, start_energy(), "J");
  }
  std::optional<Camera> camera() const override { return Camera{{6, 12, 46}, {0, 0, 0}}; }
};
SUDAR_SCENARIO(ElasticRow, "Impacts/Elastic row")
