// Balls that slide without friction down a trough whose section is a cycloid reach its bottom at the same time, wherever
// they start (C. Huygens, Horologium Oscillatorium, 1673). The trough is a mesh of narrow strips.
#include "thesis.h"

using namespace sudar;

struct Tautochrone : Scenario {
  static constexpr double seconds = 3;
  static constexpr double picture = 0.4;
  static constexpr const char* about = "three balls in a trough of triangles reach its bottom together";
  static constexpr double roll = 1, radius = 0.1;  // m: of the circle that makes the cycloid, of the balls
  static constexpr double widest = 2.2;            // angle of that circle at the trough's rims, rad
  Real gravity = Real(9.81);
  int strips = 400;
  Body balls[3];
  double reached[3] = {-1, -1, -1};  // the bottom, s

  void params(Params& p) override { p("gravity", gravity, 0, 20, "m/s²"), p("strips", strips, 10, 2000); }
  void state(State& s) override { s("balls", balls), s("reached", reached); }

  // Of a ball's centre, which is to move on the cycloid, and the unit vector from there away from the surface.
  static Vec3d place(double angle) { return {roll * (angle + sudar::sin(angle)), roll * (1 - sudar::cos(angle)), 0}; }
  static Vec3d inward(double angle) { return {-sudar::sin(angle / 2), sudar::cos(angle / 2), 0}; }

  Shape trough() const {
    std::vector<Vec3> vertices;
    std::vector<std::uint32_t> triangles;
    for (int i = 0; i <= strips; ++i) {
      const double angle = widest * (2.0 * i / strips - 1);
      const Vec3 p = convert<Real>(place(angle) - inward(angle) * radius);
      vertices.push_back({p.x, p.y, -1}), vertices.push_back({p.x, p.y, 1});
      if (i == 0) continue;
      const auto a = std::uint32_t(2 * i - 2);
      triangles.insert(triangles.end(), {a, a + 1, a + 3, a, a + 3, a + 2});
    }
    return mesh(vertices, triangles);
  }

  void build(World& w) override {
    w.add(Gravity{{0, -gravity, 0}});
    const Material smooth{.friction_static = 0, .friction_dynamic = 0};
    w.add({.shape = trough(), .material = smooth, .motion = Motion::fixed, .name = "trough"});
    for (int k = 0; k < 3; ++k) {
      const Vec3d p = place(-0.6 * (k + 1));
      balls[k] = w.add({.shape = sphere(radius), .at = {p.x, p.y, 0.6 * (k - 1)}, .material = smooth});
    }
  }

  void observe(const World& w, Check&) override {
    for (int k = 0; k < 3; ++k) {
      const double x = w[balls[k]].center().x, v = w[balls[k]].velocity().x;
      if (reached[k] < 0 && x >= 0) reached[k] = w.time() - x / v;
    }
  }
  void check(const World&, Check& c) override {
    // s = 4 r sin(θ/2) along the cycloid: s'' = −g s / 4r
    const double exact = pi * sqrt(roll / gravity);
    for (int k = 0; k < 3; ++k) {
      c.near("ball " + std::to_string(k + 1) + " is at the bottom after", reached[k], exact, 0.008 * exact, "s");
    }
  }
  std::optional<Camera> camera() const override { return Camera{{0.8, 3.2, 5.5}, {-0.4, 0.6, 0}}; }
};
SUDAR_SCENARIO(Tautochrone, "Motion/Tautochrone")
