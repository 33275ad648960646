// A locomotive that pulls less than static friction holds: 600 < 0.15 · 10 wagons · 90 kg · 5 m/s² = 675. It must not
// move, and did in the prototype, which tested the friction cone per increment (thesis erratum cone).
#include "thesis.h"

using namespace sudar;

struct Train : Scenario {
  static constexpr double seconds = 10;
  static constexpr double picture = 5;
  static constexpr const char* about = "a locomotive that pulls a little less than friction holds";
  int wagons = 10;
  Real gravity = 5, friction_static = 0.15, friction_dynamic = 0.1, force = 600;
  std::vector<Body> train;

  void params(Params& p) override {
    p("wagons", wagons, 1, 100), p("force", force, 0, 5000, "N, of the locomotive"),
        p("gravity", gravity, 0, 20, "m/s²");
    p("friction_static", friction_static, 0, 2), p("friction_dynamic", friction_dynamic, 0, 2);
  }
  void state(State& s) override { s("train", train); }
  void config(Config& c) override { c = thesis_config(); }

  void build(World& w) override {
    add_floor(w, -1.5, gravity);
    for (int i = 0; i < wagons; ++i) {
      train.push_back(add_box(w, {10, 3, 3}, {11.0 * i, 0, 0}, {friction_static, friction_dynamic}));
      if (i == 0) continue;
      for (double y : {-1.0, 1.0})
        w.join(Ball{.a = train[train.size() - 2], .b = train.back(), .at = {11 * i - 5.5, y, 0}});
    }
    w.add(Thruster{.body = train[0], .force = {-force, 0, 0}});
  }

  void check(const World& w, Check& c) override {
    double mass = 0;
    for (Body wagon : train) mass += w[wagon].mass();
    const double held = friction_static * mass * gravity, moved = -w[train[0]].pose().p.x;
    if (force < held) {
      c.below("movement of the locomotive", abs(moved), 1e-6, "m");
    } else {
      const double exact = (force - friction_dynamic * mass * gravity) / mass * square(w.time()) / 2;
      c.near("way of the locomotive", moved, exact, 0.1 * exact, "m");  // it takes 0.3 s to break loose
    }
  }
  std::optional<Camera> camera() const override { return Camera{{14, 26, 100}, {45, -2, 3}}; }
};
SUDAR_SCENARIO(Train, "Friction/Train")
