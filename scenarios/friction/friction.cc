// A box on an incline: it holds if μ > tan 30° = 0.577, and slides with g (sin α − μ cos α) if not.
#include "thesis.h"

using namespace sudar;

struct Friction : Scenario {
  static constexpr double seconds = 10;
  static constexpr double picture = 5;
  static constexpr const char* about = "a box on an incline, held by friction or not";
  Real gravity = 1, friction = 0.6, incline = 30;
  Body box_on_it;
  Pos start() const { return Pos{} + rotate(slope(), Vec3{-10, 2, 0}); }
  Quat slope() const { return turned({0, 0, 1}, -double(incline)); }

  void params(Params& p) override {
    p("gravity", gravity, 0, 20, "m/s²"), p("friction", friction, 0, 2), p("incline", incline, 0, 60, "degrees");
  }
  void state(State& s) override { s("box", box_on_it); }
  void config(Config& c) override { c = thesis_config(); }

  void build(World& w) override {
    add_floor(w, -15, gravity);
    w.add(
        {.shape = box({400, 2, 10}), .turn = slope(), .material = ground, .motion = Motion::fixed, .name = "incline"});
    box_on_it = add_box(w, {12, 2, 4}, start(), {friction, friction}, slope());
  }

  void check(const World& w, Check& c) override {
    const double angle = incline * pi / 180, t = w.time();
    const double acceleration = gravity * (sudar::sin(angle) - friction * sudar::cos(angle));
    const Vec3 way = w[box_on_it].pose().p - start();
    const double down = dot(way, rotate(slope(), Vec3{1, 0, 0}));
    if (acceleration > 0) {
      const double exact = acceleration * t * t / 2;
      c.near("way down the incline", down, exact, 0.002 * exact, "m");
    } else {
      c.below("creep down the incline", length(way), 0.001, "m");
    }
  }
  std::optional<Camera> camera() const override { return Camera{{-5, 12, 45}, {-5, 4, 0}}; }
};
SUDAR_SCENARIO(Friction, "Friction/Incline")
