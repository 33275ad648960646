// Blocks on blocks: towers and their forces, overhangs, heavy on light.
#include <algorithm>
#include <cmath>

#include "verify/cases/cases.h"
#include "verify/numerics.h"
#include "verify/scene.h"

namespace sudar::verify {

namespace {

// The mean force that body a bears from body b, N, over the world's last second.
class MeanForce {
 public:
  void sample(const World& w, double h) {
    ++samples_;
    for (const Contact& c : w.contacts()) {
      for (int k = 0; k < c.count; ++k) {
        const double force = double(c.points[std::size_t(k)].normal_impulse) / h;
        sum_[{c.a, c.b}] += force;
        (c.points[std::size_t(k)].at.x < 0 ? left_ : right_)[{c.a, c.b}] += force;
      }
    }
  }
  using Pair = std::pair<Body, Body>;
  double between(Body a, Body b) const { return of(sum_, a, b); }
  double left(Body a, Body b) const { return of(left_, a, b); }
  double right(Body a, Body b) const { return of(right_, a, b); }

 private:
  double of(const std::map<Pair, double>& sums, Body a, Body b) const {
    const auto at = sums.find({std::max(a, b), std::min(a, b)}), other = sums.find({std::min(a, b), std::max(a, b)});
    return ((at != sums.end() ? at->second : 0) + (other != sums.end() ? other->second : 0)) / samples_;
  }
  std::map<Pair, double> sum_, left_, right_;
  double samples_ = 0;
};

// V22. What the contacts of a tower report; and the two edges under a cube whose centre of mass is off its middle.
void tower_forces(Run& run) {
  const double g = standard_gravity, m = run["mass"];
  const int n = int(run["cubes"]);
  World w(run.config());
  add_gravity(run, w);
  std::vector<Body> cubes{add_ground(w, material(0.6))};
  for (int i = 0; i < n; ++i)
    cubes.push_back(
        w.add({.shape = box({1, 1, 1}), .at = {0, i + 0.5, 0}, .mass = Real(m), .material = material(0.6)}));
  run.until(w, 2);
  MeanForce mean;
  run.until(w, 3, [&] { mean.sample(w, run.h()); });
  double worst = 0;
  Plot& plot = run.plot("Force under each cube", "cubes carried", "F [N]");
  for (int k = 1; k <= n; ++k) {
    const double got = mean.between(cubes[std::size_t(n - k)], cubes[std::size_t(n - k) + 1]);
    worst = std::max(worst, std::fabs(got / (k * m * g) - 1));
    plot.theory.emplace_back(k, k * m * g);
    plot.simulation.emplace_back(k, got);
  }
  run.relative("force under the tower", "N", n * m * g, mean.between(cubes[0], cubes[1]), 0.005);
  run.below("largest relative error of a contact", "1", worst, 0.005);

  const double off = run["offset"];
  World o(run.config());
  add_gravity(run, o);
  const Body ground = add_ground(o, material(0.6));
  const Body cube = o.add({.shape = box({1, 1, 1}),
                           .at = {0, 0.5, 0},
                           .mass = Real(m),
                           .center = Vec3{Real(off), 0, 0},
                           .material = material(0.6)});
  run.until(o, 2);
  MeanForce edges;
  run.until(o, 3, [&] { edges.sample(o, run.h()); });
  run.relative("cube off its middle: near edge", "N", (0.5 + off) * m * g, edges.right(cube, ground), 0.005);
  run.relative("cube off its middle: far edge", "N", (0.5 - off) * m * g, edges.left(cube, ground), 0.005);
}

// V23. Blocks that overhang by ½ Σ 1/k of their length just stand.
bool overhang_stands(Run& run, int n, double share) {
  const double length = 1, height = 0.2;
  World w(with_small_slop(run.config()));
  add_gravity(run, w);
  const Material m = material(0.6);
  w.add({.shape = box({4, 1, 1}), .at = {-2, -0.5, 0}, .material = m, .motion = Motion::fixed});  // its edge at x = 0
  double x = -length / 2;
  std::vector<Body> blocks;
  for (int i = 0; i < n; ++i) {  // from below: each sticks out by length/2k over the one below, k counted from above
    x += share * length / (2 * (n - i));
    blocks.push_back(w.add(
        {.shape = box({Real(length), Real(height), 1}), .at = {x, (i + 0.5) * height, 0}, .mass = 1, .material = m}));
  }
  const double top = (n - 0.5) * height;
  Plot& plot = run.plot(share < 1 ? "Height of the top, 98 %" : "Height of the top, 102 %", "t [s]", "y [m]");
  if (share < 1) plot.theory = {{0, top}, {10, top}};
  run.until(w, 10, [&] {
    if (w.steps() % 5 == 0 && w[blocks.back()].center().y > -2)
      plot.simulation.emplace_back(w.time(), w[blocks.back()].center().y);
  });
  return w[blocks.back()].center().y > top - 0.05;
}

void overhang(Run& run) {
  const int n = int(run["blocks"]);
  run.holds("stands with 98 % of the overhang", overhang_stands(run, n, 0.98));
  run.holds("falls with 102 %", !overhang_stands(run, n, 1.02));
}

// V43. A heavy cube on a light one.
void heavy_on_light(Run& run) {
  const double ratio = run["ratio"];
  World w(with_small_slop(run.config()));
  add_gravity(run, w);
  const Material m = material(0.6);
  add_ground(w, m);
  const Body light = w.add({.shape = box({1, 1, 1}), .at = {0, 0.5, 0}, .mass = 1, .material = m});
  const Body heavy = w.add({.shape = box({1, 1, 1}), .at = {0, 1.5, 0}, .mass = Real(ratio), .material = m});
  Plot& plot = run.plot("Height of the heavy cube", "t [s]", "y [m]");
  run.until(w, 10, [&] { plot.simulation.emplace_back(w.time(), w[heavy].center().y); });
  plot.theory = {{0, 1.5}, {10, 1.5}};
  run.check("height of the light cube", "m", 0.5, w[light].center().y, 0.01);
  run.check("height of the heavy cube", "m", 1.5, w[heavy].center().y, 0.01);
}

// V45. Towers of cubes for 30 s.
void towers(Run& run) {
  const int n = int(run["cubes"]);
  World w(with_small_slop(run.config()));
  add_gravity(run, w);
  const Material m = material(0.6);
  add_ground(w, m);
  Body top;
  for (int i = 0; i < n; ++i) top = w.add({.shape = box({1, 1, 1}), .at = {0, i + 0.5, 0}, .mass = 1, .material = m});
  Plot& plot = run.plot("Sinking of the top", "t [s]", "y − y₀ [m]");
  run.until(w, 30, [&] {
    if (w.steps() % 10 == 0) plot.simulation.emplace_back(w.time(), w[top].center().y - (n - 0.5));
  });
  plot.theory = {{0, 0}, {30, 0}};
  run.holds("stands for 30 s", w[top].center().y > n - 1);
  run.check("sinking of the top", "m", 0, w[top].center().y - (n - 0.5), 0.1);
}

}

std::vector<Case> stacks() {
  return {
      {.id = "V22",
       .title = "Forces in a tower",
       .group = "Structures",
       .formula = "k m g under k cubes; edges (½ ± x/a) m g",
       .source = "statics",
       .parameters = {{"cubes", 10, 1, 30, whole_number},
                      {"mass", 1, 0.01, 100, "kg"},
                      {"offset", 0.1, -0.4, 0.4, "m"}},
       .sets = {{"five, heavy", {{"cubes", 5}, {"mass", 20}, {"offset", 0.25}}}},
       .run = tower_forces,
       .without = {"gravity", "impulses"},
       .others = "Rapier pins m g Δt to 1 %; Box3D reports twice as much"},
      {.id = "V23",
       .title = "Harmonic overhang",
       .group = "Structures",
       .formula = "½ Σ 1/k lengths",
       .source = "statics",
       .parameters = {{"blocks", 4, 2, 20, whole_number}},
       .sets = {{"three", {{"blocks", 3}}}, {"five", {{"blocks", 5}}}, {"ten", {{"blocks", 10}}}},
       .run = overhang,
       .without = {"impulses", "gravity"}},
      {.id = "V43",
       .title = "Heavy cube on a light one",
       .group = "Structures",
       .formula = "heights ½ and ³⁄₂",
       .source = "statics",
       .parameters = {{"ratio", 10, 1, 1e7, "1"}},
       .sets = {{"100", {{"ratio", 100}}},
                {"1000", {{"ratio", 1e3}}},
                {"10⁴", {{"ratio", 1e4}}},
                {"10⁶", {{"ratio", 1e6}}}},
       .run = heavy_on_light,
       .without = {"impulses"},
       .others =
           "10: all; 100: Box3D, Rapier 1.465, PhysX TGS 1.475, Havok 1.468; 1000: Box3D 1.16, MuJoCo 0.95; 10⁴: none"},
      {.id = "V45",
       .title = "Towers of cubes",
       .group = "Structures",
       .formula = "stands for 30 s, sinks by 0",
       .source = "statics",
       .parameters = {{"cubes", 10, 1, 200, whole_number}},
       .sets = {{"25", {{"cubes", 25}}}, {"50", {{"cubes", 50}}}, {"100", {{"cubes", 100}}}},
       .run = towers,
       .without = {"impulses", "contact areas"},
       .bite = {.values = {{"cubes", 10}}},
       .effort = Effort::normal,
       .others = "Box3D, Rapier sink 0.026, 0.167, 0.68, 2.8 m; Jolt, Havok, Bullet, PhysX, MuJoCo fall at 25"},
  };
}

}
