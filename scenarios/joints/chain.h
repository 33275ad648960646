// thesis fig. 13: a chain that hangs by one end falls on the floor; with hinges (chain) or ball joints (chain_ball).
#pragma once

#include "thesis.h"

namespace sudar::inline SUDAR_PRECISION {

struct ChainScene : Scenario {
  static constexpr double seconds = 10;
  static constexpr double picture = 2.5;
  int links = 15;
  Real gravity = 4, friction_static = 0.2, friction_dynamic = 0.1, density = 1;
  Vec3 edges;
  Body floor;
  std::vector<Body> chain;
  double touched = -1;  // when the chain met the floor, s

  virtual JointDef joint(Body before, Body link, const Pos& at) const = 0;

  void params(Params& p) override {
    p("links", links, 1, 100), p("gravity", gravity, 0, 20, "m/s²"), p("density", density, 0.01, 1000, "kg/m³");
    p("friction_static", friction_static, 0, 2), p("friction_dynamic", friction_dynamic, 0, 2);
  }
  void state(State& s) override { s("floor", floor), s("chain", chain), s("touched", touched); }
  void config(Config& c) override { c = thesis_config(); }

  void build(World& w) override {
    floor = add_floor(w, -14, gravity);
    add_drag(w);
    for (int i = 0; i < links; ++i) {
      const Body before = chain.empty() ? Body{} : chain.back();
      chain.push_back(w.add({.shape = box(edges),
                             .at = {3.0 * i, 10, 0},
                             .density = density,
                             .material = {friction_static, friction_dynamic}}));
      w.join(joint(before, chain.back(), {3 * i - 1.5, 10, 0}));
    }
  }

  void observe(const World& w, Check& c) override {
    for (Body link : chain) {
      if (touched < 0 && w.touching(link, floor)) touched = w.time();
    }
    const double gap = w.quality().joint_gap_max;
    if (touched < 0) {
      c.below("joint gap in the air", gap, 0.001, "m");
    } else {
      c.below("joint gap after touch-down", gap, 0.02, "m");
    }
  }
  void check(const World&, Check& c) override { c.near("touch-down", touched, 4.1, 0.1, "s"); }
  std::optional<Camera> camera() const override { return Camera{{12, 6, 46}, {16, -3, 0}}; }
};

}
