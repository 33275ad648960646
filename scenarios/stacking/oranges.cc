// Oranges are poured into a box, one every 2.5 s. The solver gets five passes a step: a heap needs no more.
#include "thesis.h"

using namespace sudar;

struct Oranges : Scenario {
  static constexpr double seconds = 60;
  static constexpr double picture = 59;
  static constexpr const char* about = "oranges are poured into a box";
  static constexpr double radius = 2;
  Real gravity = 4, friction = 0.5;
  double side = 8, pause = 2.5;
  Body floor;
  std::vector<Body> oranges;

  void params(Params& p) override {
    p("gravity", gravity, 0, 20, "m/s²"), p("friction", friction, 0, 2), p("side", side, 4, 30, "m, half of the box");
    p("pause", pause, 0.2, 10, "s, between two oranges");
  }
  void state(State& s) override { s("floor", floor), s("oranges", oranges); }
  void config(Config& c) override { c = thesis_config(5, 5); }

  void build(World& w) override {
    floor = add_floor(w, -4, gravity);
    for (double s : {-1.0, 1.0}) {
      add_wall(w, {2, 12, Real(2 * side + 4)}, {(side + 1) * s, 2, 0});
      add_wall(w, {Real(2 * side), 12, 2}, {0, 2, (side + 1) * s});
    }
  }
  void add_wall(World& w, const Vec3& edges, const Pos& at) {
    w.add({.shape = box(edges), .at = at, .material = ground, .motion = Motion::fixed});
  }
  // Somewhere within ±2.5 of the middle: the two fractional parts fill the square evenly (M. Roberts, 2018).
  void drop(World& w) {
    const double n = double(oranges.size()) + 0.5, x = n * 0.7548776662466927, z = n * 0.5698402909980532;
    oranges.push_back(w.add({.shape = sphere(radius),
                             .at = {5 * (x - std::floor(x)) - 2.5, 40, 5 * (z - std::floor(z)) - 2.5},
                             .density = 1,
                             .material = {friction, friction},
                             .name = "orange " + std::to_string(oranges.size() + 1)}));
  }
  void control(World& w, const Input& in) override {
    const double due = double(oranges.size() + 1) * pause;
    if (in.pressed("space") || w.time() + 1.5 * w.config().dt > due) drop(w);
  }
  void observe(const World& w, Check& c) override { c.below("overlap", w.quality().penetration_max, 0.2, "m"); }
  void check(const World& w, Check& c) override {
    double caught = 0;
    for (Body orange : oranges) {
      const Pos p = w[orange].center();
      caught += max(abs(p.x), abs(p.z)) < side && p.y > -4;
    }
    c.near("oranges in the box or above it", caught, std::floor(w.time() / pause + 1e-9), 0);
  }
  std::vector<KeyHelp> keys() const override { return {{"space", "one more orange"}}; }
  std::optional<Camera> camera() const override { return Camera{{12, 42, 24}, {0, -1, 0}}; }
};
SUDAR_SCENARIO(Oranges, "Stacking/Oranges")
