// Newton's cradle: one ball in, one ball out.
#include "thesis.h"

using namespace sudar;

struct Cradle : Scenario {
  static constexpr double seconds = 4;
  static constexpr double picture = 3.2;
  static constexpr const char* about = "Newton's cradle: one ball in, one ball out";
  int at_rest = 5;
  Real gravity = 5, restitution = 1;
  std::vector<Body> balls;  // the one that swings in first
  double hit = -1;          // when it hit, s
  double speed = 0, speed_out = 0,
         others = 0;  // before the hit; after it, of the last ball and of the fastest other, m/s

  void params(Params& p) override {
    p("at_rest", at_rest, 1, 20, "balls that hang"), p("gravity", gravity, 0, 20, "m/s²"),
        p("restitution", restitution, 0, 1);
  }
  void state(State& s) override {
    s("balls", balls), s("hit", hit);
    s("speed", speed), s("speed_out", speed_out), s("others", others);
  }
  void config(Config& c) override { c = thesis_config(); }

  void add(World& w, const Pos& nail, const Pos& at) {
    const Body fixed = w.add({.shape = box({0.5, 0.5, 2.5}), .at = nail, .motion = Motion::fixed});
    balls.push_back(w.add({.shape = sphere(1), .at = at, .density = 1, .material = {.restitution = restitution}}));
    w.join(Hinge{.a = fixed, .b = balls.back(), .at = nail});
  }
  void build(World& w) override {
    w.add(Gravity{{0, -gravity, 0}});
    add(w, {-2, 5, 0}, {-12, 5, 0});
    for (int i = 0; i < at_rest; ++i) add(w, {2.0 * i, 5, 0}, {2.0 * i, -5, 0});
  }

  void observe(const World& w, Check&) override {
    if (hit >= 0) return;
    const double first = w[balls.front()].velocity().x;
    if (first < 0.5 * speed) {
      hit = w.time();
      speed_out = w[balls.back()].velocity().x;
      for (Body ball : balls) {
        if (ball != balls.back()) others = max(others, double(length(w[ball].velocity())));
      }
    }
    speed = max(speed, first);
  }
  void check(const World&, Check& c) override {
    c.near("the ball hits", hit, 2.65, 0.02, "s");
    c.near("speed of the ball that leaves", speed_out, speed, 0.01 * speed, "m/s");
    c.below("speed of the fastest other", others, 0.01 * speed, "m/s");
  }
  std::optional<Camera> camera() const override { return Camera{{10, 2, 30}, {3, -0.5, 0}}; }
};
SUDAR_SCENARIO(Cradle, "Impacts/Newton's cradle")
