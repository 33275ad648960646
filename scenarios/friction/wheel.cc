// A wheel with nine corners rolls down a slope. Each corner that comes down takes energy, the slope gives it back: the
// wheel rolls on and on with the speed of the rimless wheel, which is known in closed form.
#include "thesis.h"

using namespace sudar;

struct Wheel : Scenario {
  static constexpr double seconds = 20;
  static constexpr double picture = 4;
  static constexpr const char* about = "a wheel with nine corners on a slope";
  int corners = 9;
  Real gravity = 4, friction = 10, restitution = 0, slope = 7.5;
  Body wheel;
  double fastest = 0;  // spin in the last 5 s, rad/s

  void params(Params& p) override {
    p("corners", corners, 3, 60), p("slope", slope, 0, 30, "degrees"), p("gravity", gravity, 0, 20, "m/s²");
    p("friction", friction, 0, 10), p("restitution", restitution, 0, 1);
  }
  void state(State& s) override { s("wheel", wheel), s("fastest", fastest); }
  void config(Config& c) override { c = thesis_config(); }

  void build(World& w) override {
    w.add(Gravity{{0, -gravity, 0}});
    w.add({.shape = box({100, 2, 100}),
           .at = {0, -8, 0},
           .turn = turned({0, 0, 1}, slope),
           .material = ground,
           .motion = Motion::fixed,
           .name = "slope"});
    wheel = w.add({.shape = prism(corners, 2, 6),
                   .at = {20, -2, 0},
                   .turn = turned({1, 0, 0}, 90),
                   .density = 1,
                   .material = {friction, friction, restitution}});
  }

  void observe(const World& w, Check&) override {
    if (w.time() > seconds - 5) fastest = max(fastest, double(length(w[wheel].spin())));
  }
  // Rimless wheel (T. McGeer, 1990): a corner that comes down leaves η = (k² + r² cos 2α) / (k² + r²) of the spin, k
  // the radius of gyration, 2α the angle between corners; until the next comes down, the slope gives g · side · sin γ
  // per mass.
  double spin_before_a_corner() const {
    const double r = 2, angle = 2 * pi / corners, k2 = r * r / 6 * (2 + sudar::cos(angle));
    const double kept = (k2 + r * r * sudar::cos(angle)) / (k2 + r * r);
    const double gain = gravity * 2 * r * sudar::sin(angle / 2) * sudar::sin(slope * pi / 180);
    return sqrt(2 * gain / ((k2 + r * r) * (1 - kept * kept)));
  }
  void check(const World& w, Check& c) override {
    c.above("way down", 20 - w[wheel].pose().p.x, 1, "m");
    if (restitution > 0) return;
    const double exact = spin_before_a_corner();
    c.near("spin before a corner comes down", fastest, exact, 0.03 * exact, "rad/s");
  }
  std::optional<Camera> camera() const override { return Camera{{9, 4, 32}, {8, -5, 0}}; }
};
SUDAR_SCENARIO(Wheel, "Friction/Wheel")
