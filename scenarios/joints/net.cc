// thesis fig. 8: a net of bars, tied by ball joints, catches nine cubes. Its rows are exactly as long as the span, so
// any sag of the border is joint error.
#include "thesis.h"

using namespace sudar;

struct Net : Scenario {
  static constexpr double seconds = 10;
  static constexpr double picture = 4;
  static constexpr const char* about = "a net of 144 bars and 211 joints catches nine cubes (thesis, fig. 8)";
  int cells = 8;
  Real gravity = 5;
  double pitch = 6.5, drop = 15;
  std::vector<Body> cubes;
  double met = -1;  // when the first cube reached the net, s

  void params(Params& p) override {
    p("cells", cells, 4, 20, "along each side"), p("gravity", gravity, 0, 20, "m/s²");
    p("drop", drop, 5, 50, "m, of the cubes above the net");
  }
  void state(State& s) override { s("cubes", cubes), s("met", met); }
  void config(Config& c) override {
    c = thesis_config(10, 20);
    c.impulse_2007.joint_correction_in_velocity = true;
  }

  Pos node(double x, double z) const { return {(x - cells / 2.0) * pitch, 5, (z - cells / 2.0) * pitch}; }
  void build(World& w) override {
    add_floor(w, -20, gravity);
    add_drag(w);
    const Material material{Real(0.6), Real(0.4), Real(0.5)};
    const int nodes = cells + 1;
    std::vector<Body> first(
        std::size_t(nodes * nodes));  // the bar that came first to a node; the others are tied to it
    const auto add_bar = [&](int x, int z, int dx, int dz) {
      const Vec3 edges = dx ? Vec3{5, 0.5, 0.5} : Vec3{0.5, 0.5, 5};
      const Body bar = add_box(w, edges, node(x + dx / 2.0, z + dz / 2.0), material);
      for (int end : {0, 1}) {
        const int at_x = x + dx * end, at_z = z + dz * end;
        Body& tied = first[std::size_t(at_z * nodes + at_x)];  // null, the world, for the first at a corner
        const bool corner = (at_x == 0 || at_x == cells) && (at_z == 0 || at_z == cells);
        if (corner || !tied.null()) w.join(Ball{.a = tied, .b = bar, .at = node(at_x, at_z)});
        if (tied.null()) tied = bar;
      }
    };
    for (int z = 0; z < nodes; ++z) {
      for (int x = 0; x < nodes; ++x) {
        if (x < cells) add_bar(x, z, 1, 0);
        if (z < cells) add_bar(x, z, 0, 1);
      }
    }
    for (int z : {-2, 0, 2}) {
      for (int x : {-2, 0, 2}) {
        cubes.push_back(add_box(w, Vec3{1, 1, 1} * Real(pitch), {x * pitch, 5 + drop, z * pitch}, material));
      }
    }
  }

  void observe(const World& w, Check& c) override {
    for (const Contact& contact : w.contacts()) {
      for (Body cube : cubes) {
        if (met < 0 && (contact.a == cube || contact.b == cube)) met = w.time();
      }
    }
    c.below("joint gap", w.quality().joint_gap_max, 0.6, "m");
  }
  void check(const World& w, Check& c) override {
    c.near("cubes reach the net", met, 2.40, 0.05, "s");
    double lowest = infinite;
    for (Body cube : cubes) lowest = min(lowest, w[cube].pose().p.y);
    c.above("lowest cube (one that fell through or off lies at -16.7)", lowest, -7.5, "m");
  }
  std::optional<Camera> camera() const override { return Camera{{40, 35, 60}, {0, 4, 0}}; }
};
SUDAR_SCENARIO(Net, "Joints/Net")
