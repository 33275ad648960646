// A half circle of wedge-shaped stones without mortar. It stands if it is thick enough for a line of thrust to stay
// inside: thickness / radius > 0.1075 (M. Milanković, Theorie der Druckkurven, 1907), thinner ones fold in five hinges.
#include "thesis.h"

using namespace sudar;

struct Arch : Scenario {
  static constexpr double seconds = 10;
  static constexpr double picture = 5;
  static constexpr const char* about = "an arch of loose stones stands if it is thick enough";
  static constexpr double radius = 10, least = 0.1075;
  int stones = 15;
  Real gravity = 5, friction = 0.7, thickness = 0.15;
  std::vector<Body> arch;  // from the right to the left

  void params(Params& p) override {
    p("stones", stones, 5, 41), p("gravity", gravity, 0, 20, "m/s²"), p("friction", friction, 0, 2);
    p("thickness", thickness, 0.05, 0.5, "share of the radius");
  }
  void state(State& s) override { s("arch", arch); }
  void config(Config& c) override { c = thesis_config(); }

  void build(World& w) override {
    add_floor(w, 0, gravity);
    const double inner = radius * (1 - thickness / 2), outer = radius * (1 + thickness / 2);
    for (int i = 0; i < stones; ++i) {
      Vec3 outline[4];
      for (int end : {0, 1}) {
        const double angle = (i + end) * pi / stones, x = sudar::cos(angle), y = sudar::sin(angle);
        outline[end == 0 ? 0 : 3] = {Real(inner * x), Real(inner * y), 0};
        outline[end == 0 ? 1 : 2] = {Real(outer * x), Real(outer * y), 0};
      }
      arch.push_back(w.add({.shape = prism(outline, 4), .density = 1, .material = {friction, friction}}));
    }
  }

  void check(const World& w, Check& c) override {
    const double sunk = -w[arch[arch.size() / 2]].pose().p.y;
    if (thickness > least) {
      c.below("the keystone sinks by", sunk, 0.1, "m");
    } else {
      c.above("the keystone falls by", sunk, radius / 2, "m");
    }
  }
  std::optional<Camera> camera() const override { return Camera{{9, 9, 29}, {0, 4.5, 0}}; }
};
SUDAR_SCENARIO(Arch, "Stacking/Arch")
