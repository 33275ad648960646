// thesis fig. 10: a vehicle that the user drives over ramps, a bridge of hinged planks, a seesaw, cones and stairs. It
// steers like a tank: a side's two wheels are coupled by bars, and the two sides are driven apart.
#include "thesis.h"

using namespace sudar;

struct Vehicle : Scenario {
  static constexpr double seconds = 22;
  static constexpr double picture = 3;
  static constexpr const char* about = "a vehicle to drive, with ramps and a bridge (thesis, fig. 10)";
  enum Driver { by_keys, over_the_bridge, in_circles };
  int driver = by_keys;
  Real gravity = 5, torque = 23.4, steering = 1.5, friction_static = 0.6, friction_dynamic = 0.5;
  Body seesaw, chassis, wheels[4];  // left (+z) front and back, right front and back; front is −x
  bool touched = false;             // a key was pressed
  double parked_x = 0;              // where it stood after 5 s, m
  double low_z = 0, high_z = 0;     // the way across, m
  double low_x = 0, high_x = 0;     // and along, m
  double turned_left = 0;           // rad

  void params(Params& p) override {
    p("driver", driver, 0, 2, "0: the keys, 1: over the bridge, 2: in circles");
    p("gravity", gravity, 0, 20, "m/s²"), p("torque", torque, 0, 100, "N·m per wheel and kg of it");
    p("steering", steering, 0, 5, "weight of left and right against up and down");
    p("friction_static", friction_static, 0, 2, "of the wheels"), p("friction_dynamic", friction_dynamic, 0, 2);
  }
  void state(State& s) override {
    s("seesaw", seesaw), s("chassis", chassis), s("wheels", wheels), s("touched", touched);
    s("parked_x", parked_x), s("low_x", low_x), s("high_x", high_x), s("low_z", low_z), s("high_z", high_z);
    s("turned_left", turned_left);
  }
  void config(Config& c) override { c = thesis_config(10, 20); }

  void build(World& w) override {
    add_floor(w, 0, gravity);
    add_vehicle(w);
    add_ramps(w);
    add_bridge(w);
    add_seesaw(w);
    constexpr double cones[6][2] = {{100, -80}, {100, 0}, {100, 80}, {170, -40}, {170, 40}, {240, 0}};
    for (const auto& at : cones) add_fixed(w, pyramid(12, 40, 10), {at[0], 2.5, at[1]});
    for (int i = 0; i < 5; ++i) add_fixed(w, box({200, 2, 100}), {30.0 * i, 1 + 2.0 * i, -200});
  }
  static Body add_fixed(World& w, const Shape& shape, const Pos& at, const Quat& turn = {}) {
    return w.add({.shape = shape, .at = at, .turn = turn, .material = ground, .motion = Motion::fixed});
  }

  void add_vehicle(World& w) {
    const Material tyre{friction_static, friction_dynamic, Real(0.1)};
    chassis = w.add({.shape = box({20, 4, 15}),
                     .at = {0, 9, 0},
                     .density = 0.5,
                     .material = {Real(0.6), Real(0.4), Real(0.5)},
                     .name = "chassis"});
    // Turned by half a side, so that a wheel stands on a face: on an edge the parked car would roll off.
    const Quat upright = turned({0, 0, 1}, 7.5) * turned({1, 0, 0}, 90);
    constexpr const char* names[] = {"left front wheel", "left back wheel", "right front wheel", "right back wheel"};
    for (int i = 0; i < 4; ++i) {
      const Pos at{i % 2 == 0 ? -7.5 : 7.5, 9, i < 2 ? 10.6 : -10.6};
      wheels[i] = w.add(
          {.shape = prism(24, 6, 6), .at = at, .turn = upright, .density = 1, .material = tyre, .name = names[i]});
      w.join(Hinge{.a = chassis, .b = wheels[i], .at = at});
      if (i % 2 == 0) continue;
      for (double y : {-6.0, 6.0}) {
        const Pos front{-7.5, 9 + y, at.z}, back{7.5, 9 + y, at.z};
        w.join(Bar{.a = wheels[i - 1], .b = wheels[i], .at_a = front, .at_b = back});
      }
    }
  }
  void add_ramps(World& w) {
    const Shape ramp = wedge({200, 30, 100});
    add_fixed(w, ramp, {-226.7 + 200.0 / 3, 10, 0});
    add_fixed(w, ramp, {-351.3 - 200.0 / 3, 10, 0}, turned({0, 1, 0}, 180));
  }
  void add_bridge(World& w) {
    Body before;
    for (int i = 0; i <= 10; ++i) {
      const double x = (i - 5) * 12.0 - 283;
      Body plank;
      if (i < 10) plank = add_box(w, {10, 2, 80}, {x, 30, 0}, ground);
      w.join(Hinge{.a = before, .b = plank, .at = {x - 6, 30, 0}});
      before = plank;
    }
  }
  void add_seesaw(World& w) {
    const Vec3 outline[] = {{0, 0, 0}, {100, 20, 0}, {-100, 20, 0}};
    const Pos pivot{10, 0, 150};
    seesaw = w.add({.shape = prism(outline, 60),
                    .at = pivot,
                    .turn = turned({0, 1, 0}, 90),
                    .spin = {-0.05, 0, 0},  // it comes down on the vehicle's side
                    .density = 0.1,
                    .material = ground,
                    .name = "seesaw"});
    w.join(Hinge{.b = seesaw, .at = pivot, .axis = {1, 0, 0}});
  }

  // Up and down drive both sides, left and right one side forward and the other one back; both together blend.
  void control(World& w, const Input& in) override {
    double ahead = in.held("up") - in.held("down"), left = in.held("left") - in.held("right");
    touched = touched || ahead != 0 || left != 0;
    if (!touched && driver != by_keys) ahead = 1, left = driver == in_circles ? 1 : steer(w);
    for (int i = 0; i < 4; ++i) {
      const Real share = Real(clamp(i < 2 ? ahead - steering * left : ahead + steering * left, -1.0, 1.0));
      if (share != 0) w.twist(wheels[i], axle(w) * (share * torque * w[wheels[i]].mass()));
    }
  }
  Vec3 axle(const World& w) const { return rotate(w[chassis].pose().q, Vec3{0, 0, 1}); }
  // Keeps the heading as short strokes of the keys do on average: towards −x, on the line z = 0.
  double steer(const World& w) const {
    const double off = -axle(w).x - 0.004 * w[chassis].center().z, turning = w[chassis].spin().y;
    return clamp(0.7 * (off - turning), -0.3, 0.3);
  }

  // How far front and back wheels of a side are from turning alike, rad.
  double out_of_phase(const World& w) const {
    double worst = 0;
    for (int i : {0, 2}) {
      const Quat between = conjugate(w[wheels[i]].pose().q) * w[wheels[i + 1]].pose().q;
      worst = max(worst, double(length(rotation_vector(between))));
    }
    return worst;
  }
  void observe(const World& w, Check& c) override {
    const Pos p = w[chassis].center();
    if (w.time() < 5.005) parked_x = p.x;
    low_x = min(low_x, p.x), high_x = max(high_x, p.x), low_z = min(low_z, p.z), high_z = max(high_z, p.z);
    turned_left += double(w[chassis].spin().y) * w.config().dt;
    if (touched) return;
    if (driver == by_keys) c.between(5, 20).below("movement of the parked vehicle", abs(p.x - parked_x), 0.05, "m");
    if (driver != by_keys) c.below("front and back wheels out of phase", out_of_phase(w), 0.1, "rad");
    if (driver == over_the_bridge) {
      c.at(10).near("x after 10 s, on the ramp", p.x, -89, 5, "m");
      c.at(16).near("x after 16 s", p.x, -215, 10, "m");
      c.at(20).near("x after 20 s, on the bridge", p.x, -315, 15, "m");
      c.at(22).below("x after 22 s, over the bridge", p.x, -351, "m");
    }
  }
  void check(const World& w, Check& c) override {
    if (touched) return;
    if (driver == by_keys) {
      const double rise = abs(rotate(w[seesaw].pose().q, Vec3{1, 0, 0}).y);
      c.near("tilt of the seesaw", sudar::asin(rise) * 180 / pi, sudar::atan2(20.0, 100.0) * 180 / pi, 0.1, "degrees");
    }
    if (driver != in_circles) return;
    c.above("way turned", turned_left, 2 * pi, "rad");
    c.below("turning circle", max(high_x - low_x, high_z - low_z), 60, "m");
  }
  std::vector<KeyHelp> keys() const override {
    return {{"up", "drive forward"}, {"down", "drive back"}, {"left", "turn left"}, {"right", "turn right"}};
  }
  std::optional<Camera> camera() const override { return Camera{{140, 115, 215}, {-65, 0, 5}}; }
};
SUDAR_SCENARIO(Vehicle, "Machines/Vehicle")
