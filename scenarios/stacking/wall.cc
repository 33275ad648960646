// thesis fig. 7: the impulses that carry a wall travel up from the ground; a ball breaks through it.
#include "thesis.h"

using namespace sudar;

struct Wall : Scenario {
  static constexpr double seconds = 8;
  static constexpr double picture = 2.4;
  static constexpr const char* about = "a wall of fifty bricks and the ball that breaks it (thesis, fig. 7)";
  int rows = 10, columns = 5;
  bool with_ball = true;
  Real gravity = 5, friction_static = 0.6, friction_dynamic = 0.4, speed = 60, spin = 0.2 * pi, ball_density = 5;
  std::vector<Body> bricks;  // row by row
  Body ball;
  double hit = -1;  // when the ball met the wall, s

  void params(Params& p) override {
    p("ball", with_ball, "throw the ball");
    p("rows", rows, 1, 30), p("columns", columns, 1, 20);
    p("gravity", gravity, 0, 20, "m/s²");
    p("friction_static", friction_static, 0, 10), p("friction_dynamic", friction_dynamic, 0, 10);
    p("speed", speed, 0, 200, "m/s"), p("spin", spin, -20, 20, "rad/s"),
        p("ball_density", ball_density, 0.01, 1000, "kg/m³");
  }
  void state(State& s) override { s("bricks", bricks), s("ball", ball), s("hit", hit); }
  void config(Config& c) override { c = thesis_config(); }

  Pos place(int brick) const {
    const int row = brick / columns, column = brick % columns;
    return {(column - 2) * 25.0 + (row % 2 == 0 ? 12 : 0), (row + 0.5) * 6.5 - 30, 0};
  }
  void build(World& w) override {
    add_floor(w, -30, gravity);
    const Material material{friction_static, friction_dynamic};
    for (int i = 0; i < rows * columns; ++i) bricks.push_back(add_box(w, {25, 6.5, 12}, place(i), material));
    if (with_ball) {
      ball = w.add({.shape = sphere(7.5),
                    .at = {0, 0, 100},
                    .velocity = {0, 0, -speed},
                    .spin = {0, 0, spin},
                    .density = ball_density,
                    .material = material,
                    .name = "ball"});
    }
  }

  void observe(const World& w, Check& c) override {
    for (const Contact& contact : w.contacts()) {
      if (hit < 0 && !ball.null() && (contact.a == ball || contact.b == ball)) hit = w.time() - w.config().dt;
    }
    if (hit >= 0) return;
    double moved = 0;
    for (std::size_t i = 0; i < bricks.size(); ++i) {
      moved = max(moved, double(length(w[bricks[i]].pose().p - place(int(i)))));
    }
    c.below("largest movement of an untouched brick", moved, 0.01, "m");
  }
  void check(const World& w, Check& c) override {
    if (!with_ball) return;
    c.near("the ball hits", hit, 1.44, 0.02, "s");
    c.below("the ball has punched through: its z", w[ball].pose().p.z, -6 - 7.5, "m");
  }
  std::optional<Camera> camera() const override { return Camera{{78, 8, 138}, {6, -1, 0}}; }
};
SUDAR_SCENARIO(Wall, "Stacking/Wall and ball")
