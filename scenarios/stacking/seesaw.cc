// A plank that lies on an edge, with a light box on one end and a heavy one on the other. The heavy side goes down as
// the lever says. It is the scene on which shock propagation fails: what holds the heavy box up must be moved by it.
#include "thesis.h"

using namespace sudar;

struct Seesaw : Scenario {
  static constexpr double seconds = 6;
  static constexpr double picture = 1.6;
  static constexpr const char* about = "a heavy box lifts a light one";
  static constexpr double arm = 9, length = 24, thick = 0.6, edge = 3;  // m; height of the edge
  Real gravity = 5, friction = 0.6, ratio = 3;
  Body plank, light, heavy, floor;
  double landed = -1, highest = 0;  // when the plank met the floor, s; how far the light box rose, m

  void params(Params& p) override {
    p("gravity", gravity, 0, 20, "m/s²"), p("friction", friction, 0, 2);
    p("ratio", ratio, 1.2, 20, "mass of the heavy box / of the light one");
  }
  void state(State& s) override {
    s("plank", plank), s("light", light), s("heavy", heavy), s("floor", floor);
    s("landed", landed), s("highest", highest);
  }
  void config(Config& c) override { c = thesis_config(); }

  void build(World& w) override {
    floor = add_floor(w, 0, gravity);
    const Vec3 outline[] = {{-2, 0, 0}, {2, 0, 0}, {0, Real(edge), 0}};
    w.add({.shape = prism(outline, 6), .material = ground, .motion = Motion::fixed, .name = "edge"});
    const Material material{friction, friction};
    plank = add_box(w, {Real(length), Real(thick), 4}, {0, edge + thick / 2, 0}, material);
    light = add_box(w, {2, 2, 2}, {-arm, edge + thick + 1, 0}, material);
    heavy = w.add({.shape = box({2, 2, 2}),
                   .at = {arm, edge + thick + 1, 0},
                   .density = ratio,
                   .material = material,
                   .name = "heavy"});
  }

  void observe(const World& w, Check&) override {
    if (landed < 0 && w.touching(plank, floor)) landed = w.time();
    highest = max(highest, w[light].pose().p.y - (edge + thick + 1));
  }
  // Until the plank's end is down: I θ'' = torque about the edge, the boxes fixed to the plank.
  double exact_time(const World& w) const {
    const double m = w[light].mass(), heavy_mass = w[heavy].mass(), p = w[plank].mass(), up = thick + 1;
    const double boxes = (m + heavy_mass) * (square(arm) + square(up) + 4.0 / 6);
    const double inertia = boxes + p * (square(length) + square(thick)) / 12 + p * square(thick / 2);
    const double h = 1e-4;
    double angle = 0, speed = 0, t = 0;
    while (edge > length / 2 * sudar::sin(angle) && t < seconds) {
      const double lever =
          (heavy_mass - m) * arm * sudar::cos(angle) + ((heavy_mass + m) * up + p * thick / 2) * sudar::sin(angle);
      speed += h * gravity * lever / inertia;
      angle += h * speed, t += h;
    }
    return t;
  }
  void check(const World& w, Check& c) override {
    const double exact = exact_time(w);
    c.near("the heavy side is down after", landed, exact, 0.03 * exact, "s");
    c.above("the light box has risen by", highest, edge * arm / (length / 2) * 0.9, "m");
    c.below("the heavy box stands at", w[heavy].pose().p.y, edge, "m");
  }
  std::optional<Camera> camera() const override { return Camera{{4, 9, 30}, {0, 3, 0}}; }
};
SUDAR_SCENARIO(Seesaw, "Stacking/Seesaw")
