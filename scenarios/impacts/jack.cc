// A jack, three capsules crossed at right angles, is one body that is not convex. Its inertia is the same about every
// axis, so that its spin does not change while it flies; it comes to rest on three of its six feet.
#include "thesis.h"

using namespace sudar;

struct Jack : Scenario {
  static constexpr double seconds = 8;
  static constexpr double picture = 8;
  static constexpr const char* about = "three crossed capsules are thrown, tumble and rest on three feet";
  static constexpr double arm = 0.5, radius = 0.1, high = 4;  // m, from the centre to that of a foot
  Real gravity = Real(9.81), friction = Real(0.5), restitution = Real(0.3), spin = 6;
  Body jack, floor;
  bool flies = true;
  Vec3 thrown{};  // its spin at the start, rad/s

  void params(Params& p) override {
    p("gravity", gravity, 0, 20, "m/s²"), p("friction", friction, 0, 2), p("restitution", restitution, 0, 1);
    p("spin", spin, 0, 30, "rad/s");
  }
  void state(State& s) override { s("jack", jack), s("floor", floor), s("flies", flies), s("thrown", thrown); }

  void build(World& w) override {
    floor = add_floor(w, 0, gravity);
    const Shape bar = capsule(radius, 2 * arm);
    thrown = normalize(Vec3{3, 5, 1}) * spin;
    jack = w.add({.shapes = {{.shape = bar}, {.shape = bar, .turn = turned({0, 0, 1}, 90)}, {.shape = bar, .turn = turned({1, 0, 0}, 90)}},
                  .at = {0, high, 0},
                  .turn = turned({0, 0, 1}, 20),
                  .velocity = {1, 0, 0.5},
                  .spin = thrown,
                  .material = {.friction_static = friction, .friction_dynamic = friction, .restitution = restitution},
                  .name = "jack"});
  }

  void observe(const World& w, Check& c) override {
    flies = flies && w.events().begun.empty();
    if (!flies) return;
    c.below("spin gained or lost in flight", length(w[jack].spin() - thrown), 1e-3, "rad/s");
    c.below("off the parabola in flight", abs(w[jack].center().y - (high - gravity / 2 * square(w.time()))), 0.03, "m");
  }
  void check(const World& w, Check& c) override {
    // Three feet on orthogonal arms span a plane arm/√3 from the centre.
    c.near("its centre rests at", w[jack].center().y, arm / sqrt(3.0) + radius, 0.011, "m");
    c.near("feet on the floor", double(w.contacts().size()), 3, 0);
    c.below("speed at the end", length(w[jack].velocity()), 1e-3, "m/s");
  }
  std::optional<Camera> camera() const override { return Camera{{2.8, 1.6, 0.6}, {0.6, 0.5, -1.6}}; }
};
SUDAR_SCENARIO(Jack, "Impacts/Jack")
