// A stool is one body of four shapes. A weight stands on its seat, off the middle: each of the three legs carries what
// the lever rule says, and beyond the line through two of them the stool tips.
#include "thesis.h"

#include <algorithm>

using namespace sudar;

struct Stool : Scenario {
  static constexpr double seconds = 4;
  static constexpr double picture = 1;
  static constexpr const char* about = "a body of four shapes carries a weight on three legs";
  static constexpr double height = 0.5, seat = 0.05, spread = 0.2, edge = 0.1;  // m; spread: of the feet from the middle
  static constexpr double round = 0.02;  // radius of the legs, m: each stands on one point, so that its load is determined
  Real gravity = Real(9.81), weight = 20, x = Real(0.06), z = Real(-0.04);
  Body stool, load, floor;
  double carried[3] = {};  // by leg, N, in the last step

  void params(Params& p) override {
    p("gravity", gravity, 0, 20, "m/s²"), p("weight", weight, 1, 100, "kg");
    p("x", x, -0.2, 0.2, "m, where the weight stands"), p("z", z, -0.2, 0.2, "m");
  }
  void state(State& s) override { s("stool", stool), s("load", load), s("floor", floor), s("carried", carried); }

  static Vec3d foot(int leg) { return {spread * sudar::sin(2 * pi * leg / 3), 0, spread * sudar::cos(2 * pi * leg / 3)}; }

  void build(World& w) override {
    floor = add_floor(w, 0, gravity);
    BodyDef def{.shapes = {{.shape = cylinder(0.25, seat), .at = {0, Real(height - seat / 2), 0}}},
                .density = 600,
                .name = "stool"};
    for (int leg = 0; leg < 3; ++leg) {
      const Vec3d f = foot(leg);
      def.shapes.push_back({.shape = capsule(round, height - seat - 2 * round), .at = {Real(f.x), Real((height - seat) / 2), Real(f.z)}});
    }
    stool = w.add(def);
    load = w.add({.shape = box({edge, edge, edge}), .at = {x, height + edge / 2, z}, .mass = weight, .name = "weight"});
  }

  void observe(const World& w, Check&) override {
    const std::vector<ShapeId> shapes = w[stool].shapes();
    std::fill(carried, carried + 3, 0);
    const double per_second = w.config().substeps / w.config().dt;
    for (const Contact& c : w.contacts()) {
      if (c.a != floor && c.b != floor) continue;
      const auto leg = std::find(shapes.begin(), shapes.end(), c.a == floor ? c.shape_b : c.shape_a) - shapes.begin() - 1;
      for (int k = 0; leg >= 0 && leg < 3 && k < c.count; ++k) carried[leg] += per_second * c.points[std::size_t(k)].normal_impulse;
    }
  }
  // The share of what stands at (x, z): barycentric coordinates in the triangle of the feet.
  double share(int leg) const {
    const Vec3d f = foot(leg);
    return 1.0 / 3 + 2.0 / 3 * (x * f.x + z * f.z) / square(spread);
  }
  void check(const World& w, Check& c) override {
    for (int leg = 0; leg < 3; ++leg) {
      const double exact = gravity * (w[stool].mass() / 3 + weight * share(leg));
      c.near("leg " + std::to_string(leg + 1) + " carries", carried[leg], exact, 0.01 * exact, "N");
    }
    c.near("the weight stands at", w[load].pose().p.y, height + edge / 2, 0.02, "m");
  }
  std::optional<Camera> camera() const override { return Camera{{1, 0.9, 1.3}, {0, 0.3, 0}}; }
};
SUDAR_SCENARIO(Stool, "Stacking/Stool")
