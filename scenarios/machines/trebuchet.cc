// A counterweight throws a stone: the arm swings it up in a sling, and the sling lets go when the stone flies as
// steeply as wished. From there on it is a ballistic flight.
#include "thesis.h"

using namespace sudar;

struct Trebuchet : Scenario {
  static constexpr double seconds = 18;
  static constexpr double picture = 2.5;
  static constexpr const char* about = "a counterweight throws a stone";
  static constexpr double ground_level = -11, radius = 0.8;  // the thesis has −12, and the supports drop by 1
  Real gravity = 4, counterweight = 12, stone_density = 4, release = 45;
  Body arm, stone;
  Joint sling;
  double let_go = -1, range = 0;  // when the sling let go, s; where the stone will land, m
  double landed = -1, x = 0;      // when and where it did
  bool by_hand = false;           // let go by the user

  void params(Params& p) override {
    p("gravity", gravity, 0, 20, "m/s²"), p("counterweight", counterweight, 1, 50, "kg/m³"),
        p("stone", stone_density, 0.5, 20, "kg/m³"), p("release", release, 10, 80, "degrees above the horizon");
  }
  void state(State& s) override {
    s("arm", arm), s("stone", stone), s("sling", sling);
    s("let_go", let_go), s("range", range), s("landed", landed), s("x", x), s("by_hand", by_hand);
  }
  void config(Config& c) override { c = thesis_config(); }

  void build(World& w) override {
    add_floor(w, ground_level, gravity);
    const Material material{Real(0.6), Real(0.4), 0};
    arm = add_box(w, {30, 1, 1}, {-8, 2, 0}, material);
    const Vec3 outline[] = {{-4, -5, 0}, {4, -5, 0}, {0, 10, 0}};
    for (double side : {-1.0, 1.0}) {
      const Body support =
          w.add({.shape = prism(outline, 2), .at = {0, -6, 3 * side}, .density = 5, .material = material});
      w.join(Hinge{.a = support, .b = arm, .at = {0, 2, 3 * side}});
    }
    const Body weight = w.add({.shape = box({4, 4, 3}),
                               .at = {6.5, -1.5, 0},
                               .density = counterweight,
                               .material = material,
                               .name = "counterweight"});
    w.join(Hinge{.a = arm, .b = weight, .at = {6.5, 2, 0}});
    stone = w.add({.shape = sphere(radius),
                   .at = {-14, ground_level + radius, 0},
                   .density = stone_density,
                   .material = material,
                   .name = "stone"});
    sling = w.join(Rope{.a = arm, .b = stone, .at_a = {-22.5, 2, 0}, .at_b = w[stone].center()});
  }
  void control(World& w, const Input& in) override {
    if (let_go >= 0) return;
    const Vec3 v = w[stone].velocity();
    const bool steep = v.y > v.x * sudar::tan(release * pi / 180);
    by_hand = in.pressed("space");
    if (by_hand || (v.x > 5 && !steep)) {
      w.remove(sling);
      let_go = w.time();
      const double fall = w[stone].center().y - ground_level - radius, up = v.y;
      range = w[stone].center().x + v.x * (up + sqrt(up * up + 2 * gravity * fall)) / gravity;
    }
  }

  void observe(const World& w, Check& c) override {
    c.below("joint gap", w.quality().joint_gap_max, 0.1, "m");
    if (let_go >= 0 && landed < 0 && w[stone].center().y < ground_level + radius) {
      landed = w.time(), x = w[stone].center().x;
    }
  }
  void check(const World&, Check& c) override {
    if (!by_hand) c.above("the stone flies to", x, 60, "m");
    c.near("it lands where a parabola ends", x, range, 0.01 * abs(range), "m");
  }
  std::vector<KeyHelp> keys() const override { return {{"space", "let go now"}}; }
  std::optional<Camera> camera() const override { return Camera{{-14, 12, 82}, {2, 4, 0}}; }
};
SUDAR_SCENARIO(Trebuchet, "Machines/Trebuchet")
