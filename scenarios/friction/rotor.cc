// A box put on a turntable slips until it turns with it, and is carried round for ever if friction can bend its way:
// ω² r < μ g. With too little it is thrown off.
#include "thesis.h"

using namespace sudar;

struct Rotor : Scenario {
  static constexpr double seconds = 60;
  static constexpr double picture = 3;
  static constexpr const char* about = "a box is carried round on a turntable, or thrown off";
  Real gravity = 4, friction = 0.6, spin = 0.5;
  Body table, rider;
  Vec3 place_at_10;  // on the table, m

  void params(Params& p) override {
    p("gravity", gravity, 0, 20, "m/s²"), p("spin", spin, -5, 5, "rad/s, of the turntable");
    p("friction", friction, 0, 2);
  }
  void state(State& s) override { s("table", table), s("rider", rider), s("place_at_10", place_at_10); }
  void config(Config& c) override { c = thesis_config(); }

  void build(World& w) override {
    add_floor(w, -6, gravity);
    const Material material{friction, friction};
    w.add({.shape = box({100, 4, 100}), .at = {0, -4, 0}, .material = {0, 0}, .name = "slab"});
    table = add_box(w, {30, 4, 30}, {0, 0, 0}, material);
    w.set_velocity(table, {}, {0, spin, 0});
    rider = add_box(w, {2, 2, 2}, {-5, 3, 0}, material);
  }

  double radius(const World& w) const { return horizontal_distance(w[rider].pose().p, w[table].pose().p); }
  void observe(const World& w, Check& c) override {
    const Vec3 place = w[table].pose().local(w[rider].pose().p);
    if (w.time() < 10.005) place_at_10 = place;
    if (carried()) c.from(10).below("slip of the box from 10 s on", length(place - place_at_10), 0.01, "m");
  }
  bool carried() const { return square(double(spin)) * 5.24 < friction * gravity; }
  void check(const World& w, Check& c) override {
    const double turn = length(w[rider].spin());
    if (carried()) {
      const double round = square(double(length(w[table].spin()))) * radius(w);
      c.near("acceleration of the carried box", round, 1.28, 0.03, "m/s²");
      c.near("the box turns with the table", turn, length(w[table].spin()), 1e-3, "rad/s");
    } else {
      c.above("radius of the thrown box", radius(w), 15, "m");
    }
  }
  std::optional<Camera> camera() const override { return Camera{{16, 32, 50}, {0, 0, 0}}; }
};
SUDAR_SCENARIO(Rotor, "Friction/Rotor")
