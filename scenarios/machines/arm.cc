// An arm of three links on hinges, held and moved by three muscles: servos that drive the distance between two points
// with at most 200 N.
#include "thesis.h"

using namespace sudar;

struct Arm : Scenario {
  static constexpr double seconds = 10;
  static constexpr double picture = 5;
  static constexpr const char* about = "an arm with three muscles and a box to push";
  Real gravity = 1, force = 200, step = 0.25;
  Body links[3];  // upper arm, forearm, hand
  Joint hinges[3], muscles[3];
  bool touched = false;  // a key was pressed

  void params(Params& p) override {
    p("gravity", gravity, 0, 20, "m/s²"), p("force", force, 0, 2000, "N, of a muscle at most");
    p("step", step, 0, 2, "m, by which a key changes a muscle");
  }
  void state(State& s) override {
    s("links", links), s("hinges", hinges), s("muscles", muscles), s("touched", touched);
  }
  void config(Config& c) override { c = thesis_config(); }

  void build(World& w) override {
    add_floor(w, -8, gravity);
    add_drag(w);
    const Material material{Real(0.6), Real(0.4), Real(0.5)};
    const Body torso =
        w.add({.shape = box({5, 3, 5}), .at = {0, -6.5, 0}, .density = 5, .material = material, .name = "torso"});
    links[0] = add_box(w, {10, 1, 1}, {5.5, -4, 0}, material);
    links[1] = add_box(w, {10, 1, 1}, {16.5, -4, 0}, material);
    links[2] = add_box(w, {3, 0.25, 3}, {24, -4, 0}, material);
    w.add({.shape = box({2, 2, 2}), .at = {16, -7, 0}, .density = 0.5, .material = material, .name = "load"});
    const Pos ends[] = {{2.5, -6.5, 0}, {5.5, -5, 0}, {16.5, -5, 0}, {24, -5, 0}};
    for (int i = 0; i < 3; ++i) {
      const Body before = i == 0 ? torso : links[i - 1];
      hinges[i] = w.join(Hinge{.a = before, .b = links[i], .at = {11.0 * i, -4, 0}});
      muscles[i] = w.join(Muscle{.a = before, .b = links[i], .at_a = ends[i], .at_b = ends[i + 1]});
      w.set_drive(muscles[i], {DriveMode::servo, w[muscles[i]].coordinate(), force, 1});
    }
  }

  static constexpr const char* longer[] = {"q", "w", "e"};
  static constexpr const char* shorter[] = {"a", "s", "d"};
  Drive drive_of(const World& w, int i) const { return std::get<Muscle>(w[muscles[i]].definition()).drive; }
  void control(World& w, const Input& in) override {
    for (int i = 0; i < 3; ++i) {
      const int change = int(in.pressed(longer[i])) - int(in.pressed(shorter[i]));
      if (change == 0) continue;
      touched = true;
      Drive drive = drive_of(w, i);
      drive.target += step * Real(change);
      w.set_drive(muscles[i], drive);
    }
  }

  // By the law of the lever about the shoulder's hinge, where the arm is now.
  double expected_force(const World& w) const {
    const Pos hinge = w[hinges[0]].anchor_a(), from = w[muscles[0]].anchor_a(), to = w[muscles[0]].anchor_b();
    const Vec3 along = normalize(to - from);
    double torque = 0;
    for (Body b : links) torque += w[b].mass() * gravity * (w[b].center().x - hinge.x);
    return torque / length(cross(from - hinge, along));
  }
  void observe(const World& w, Check& c) override { c.below("joint gap", w.quality().joint_gap_max, 1e-5, "m"); }
  void check(const World& w, Check& c) override {
    if (touched) return;  // it may swing still, or be told what it cannot reach
    c.near("force of the shoulder's muscle", length(w[muscles[0]].load().force), expected_force(w), 5, "N");
    for (int i = 0; i < 3; ++i) {
      const double off = abs(w[muscles[i]].coordinate() - drive_of(w, i).target);
      c.below("muscle " + std::to_string(i + 1) + ": off its length", off, 0.01, "m");
    }
  }
  std::vector<KeyHelp> keys() const override {
    return {{"q", "lengthen the shoulder's muscle: raise the arm"},
            {"a", "shorten it"},
            {"w", "lengthen the elbow's muscle"},
            {"s", "shorten it"},
            {"e", "lengthen the wrist's muscle"},
            {"d", "shorten it"}};
  }
  std::optional<Camera> camera() const override { return Camera{{18, 4, 40}, {12, -1.5, 0}}; }
};
SUDAR_SCENARIO(Arm, "Machines/Arm")
