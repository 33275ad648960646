// Ten balls, six cushions and a cue ball, elastic: between impacts the cue ball slides, then rolls with 5/7 of its
// speed.
#include "thesis.h"

using namespace sudar;

struct Billiards : Scenario {
  static constexpr double seconds = 12;
  static constexpr double picture = 2.6;
  static constexpr const char* about = "a break shot";
  int rows = 4;
  Real gravity = 4, friction = 0.1, restitution = 1, speed = 10, stroke = 10;
  Body cue;
  std::vector<Body> balls;
  std::vector<Pos> racked;                 // where they lay
  double hit = -1, arrival = 0, spin = 0;  // when the cue ball met another, s; its speed and spin just before
  double energy = 0;                       // kinetic, after the shot, J
  bool played = false;                     // the user shot, too

  void params(Params& p) override {
    p("rows", rows, 1, 8, "of balls"), p("gravity", gravity, 0, 20, "m/s²"), p("friction", friction, 0, 1);
    p("restitution", restitution, 0, 1), p("speed", speed, 0, 50, "m/s, of the first shot");
    p("stroke", stroke, 0, 50, "m/s, of a shot by key");
  }
  void state(State& s) override {
    s("cue", cue), s("balls", balls), s("racked", racked), s("hit", hit), s("arrival", arrival), s("spin", spin),
        s("energy", energy), s("played", played);
  }
  void config(Config& c) override { c = thesis_config(); }

  Body add_ball(World& w, const Pos& at, std::string name) {
    return w.add({.shape = sphere(1),
                  .at = at,
                  .density = 1,
                  .material = {friction, friction, restitution},
                  .name = std::move(name)});
  }
  void build(World& w) override {
    add_floor(w, -1, gravity);
    const auto cushion = [&](const Pos& at, double yaw) {
      w.add({.shape = box({2, 2, 20}), .at = at, .turn = turned({0, 1, 0}, yaw), .motion = Motion::fixed});
    };
    for (double side : {-1.0, 1.0}) {
      cushion({12 * side, 0, -11.5}, 0), cushion({12 * side, 0, 11.5}, 0), cushion({0, 0, 25 * side}, 90);
    }
    cue = add_ball(w, {0, 0, 12}, "cue");
    for (int row = 1; row <= rows; ++row) {
      for (int i = 1; i <= row; ++i) {
        racked.push_back({(i - 1) * 2.0 - (row - 1), 0, -2.0 * row - 7});
        balls.push_back(add_ball(w, racked.back(), ""));
      }
    }
    w.set_velocity(cue, {0, 0, -speed}, {});
    energy = w.energy().kinetic;
  }
  void control(World& w, const Input& in) override {
    if (!in.pressed("up")) return;
    const Vec3 along = normalize(Vec3{in.view.x, 0, in.view.z});
    w.set_velocity(cue, w[cue].velocity() + along * stroke, w[cue].spin());
    energy = w.energy().kinetic;
    played = true;
  }

  void observe(const World& w, Check& c) override {
    for (Body ball : balls) {
      if (hit < 0 && w.touching(cue, ball)) hit = w.time() - w.config().dt;
    }
    if (hit < 0) arrival = length(w[cue].velocity()), spin = length(w[cue].spin());
    c.below("kinetic energy / that of the shot", energy > 0 ? w.energy().kinetic / energy : 0, 1.0001);
  }
  void check(const World& w, Check& c) override {
    if (played) return;
    // The cue ball slides 19 m, from z = 12 to a ball's width before −9: v² = v₀² − 2 μ g · 19.
    const double braking = friction * gravity, exact = sqrt(square(double(speed)) - 2 * braking * 19);
    c.near("the cue ball hits", hit, (speed - exact) / braking, 0.02, "s");
    c.near("its speed then", arrival, exact, 0.001 * exact, "m/s");
    const double wound = 2.5 * (speed - exact);  // 5/2 μ g t, as (speed − exact) = μ g t
    c.near("its spin then", spin, wound, 0.01 * wound, "rad/s");
    int moved = 0;
    for (std::size_t i = 0; i < balls.size(); ++i) moved += horizontal_distance(w[balls[i]].center(), racked[i]) > 0.5;
    c.above("balls that moved", moved, 0.5 * double(balls.size()));
  }
  std::vector<KeyHelp> keys() const override { return {{"up", "shoot the cue ball along the view"}}; }
  std::optional<Camera> camera() const override { return Camera{{24, 46, 42}, {0, 0, 2}}; }
};
SUDAR_SCENARIO(Billiards, "Impacts/Billiards")
