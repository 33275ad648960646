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

// V28. A turning body on a spring: the damped oscillator, and exactly the recursion of the implicit Euler method.
void spring_servo(Run& run) {
  const double inertia = run["inertia"], k = run["stiffness"], c = run["damping"], until = 0.7;
  World w(run.config());
  const double r = std::sqrt(inertia / 0.4);
  const Body b = w.add({.shape = sphere(Real(r)), .mass = 1});
  const Drive spring{.mode = DriveMode::spring, .target = 1, .force = 1e6, .stiffness = Real(k), .damping = Real(c)};
  const Joint j = w.join(Hinge{.b = b, .axis = {0, 1, 0}, .drive = spring});
  const double h = double(w.config().dt) / w.config().substeps;
  double angle = 0, rate = 0;
  Plot& plot = run.plot("Angle", "t [s]", "rad");
  const double decay = c / (2 * inertia), squared = k / inertia - square(decay), swing = std::sqrt(std::fabs(squared));
  const auto exact = [&](double t) {  // swings, or creeps
    const double even = squared > 0 ? std::cos(swing * t) : std::cosh(swing * t);
    const double odd = squared > 0 ? std::sin(swing * t) : std::sinh(swing * t);
    return 1 - std::exp(-decay * t) * (even + decay / swing * odd);
  };
  run.until(w, until, [&] {
    for (int n = 0; n < w.config().substeps; ++n) {
      rate = (inertia * rate + h * k * (1 - angle)) / (inertia + h * c + h * h * k);
      angle += h * rate;
    }
    plot.theory.emplace_back(w.time(), exact(w.time()));
    plot.simulation.emplace_back(w.time(), double(w[j].coordinate()));
  });
  run.check("angle, by the recursion", "rad", angle, double(w[j].coordinate()), 1e-5);
  run.deviation(std::fabs(exact(w.time()) - double(w[j].coordinate())));
  run.relative("angle, of the oscillator", "rad", exact(w.time()), double(w[j].coordinate()), 0.02);
}

// V60. Two weights on a rope over a wheel without mass; a solid disc that unrolls from its rope.
void pulley_and_yoyo(Run& run) {
  const double g = standard_gravity, heavy = run["heavy"], light = run["light"], r = run["radius"], seconds = 1;
  World w(run.config());
  add_gravity(run, w);
  BodyDef weight{.shape = sphere(Real(0.1)), .at = {-1, 0, 0}, .mass = Real(heavy)};
  const Body a = w.add(weight);
  weight.at = {1, 0, 0}, weight.mass = Real(light);
  const Body b = w.add(weight);
  const Joint pulley =
      w.join(Pulley{.a = a, .b = b, .at_a = {-1, 0, 0}, .over_a = {-1, 6, 0}, .over_b = {1, 6, 0}, .at_b = {1, 0, 0}});
  const Body disc = w.add({.shape = cylinder(Real(r), Real(0.02)),
                           .at = {Real(4 - r), 0, 0},
                           .turn = axis_angle(Vec3{1, 0, 0}, Real(pi / 2)),
                           .mass = 1});
  const Joint rope =
      w.join(Reel{.b = disc, .at_a = {4, 3, 0}, .at = {Real(4 - r), 0, 0}, .axis = {0, 0, 1}, .radius = Real(r)});
  double pull = 0, pull_of_disc = 0;
  const double a1 = g * (heavy - light) / (heavy + light);
  Plot& plot = run.plot("Velocity of Atwood's heavy weight", "t [s]", "v [m/s]");
  Plot& unrolls = run.plot("Velocity of the yo-yo", "t [s]", "v [m/s]");
  run.until(w, seconds, [&] {
    plot.theory.emplace_back(w.time(), a1 * w.time());
    plot.simulation.emplace_back(w.time(), -double(w[a].velocity().y));
    unrolls.theory.emplace_back(w.time(), 2 * g / 3 * w.time());
    unrolls.simulation.emplace_back(w.time(), -double(w[disc].velocity().y));
    pull += double(length(w[pulley].load().force));
    pull_of_disc += double(length(w[rope].load().force));
  });
  const double steps = double(w.steps()), t = w.time();
  run.relative("Atwood: acceleration", "m/s²", a1, -double(w[a].velocity().y) / t, 1e-3);
  run.relative("Atwood: tension", "N", 2 * heavy * light / (heavy + light) * g, pull / steps, 1e-3);
  run.relative("yo-yo: acceleration", "m/s²", 2 * g / 3, -double(w[disc].velocity().y) / t, 1e-3);
  run.relative("yo-yo: tension", "N", g / 3, pull_of_disc / steps, 1e-3);
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
      {.id = "V28",
       .title = "Spring servo",
       .group = "Joints",
       .formula = "I θ¨ = k (θ₁ − θ) − c θ˙, implicit: ω ← (I ω + h k (θ₁ − θ))/(I + h c + h² k)",
       .source = "damped oscillator",
       .parameters = {{"inertia", 2, 0.01, 100, "kg m²"},
                      {"stiffness", 50, 0.1, 1e4, "N m/rad"},
                      {"damping", 4, 0, 100, "N m s/rad"}},
       .sets = {{"weak", {{"stiffness", 10}, {"damping", 1}}}},
       .run = spring_servo,
       .without = {"impulses"},
       .others = "Jolt's tests repeat the implicit recursion",
       .sweep = "the angle of the oscillator",
       .order = 1},
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
      {.id = "V60",
       .title = "Atwood's machine, yo-yo",
       .group = "Joints",
       .formula = "a = g (m₁ − m₂)/(m₁ + m₂); a = ⅔ g",
       .source = "energy",
       .parameters = {{"heavy", 3, 0.1, 1000, "kg"},
                      {"light", 2, 0.1, 1000, "kg"},
                      {"radius", 0.1, 0.01, 1, "m, of the yo-yo"}},
       .sets = {{"3 : 1", {{"light", 1}, {"radius", 0.3}}}},
       .run = pulley_and_yoyo,
       .without = {"impulses", "gravity"}},
  };
}

}
