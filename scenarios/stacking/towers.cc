// thesis fig. 9: three towers. In the prototype, whose contacts were one point each, all of them fell.
#include "thesis.h"

using namespace sudar;

struct Towers : Scenario {
  static constexpr double seconds = 20;
  static constexpr double picture = 10;
  static constexpr const char* about = "towers of 10, 15 and 25 cubes that stand (thesis, fig. 9)";
  int left = 10, middle = 15, right = 25;
  Real gravity = 5, friction = 0.5;
  double gap = 0.1;
  std::vector<Body> cubes[3];  // bottom first
  double drift_at_10[3] = {};  // m

  void params(Params& p) override {
    p("left", left, 1, 60), p("middle", middle, 1, 60), p("right", right, 1, 60);
    p("gravity", gravity, 0, 20, "m/s²"), p("friction", friction, 0, 10), p("gap", gap, 0, 1, "m, before they fall");
  }
  void state(State& s) override {
    for (auto& tower : cubes) s("cubes", tower);
    s("drift_at_10", drift_at_10);
  }
  void config(Config& c) override { c = thesis_config(); }

  void build(World& w) override {
    add_floor(w, -8, gravity);
    add_drag(w);
    const int heights[3] = {left, middle, right};
    for (int t = 0; t < 3; ++t) {
      for (int i = 0; i < heights[t]; ++i) {
        cubes[t].push_back(add_box(w, {4, 4, 4}, {30.0 * (t - 1), -6 + gap + (4 + gap) * i, 0}, {friction, friction}));
      }
    }
  }

  double drift(const World& w, int t) const {
    double worst = 0;
    for (Body cube : cubes[t]) worst = max(worst, horizontal_distance(w[cube].pose().p, {30.0 * (t - 1), 0, 0}));
    return worst;
  }
  void observe(const World& w, Check& c) override {
    for (int t = 0; t < 3; ++t) {
      const std::string name = "tower of " + std::to_string(cubes[t].size());
      const double now = drift(w, t), size = double(cubes[t].size());
      if (w.time() < 10.005) drift_at_10[t] = now;
      c.at(10).below(name + ": drift at 10 s", now, 0.1, "m");
      c.at(20).below(name + ": further drift by 20 s", now - drift_at_10[t], 0.02, "m");
      // The touching stack has its top cube's centre at −10 + 4 n; every joint between two cubes may give way by slop.
      c.from(10).below(name + ": sinking", -10 + 4 * size - w[cubes[t].back()].pose().p.y,
                       size * w.config().impulse_2007.slop, "m");
      if (w.config().sleep) c.at(20).that(name + ": sleeps", w[cubes[t].back()].asleep());
    }
  }
  std::optional<Camera> camera() const override { return Camera{{50, 62, 172}, {2, 43, 0}}; }
};
SUDAR_SCENARIO(Towers, "Stacking/Towers")
