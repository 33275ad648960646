// A top on its tip, started as it must be to go round steadily: tilt θ and spin ω₃ about its own axis give the speed Ω
// of that precession by I₁ cos θ Ω² − I₃ ω₃ Ω + m g l = 0 (the slow root).
#include "thesis.h"

using namespace sudar;

struct Gyroscope : Scenario {
  static constexpr double seconds = 20;
  static constexpr double picture = 4;
  static constexpr const char* about = "a top on its tip goes round steadily";
  static constexpr double height = 2.5, radius = 1.5;
  Real gravity = 9.81, spin = 40, tilt = 25;
  Body top;
  double angle = 0, heading = 0, precession = 0;  // gone round so far, where it leans now, rad; expected, rad/s

  void params(Params& p) override {
    p("gravity", gravity, 0, 20, "m/s²"), p("spin", spin, 0, 60, "rad/s, about its own axis"),
        p("tilt", tilt, 1, 80, "degrees");
  }
  void state(State& s) override {
    s("top", top), s("angle", angle), s("heading", heading), s("precession", precession);
  }
  void config(Config& c) override {
    c = thesis_config();
    c.substeps = 4;  // 40 rad/s turn by 0.4 rad in 0.01 s
  }

  // The slow root; where the spin does not carry the top, 0: it falls.
  double steady_precession(double mass, double lift, const Mat3& inertia) const {
    const double i1 = inertia.c0.x + mass * square(lift), i3 = inertia.c1.y, weight = mass * gravity * lift;
    const double l = i3 * spin, a = i1 * sudar::cos(tilt * pi / 180);
    const double under_root = square(l) - 4 * a * weight;
    return under_root > 0 ? 2 * weight / (l + sqrt(under_root)) : 0;
  }
  void build(World& w) override {
    add_floor(w, -2, gravity);
    const Body stand = w.add({.shape = cone(1, 2, 32), .at = {0, -1.5, 0}, .motion = Motion::fixed, .name = "stand"});
    const double lift = 0.75 * height;  // centre of mass above the tip
    top = w.add({.shape = cone(Real(radius), Real(height), 32), .at = {0, lift, 0}, .density = 1, .sleeps = false});
    precession = steady_precession(w[top].mass(), lift, w[top].inertia());
    const Quat lean = turned({0, 0, 1}, -double(tilt));
    const Vec3 axis = rotate(lean, Vec3{0, 1, 0});
    w.place(top, {Pos{} + axis * Real(lift), lean * turned({1, 0, 0}, 180)});
    const Vec3 turning = Vec3{0, Real(precession), 0} + axis * (spin - Real(precession) * axis.y);
    w.set_velocity(top, cross(turning, axis * Real(lift)), turning);
    w.join(Ball{.a = stand, .b = top, .at = {0, 0, 0}});
  }

  void observe(const World& w, Check& c) override {
    const Vec3 axis = rotate(w[top].pose().q, Vec3{0, -1, 0});
    const double now = sudar::atan2(-double(axis.z), double(axis.x)), off = now - heading;
    angle += off - 2 * pi * std::round(off / (2 * pi));
    heading = now;
    if (precession == 0) return;
    c.near("tilt", sudar::acos(min(double(axis.y), 1.0)) * 180 / pi, tilt, 0.5, "degrees");
    c.below("joint gap", w.quality().joint_gap_max, 1e-3, "m");
  }
  void check(const World& w, Check& c) override {
    const double exact = precession * w.time();
    if (precession > 0) c.near("gone round", angle, exact, 0.01 * exact, "rad");
  }
  std::optional<Camera> camera() const override { return Camera{{4, 4, 9}, {0, 0.3, 0}}; }
};
SUDAR_SCENARIO(Gyroscope, "Motion/Gyroscope")
