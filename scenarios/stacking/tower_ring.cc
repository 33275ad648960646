// A round tower of thirty courses, six bricks each, that narrows towards its top.
#include "thesis.h"

using namespace sudar;

struct TowerRing : Scenario {
  static constexpr double seconds = 10;
  static constexpr double picture = 10;
  static constexpr const char* about = "a round tower of 180 bricks";
  int courses = 30, bricks = 6;
  Real gravity = 5, friction = 0.4, restitution = 0.1;
  std::vector<Body> tower;  // course by course

  void params(Params& p) override {
    p("courses", courses, 1, 60), p("bricks", bricks, 4, 12, "in a course"), p("gravity", gravity, 0, 20, "m/s²");
    p("friction", friction, 0, 2), p("restitution", restitution, 0, 1);
  }
  void state(State& s) override { s("tower", tower); }
  void config(Config& c) override { c = thesis_config(); }

  double scale(int course) const { return 10.0 / (course + 15); }
  Pos place(int brick) const {
    const int course = brick / bricks;
    const double angle = (brick % bricks + 0.5 * (course % 2)) * 2 * pi / bricks, radius = 30 * scale(course);
    return {radius * sudar::cos(angle), 6.5 * course, radius * sudar::sin(angle)};
  }
  void build(World& w) override {
    w.add(Gravity{{0, -gravity, 0}});
    w.add({.shape = box({60, 2, 60}), .at = {0, -4.25, 0}, .material = ground, .motion = Motion::fixed});
    for (int i = 0; i < courses * bricks; ++i) {
      const int course = i / bricks;
      const Real f = Real(scale(course));
      const double angle = (i % bricks + 0.5 * (course % 2)) * 360 / bricks;
      tower.push_back(add_box(w, {25 * f, Real(6.5), 12 * f}, place(i), {friction, friction, restitution},
                              turned({0, 1, 0}, 90 - angle)));
    }
  }

  void check(const World& w, Check& c) override {
    double drift = 0, sink = 0;
    for (std::size_t i = 0; i < tower.size(); ++i) {
      const Pos p = w[tower[i]].pose().p;
      drift = max(drift, horizontal_distance(p, place(int(i))));
      sink = max(sink, place(int(i)).y - p.y);
    }
    c.below("largest drift of a brick", drift, 0.1, "m");
    c.below("sinking of the top", sink, double(courses) * w.config().impulse_2007.slop, "m");
  }
  std::optional<Camera> camera() const override { return Camera{{150, 125, 330}, {0, 94, 0}}; }
};
SUDAR_SCENARIO(TowerRing, "Stacking/Tower of rings")
