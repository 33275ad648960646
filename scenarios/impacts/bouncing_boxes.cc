// Ten boxes that keep 1 − 2^−i of their speed in a bounce: each rises to e² of its height.
#include "thesis.h"

using namespace sudar;

struct BouncingBoxes : Scenario {
  static constexpr double seconds = 14;  // the last is up again after 13.4 s
  static constexpr double picture = 9;
  static constexpr const char* about = "ten boxes, from dead to almost elastic, rise to e² of their height";
  int boxes = 10;
  Real gravity = 1, height = 22.25;
  Body floor;
  std::vector<Body> falling;
  std::vector<double> apex;  // after the first bounce, above the place of rest, m; −1: not bounced yet

  void params(Params& p) override {
    p("boxes", boxes, 1, 20), p("gravity", gravity, 0, 20, "m/s²"), p("height", height, 0.1, 100, "m, of the fall");
  }
  void state(State& s) override { s("floor", floor), s("falling", falling), s("apex", apex); }
  void config(Config& c) override { c = thesis_config(); }

  double restitution(int i) const { return 1 - 1.0 / double(1 << i); }
  void build(World& w) override {
    floor = add_floor(w, -13, gravity);
    for (int i = 0; i < boxes; ++i) {
      falling.push_back(w.add({.shape = box({1.5, 1.5, 1.5}),
                               .at = {(i - 4.5) * 4, -12.25 + height, 0},
                               .density = 1000,
                               .material = {0, 0, Real(restitution(i))}}));
    }
    apex.assign(std::size_t(boxes), -1);
  }

  void observe(const World& w, Check&) override {
    for (std::size_t i = 0; i < falling.size(); ++i) {
      if (apex[i] >= 0) {
        apex[i] = max(apex[i], w[falling[i]].pose().p.y + 12.25);
      } else if (w.touching(falling[i], floor)) {
        apex[i] = 0;
      }
    }
  }
  void check(const World&, Check& c) override {
    for (int i = 0; i < boxes; ++i) {
      const double exact = square(restitution(i)) * height;
      c.near("apex with e = 1 − 2^−" + std::to_string(i), apex[std::size_t(i)], exact, 0.003 * exact + 0.01, "m");
    }
  }
  std::optional<Camera> camera() const override { return Camera{{7, 4, 46}, {0, -1.5, 0}}; }
};
SUDAR_SCENARIO(BouncingBoxes, "Impacts/Bouncing boxes")
