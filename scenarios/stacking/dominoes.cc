// thesis fig. 11: dominoes in a row, round a half circle and back.
#include "thesis.h"

using namespace sudar;

struct Dominoes : Scenario {
  static constexpr double seconds = 60;
  static constexpr double picture = 25;
  static constexpr const char* about = "29 dominoes fall one after the other (thesis, fig. 11)";
  int straight = 10, curved = 9;
  Real gravity = 2, friction = 0.5, speed = 7;
  double pitch = 3.5;
  std::vector<Body> dominoes;  // in the order in which they fall
  std::vector<double> fell;    // when, s; −1: stands

  void params(Params& p) override {
    p("straight", straight, 1, 50, "in each row"), p("curved", curved, 2, 20, "on the half circle");
    p("gravity", gravity, 0, 20, "m/s²"), p("friction", friction, 0, 10),
        p("speed", speed, 0, 50, "m/s, of the striker");
    p("pitch", pitch, 1.5, 10, "m");
  }
  void state(State& s) override { s("dominoes", dominoes), s("fell", fell); }
  void config(Config& c) override { c = thesis_config(); }

  void add(World& w, double x, double z, double yaw) {
    dominoes.push_back(add_box(w, {1, 5, 2.5}, {x, -0.5, z}, {friction, friction}, turned({0, 1, 0}, yaw)));
    fell.push_back(-1);
  }
  void build(World& w) override {
    add_floor(w, -3, gravity);
    add_drag(w);
    for (int i = straight - 1; i >= 0; --i) add(w, -11.5 + pitch * i, 8, 0);
    for (int i = 0; i < curved; ++i) {
      const double angle = i * pi / (curved - 1);
      add(w, -15 - 8 * sudar::sin(angle), 8 * sudar::cos(angle), -angle * 180 / pi);
    }
    for (int i = 0; i < straight; ++i) add(w, -11.5 + pitch * i, -8, 0);
    w.add({.shape = box({0.5, 0.5, 0.5}),
           .at = {-7.5 + pitch * (straight - 1), 1.5, 8},
           .velocity = {-speed, 0, 0},
           .density = 8,
           .material = {friction, friction},
           .name = "striker"});
  }

  void observe(const World& w, Check&) override {
    for (std::size_t i = 0; i < dominoes.size(); ++i) {
      const Vec3 up = rotate(w[dominoes[i]].pose().q, Vec3{0, 1, 0});
      if (fell[i] < 0 && up.y < 0.7) fell[i] = w.time();  // tilted by more than 45°
    }
  }
  void check(const World&, Check& c) override {
    int down = 0;
    bool in_order = true;
    for (std::size_t i = 0; i < fell.size(); ++i) {
      down += fell[i] >= 0;
      in_order = in_order && fell[i] >= 0 && (i == 0 || fell[i] > fell[i - 1]);
    }
    c.near("dominoes that fell", down, double(dominoes.size()), 0);
    c.that("one after the other", in_order);
    c.below("the last fell after", fell.back() < 0 ? infinite : fell.back(), 60, "s");
  }
  std::optional<Camera> camera() const override { return Camera{{14, 28, 39}, {0, -3, 0}}; }
};
SUDAR_SCENARIO(Dominoes, "Stacking/Dominoes")
