// What spins on the ground comes to rest: a box and a football on a face by the friction of their faces, a tilted disc
// by rolling resistance, and a ball, which touches in one point only, by spinning resistance alone: in 2 r² ω / (5 s
// g).
#include "thesis.h"

using namespace sudar;

struct Spin : Scenario {
  static constexpr double seconds = 60;
  static constexpr double picture = 1;
  static constexpr const char* about = "a box, a football, a disc and a ball spin and come to rest";
  Real gravity = 1, rolling = 0.05, spinning = 0.1;
  Body box_, football, disc, ball;
  double stopped = -1;  // when the ball came to rest, s
  static constexpr double ball_radius = 2, ball_spin = 2;

  void params(Params& p) override {
    p("gravity", gravity, 0, 20, "m/s²"), p("spinning", spinning, 0, 1, "m, torque / normal force"),
        p("rolling", rolling, 0, 1, "m, torque / normal force");
  }
  void state(State& s) override {
    s("box", box_), s("football", football), s("disc", disc), s("ball", ball), s("stopped", stopped);
  }
  void config(Config& c) override {
    c = thesis_config();
    c.soft_step.substeps = 4;  // finds contacts once a step
  }

  void build(World& w) override {
    add_floor(w, -2, gravity);
    const auto add = [&](const Shape& shape, const Pos& at, const Quat& turn, Real spin, Material material) {
      material.rolling = rolling, material.spinning = spinning;
      return w.add({.shape = shape, .at = at, .turn = turn, .spin = {0, spin, 0}, .density = 1, .material = material});
    };
    const Material usual{Real(0.5), Real(0.4), Real(0.5)};
    box_ = add(box({6, 6, 6}), {15, 1, 0}, {}, 1, usual);
    football = add(truncated_icosahedron(2), {-15, 3, 0}, {}, 1, usual);
    disc = add(prism(20, 5, 1), {0, 3, 15}, turned({1, 0, 0}, 30), 2, {Real(0.3), Real(0.3)});
    ball = add(sphere(ball_radius), {0, -2 + ball_radius, -5}, {}, Real(ball_spin), {Real(0.5), Real(0.4)});
  }

  void observe(const World& w, Check&) override {
    if (stopped < 0 && length(w[ball].spin()) < 1e-3) stopped = w.time();
  }
  void check(const World& w, Check& c) override {
    for (const auto& [name, body] : {std::pair("box", box_), {"football", football}, {"disc", disc}, {"ball", ball}}) {
      const double speed = max(length(w[body].velocity()), length(w[body].spin()));
      c.below(std::string(name) + ": speed at the end", speed, 1e-3);
    }
    const double exact = 0.4 * square(ball_radius) * ball_spin / (spinning * gravity);
    c.near("the ball stops after", stopped, exact, 0.01 * exact, "s");
  }
  std::optional<Camera> camera() const override { return Camera{{12, 16, 46}, {0, 0, 4}}; }
};
SUDAR_SCENARIO(Spin, "Friction/Spin")
