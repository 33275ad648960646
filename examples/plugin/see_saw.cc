// A board on a hinge with two weights: it comes to rest on the side of the greater moment, mass times arm.
#include <sudar/scenario.h>

using namespace sudar;

struct SeeSaw : Scenario {
  static constexpr double seconds = 4;
  static constexpr double picture = 0.2;
  static constexpr const char* about = "two weights on a board: which side goes down?";
  double left = 30, right = 20;  // kg
  Body board;

  void params(Params& p) override {
    p("left", left, 1, 100, "kg, 1 m from the hinge"), p("right", right, 1, 100, "kg, 2 m from it");
  }
  void state(State& s) override { s("board", board); }
  void build(World& w) override {
    w.add(Gravity{});
    w.add({.shape = half_space(), .motion = Motion::fixed});
    board = w.add({.shape = box({5, Real(0.1), 1}), .at = {0, 1, 0}, .name = "board"});
    w.join(Hinge{.b = board, .at = {0, 1, 0}});
    const auto weight = [&](double mass, double x) {
      const Real edge = Real(0.4);
      w.add({.shape = box({edge, edge, edge}),
             .at = {x, 1.05 + edge / 2, 0},
             .mass = Real(mass),
             .material = {.friction_static = 2, .friction_dynamic = 2}});
    };
    weight(left, -1), weight(right, 2);
  }
  void check(const World& w, Check& c) override {
    const Vec3 along = rotate(w[board].pose().q, Vec3{1, 0, 0});
    const double moment = 2 * right - left;  // positive: clockwise, the right side goes down
    if (moment != 0) c.below("rise of the heavier side", moment > 0 ? along.y : -along.y, -0.3);
  }
};
SUDAR_SCENARIO(SeeSaw, "Examples/See-saw")
