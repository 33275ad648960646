// Chains: one that falls, one that carries a weight.
#include <algorithm>
#include <cmath>

#include "verify/cases/cases.h"
#include "verify/numerics.h"
#include "verify/scene.h"

namespace sudar::verify {

namespace {

// Rods on ball joints, each beginning where the last one ended.
class Chain {
 public:
  explicit Chain(World& world, const Pos& at) : world_(world), end_(at) {}
  void add(double length, double mass, const Vec3d& along) {
    BodyDef rod = thin_rod(length, mass);
    rod.at = end_ + along * (length / 2);
    rod.turn = axis_angle(Vec3{0, 0, 1}, Real(std::atan2(along.y, along.x)));
    rod.filter.group = -1;
    const Body now = world_.add(rod);
    if (!rods.empty() || held)
      joints.push_back(world_.join(Ball{.a = rods.empty() ? Body{} : rods.back(), .b = now, .at = end_}));
    rods.push_back(now);
    end_ = end_ + along * length;
  }
  const Pos& end() const { return end_; }
  bool held = true;  // the first rod hangs on the world
  std::vector<Body> rods;
  std::vector<Joint> joints;

 private:
  World& world_;
  Pos end_;
};

// V25. A chain of length L that hangs in a tight fold, one end let go: it falls faster than free,
// v² = 2 g x (1 − x/2L)/(1 − x/L), for the hanging side pulls it on.
void falling_chain(Run& run) {
  const int half = int(run["links"] / 2);
  const double g = standard_gravity, whole = run["length"], l = whole / (2 * half + 1);
  World w(run.fine_config());
  add_gravity(run, w);
  Chain chain(w, {});
  for (int i = 0; i < half; ++i) chain.add(l, l, {0, -1, 0});
  chain.add(l, l, {1, 0, 0});
  for (int i = 0; i < half; ++i) chain.add(l, l, {0, 1, 0});
  const double free_fall = std::sqrt(2 * whole / g);
  // In times of the free fall; u = x/L = sin²(a/2) takes the roots at both ends away.
  const auto time = [](double to) {
    const auto rate = [](double a) { return square(std::cos(a / 2)) / std::sqrt(1 - square(std::sin(a / 2)) / 2); };
    return integral(rate, 0, 2 * std::asin(std::sqrt(to))) / 2;
  };
  double deepest = 0, at = std::nan("");
  bool turned = false;
  Plot& plot = run.plot("Way of the free end", "t / free fall", "x / L");
  run.until(w, 1.2 * free_fall, [&] {
    const BodyView last = w[chain.rods.back()];
    const double depth = -(last.pose().p + rotate(convert<double>(last.pose().q), Vec3d{l / 2, 0, 0})).y;
    turned |= depth < deepest && deepest > whole / 2;
    if (depth > deepest && !turned) deepest = depth, at = w.time();
    if (!turned) plot.simulation.emplace_back(w.time() / free_fall, depth / whole);
  });
  for (int k = 0; k <= 50; ++k) plot.theory.emplace_back(time(k / 50.0), k / 50.0);
  run.relative("time of the fall / free fall", "1", time(1), at / free_fall, 0.02);

  // A chain that falls freely keeps its shape, and its joints bear nothing.
  World f(run.config());
  add_gravity(run, f);
  Chain zigzag(f, {});
  zigzag.held = false;
  for (int i = 0; i < 10; ++i) zigzag.add(l, l, {0.8, i % 2 == 0 ? 0.6 : -0.6, 0});
  double most = 0, bent = 0;
  run.until(f, 1, [&] {
    for (const Joint j : zigzag.joints) most = std::max(most, double(length(f[j].load().force)));
    for (const Body b : zigzag.rods) bent = std::max(bent, double(length(f[b].spin())));
  });
  run.below("free chain: largest reaction", "m g", most / (l * g), 1e-4);
  run.below("free chain: fastest turn of a link", "rad/s", bent, 1e-4);
}

// V44. A weight on a chain: joint k, counted from above, bears (M + (N − k) m) g, and nothing stretches.
void heavy_weight(Run& run) {
  const int n = int(run["links"]);
  const double g = standard_gravity, m = run["link"], weight = run["weight"], l = 0.5;
  for (const double kick : {0.0, 1e-4}) {
    World w(run.config());
    add_gravity(run, w);
    Chain chain(w, {});
    for (int i = 0; i < n; ++i) chain.add(l, m, {0, -1, 0});
    const Pos hook = chain.end();
    const Body load = w.add({.shape = sphere(0.25),
                             .at = hook,
                             .velocity = {Real(kick), 0, 0},
                             .mass = Real(weight),
                             .filter = {.group = -1}});
    w.join(Ball{.a = chain.rods.back(), .b = load, .at = hook});
    double stretch = 0, top = 0, middle = 0, samples = 0;
    Plot& plot = run.plot(kick > 0 ? "Stretch, kicked aside" : "Stretch", "t [s]", "%");
    plot.theory = {{0, 0}, {10, 0}};
    run.until(w, 10, [&] {
      const Pos p = w[load].center();
      const double longer = std::hypot(std::hypot(p.x, p.z), p.y) / (n * l) - 1;
      stretch = std::max(stretch, std::isfinite(longer) ? std::fabs(longer) : 1e9);
      if (w.steps() % 5 == 0) plot.simulation.emplace_back(w.time(), 100 * longer);
      if (w.time() < 9) return;
      top += double(length(w[chain.joints[0]].load().force));
      middle += double(length(w[chain.joints[std::size_t(n / 2)]].load().force)), ++samples;
    });
    const std::string how = kick > 0 ? "kicked aside: " : "";
    run.below(how + "largest stretch", "%", 100 * stretch, 1);
    run.relative(how + "force at the top", "N", (weight + n * m) * g, top / samples, 0.01);
    run.relative(how + "force in the middle", "N", (weight + (n - n / 2) * m) * g, middle / samples, 0.01);
  }
}

}

std::vector<Case> chains() {
  return {
      {.id = "V25",
       .title = "Falling chain",
       .group = "Joints",
       .formula = "v² = 2 g x (1 − x/2L)/(1 − x/L): T = 0.8472 of the free fall; a free chain's joints bear nothing",
       .source = "Calkin & March, Am. J. Phys. 57 (1989) 154; quadrature",
       .parameters = {{"links", 61, 11, 301, whole_number}, {"length", 3, 0.5, 30, "m"}},
       .sets = {{"41 links", {{"links", 41}}}},
       .run = falling_chain,
       .without = {"gravity", "impulses"},
       .bite = {.values = {{"links", 21}}, .substeps = 16}},
      {.id = "V44",
       .title = "Weight on a chain",
       .group = "Joints",
       .formula = "joint k bears (M + (N − k) m) g, stretch 0",
       .source = "statics",
       .parameters = {{"links", 20, 2, 200, whole_number},
                      {"link", 1, 0.01, 100, "kg"},
                      {"weight", 1000, 0.1, 1e5, "kg"}},
       .sets = {{"1 kg", {{"weight", 1}}}, {"100 kg", {{"weight", 100}}}, {"100 links", {{"links", 100}}}},
       .run = heavy_weight,
       .without = {"impulses", "gravity"},
       .bite = {.values = {{"weight", 100}}},
       .others = "20 links, 1 : 1 Jolt 0.3 %, Rapier 0.9 %, Havok 1.5 %; 100 : 1 Rapier 10 %, Jolt 12 %; 1000 : 1 "
                 "Box3D 27 %, Havok "
                 "85 %, the others over 100 %"},
  };
}

}
