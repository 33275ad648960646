// thesis fig. 6: static friction. The foot of a falling stick holds, or slips at once, or lets go on the way.
#include "thesis.h"

using namespace sudar;

struct Sticks : Scenario {
  static constexpr double seconds = 10;
  static constexpr double picture = 2.6;
  static constexpr const char* about = "eleven falling sticks, from smooth to rough (thesis, fig. 6)";
  static constexpr int count = 11;
  Real gravity = 5, friction_step = 0.1, friction_dynamic = 0, tilt = 60;
  Body floor;
  std::vector<Body> sticks;
  std::vector<double> landed;    // where the foot came down, m; −1000: not yet
  std::vector<double> released;  // the angle of the stick when its foot slipped, degrees; −1000: not yet

  void params(Params& p) override {
    p("gravity", gravity, 0, 20, "m/s²"), p("tilt", tilt, 10, 80, "degrees");
    p("friction_step", friction_step, 0, 1, "static, from a stick to the next"),
        p("friction_dynamic", friction_dynamic, 0, 1);
  }
  void state(State& s) override {
    s("floor", floor), s("sticks", sticks), s("landed", landed), s("released", released);
  }
  void config(Config& c) override { c = thesis_config(); }

  void build(World& w) override {
    floor = add_floor(w, -15, gravity);
    for (int i = 0; i < count; ++i) {
      const Material material{friction_step * Real(i), friction_dynamic};
      sticks.push_back(add_box(w, {30, 1, 1}, {0, 0, (i - 3) * 5.0}, material, turned({0, 0, 1}, tilt)));
    }
    landed.assign(count, -1000), released.assign(count, -1000);
  }

  void observe(const World& w, Check&) override {
    for (std::size_t i = 0; i < sticks.size(); ++i) {
      const Pose pose = w[sticks[i]].pose();
      const double foot = pose.point({-15, -0.5, 0}).x;
      if (landed[i] == -1000 && w.touching(sticks[i], floor)) landed[i] = foot;
      if (landed[i] != -1000 && released[i] == -1000 && abs(foot - landed[i]) > 0.05) {
        const Vec3 along = rotate(pose.q, Vec3{1, 0, 0});
        released[i] = sudar::atan2(double(along.y), double(along.x)) * 180 / pi;
      }
    }
  }
  void check(const World& w, Check& c) override {
    for (int i = 0; i < count; ++i) {
      const std::string name = "stick " + std::to_string(i);
      const double x = w[sticks[std::size_t(i)]].pose().p.x, angle = released[std::size_t(i)];
      if (i < 4) {
        c.near(name + ": its foot slips at impact, at", angle, tilt, 2, "degrees");
        const Vec3 off = w[sticks[std::size_t(i)]].pose().p - Pos{0, -14.5, (i - 3) * 5.0};
        c.below(name + ": comes down on the spot, off by", length(off), 0.5, "m");
      } else if (i == 4) {
        c.near(name + ": its foot lets go at", angle, 52, 3, "degrees");
        c.near(name + ": slides a way, x", x, 5.5, 1.5, "m");
      } else {
        c.near(name + ": its foot holds to", angle, 21, 3, "degrees");
        c.near(name + ": slides forward, x", x, 9, 0.5, "m");
      }
    }
  }
  std::optional<Camera> camera() const override { return Camera{{-36, 12, 64}, {0, -7, 8}}; }
};
SUDAR_SCENARIO(Sticks, "Friction/Sticks")
