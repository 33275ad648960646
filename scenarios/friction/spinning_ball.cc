// thesis fig. 12: friction during an impact turns spin into speed. A solid sphere that spins with ω and bounces without
// slip leaves with v = −(2/7) ω r and spins with (2/7) ω.
#include "thesis.h"

using namespace sudar;

struct SpinningBall : Scenario {
  static constexpr double seconds = 20;
  static constexpr double picture = 8;
  static constexpr const char* about = "a ball that spins leaves its bounce sideways (thesis, fig. 12)";
  Real gravity = 1, friction = 0.5, restitution = 0.9, spin = pi;
  Body spinning, straight;
  bool bounced = false;
  double apex = -1000;  // of the straight ball after its first bounce, m

  void params(Params& p) override {
    p("gravity", gravity, 0, 20, "m/s²"), p("friction", friction, 0, 10), p("restitution", restitution, 0, 1);
    p("spin", spin, -50, 50, "rad/s");
  }
  void state(State& s) override {
    s("spinning", spinning), s("straight", straight), s("bounced", bounced), s("apex", apex);
  }
  void config(Config& c) override { c = thesis_config(1, 1); }

  void build(World& w) override {
    add_floor(w, -10, gravity);
    for (double side : {-1.0, 1.0}) {
      add_plane(w, {30 * side, 0, 0}, turned({0, 0, 1}, 90 * side));
      add_plane(w, {0, 0, 30 * side}, turned({1, 0, 0}, -90 * side));
    }
    const Material material{friction, friction, restitution};
    spinning =
        w.add({.shape = sphere(2.5), .at = {0, 10, 0}, .spin = {0, 0, spin}, .density = 1, .material = material});
    straight = w.add({.shape = sphere(2.5), .at = {10, 10, 0}, .density = 1, .material = material});
  }

  void observe(const World& w, Check& c) override {
    const double up = w[straight].velocity().y;
    if (up > 0) bounced = true;
    if (bounced) apex = max(apex, w[straight].pose().p.y);
    // The first bounce is at √(2·17.5/g) = 5.92 s, the second at 16.56 s.
    c.at(8).near("speed sideways after the bounce", w[spinning].velocity().x, -2.0 / 7 * spin * 2.5, 0.001, "m/s");
    c.at(8).near("spin after the bounce", w[spinning].spin().z, 2.0 / 7 * spin, 0.001, "rad/s");
    c.below("the other ball stays on its line", horizontal_distance(w[straight].pose().p, {10, 0, 0}), 0.001, "m");
  }
  void check(const World&, Check& c) override {
    const double exact = -7.5 + square(double(restitution)) * 17.5;
    c.near("apex after the bounce", apex, exact, 0.003 * 17.5, "m");
  }
  std::optional<Camera> camera() const override { return Camera{{10, 5, 44}, {2, -1, 0}}; }
};
SUDAR_SCENARIO(SpinningBall, "Friction/Spinning ball")
