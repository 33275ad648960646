// A bridge of hinged planks and a ball that falls on it. The taut chain of planks is exactly as long as its span:
// whatever it sags is joint error, and 2 mm in each joint are enough for 0.75 m. With slack it hangs in the arc that it
// is built in, nearly the catenary of its length.
#include "thesis.h"

using namespace sudar;

struct SuspensionBridge : Scenario {
  static constexpr double seconds = 20;
  static constexpr double picture = 5.2;
  static constexpr const char* about = "a ball falls on a bridge of hinged planks";
  static constexpr double pitch = 3;
  int count = 15;
  Real gravity = 4, bounce = 0.9, drop = 40;
  double slack = 0;
  std::vector<Body> planks;
  Body ball;
  double met = -1;  // when the ball met the bridge, s

  void params(Params& p) override {
    p("planks", count, 3, 60), p("slack", slack, 0, 10, "m, by which the planks are longer than the span");
    p("gravity", gravity, 0, 20, "m/s²"), p("bounce", bounce, 0, 1, "restitution of the ball"),
        p("drop", drop, 5, 100, "m, height of the ball");
  }
  void state(State& s) override { s("planks", planks), s("ball", ball), s("met", met); }
  void config(Config& c) override { c = thesis_config(); }

  // The angle between neighbours in an arc of `count` chords whose ends are nearer by the slack.
  double bend() const {
    const double span = count * pitch - slack;
    double low = 0, high = 2 * pi / count;
    for (int i = 0; i < 60; ++i) {
      const double middle = (low + high) / 2;
      const double reach = pitch * sudar::sin(count * middle / 2) / sudar::sin(middle / 2);
      (reach > span ? low : high) = middle;
    }
    return slack > 0 ? low : 0;
  }
  void build(World& w) override {
    add_floor(w, -14, gravity);
    add_drag(w);
    const double angle = bend();
    Pos end{-(count * pitch - slack) / 2, 0, 0};
    for (int i = 0; i <= count; ++i) {
      const double tilt = angle * (i - (count - 1) / 2.0);
      const Vec3d half = Vec3d{sudar::cos(tilt), sudar::sin(tilt), 0} * (pitch / 2);
      const Body before = planks.empty() ? Body{} : planks.back();
      if (i < count) {
        const Material material{Real(0.6), Real(0.4), 1};
        planks.push_back(add_box(w, {2.5, 0.5, 5}, end + half, material, turned({0, 0, 1}, tilt * 180 / pi)));
      }
      w.join(Hinge{.a = before, .b = i < count ? planks.back() : Body{}, .at = end});
      end = end + half + half;
    }
    ball = w.add({.shape = sphere(1),
                  .at = {-15, drop, 0},
                  .density = 1,
                  .material = {Real(0.1), Real(0.1), bounce},
                  .name = "ball"});
  }

  // How far the middle hangs below the ends.
  double sag(const World& w) const { return -w[planks[planks.size() / 2]].pose().p.y; }
  void observe(const World& w, Check& c) override {
    for (Body plank : planks) {
      if (met < 0 && w.touching(plank, ball)) met = w.time();
    }
    if (slack == 0 && met < 0) c.below("sag of the taut bridge", sag(w), 1, "m");
    c.below("joint gap", w.quality().joint_gap_max, 0.005, "m");
  }
  void check(const World& w, Check& c) override {
    c.above("the ball meets the bridge after", met, 0, "s");
    // The parabola of an arc whose length exceeds its chord c by s: √(3 s c / 8).
    const double parabola = sqrt(3 * slack * (count * pitch - slack) / 8);
    if (slack > 0) c.near("sag", sag(w), parabola, 0.1 * parabola, "m");
  }
  std::optional<Camera> camera() const override { return Camera{{-6, 14, 44}, {0, 1, 0}}; }
};
SUDAR_SCENARIO(SuspensionBridge, "Joints/Suspension bridge")
