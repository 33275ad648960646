// What joints bear and do: a bar, a ball joint, a spring, a pulley, a reel.
#include <algorithm>
#include <cmath>

#include "verify/cases/cases.h"
#include "verify/numerics.h"
#include "verify/scene.h"

namespace sudar::verify {

namespace {

// V26. A weight on a bar: the conical pendulum; two weights on a bar: the dumbbell.
void bar_joint(Run& run) {
  const double l = run["length"], m = run["mass"], cone = run["cone"] * pi / 180, g = standard_gravity;
  const double omega = std::sqrt(g / (l * std::cos(cone)));
  World w(run.config());
  add_gravity(run, w);
  const double r = l * std::sin(cone), y = -l * std::cos(cone);
  const Body weight =
      w.add({.shape = sphere(0.05), .at = {r, y, 0}, .velocity = {0, 0, Real(-omega * r)}, .mass = Real(m)});
  const Joint bar = w.join(Bar{.b = weight, .at_b = {r, y, 0}});
  double phi = 0, before = 0, tension = 0, n = 0;
  const double t = 10;
  Plot& plot = run.plot("Angle of the conical pendulum", "t [s]", "φ [rad]");
  run.until(w, t, [&] {
    const Pos p = w[weight].center();
    const double angle = std::atan2(-p.z, p.x);
    phi += std::remainder(angle - before, 2 * pi);
    before = angle;
    plot.theory.emplace_back(w.time(), omega * w.time());
    plot.simulation.emplace_back(w.time(), phi);
    tension += double(length(w[bar].load().force)), ++n;
  });
  run.relative("turns of the conical pendulum", "rad/s", omega, phi / t, 1e-3);
  run.deviation(std::fabs(phi / t - omega));
  run.relative("pull of its bar, mean", "N", m * g / std::cos(cone), tension / n, 1e-3);

  const double spin = run["spin"];
  World free(run.config());
  std::array<Body, 2> ends;
  for (int k : {0, 1}) {
    const Real side = k == 0 ? 1 : -1;
    ends[std::size_t(k)] = free.add(
        {.shape = sphere(0.05), .at = {side * l, 0, 0}, .velocity = {0, Real(spin * l) * side, 0}, .mass = Real(m)});
  }
  const Joint rod = free.join(Bar{.a = ends[0], .b = ends[1], .at_a = {l, 0, 0}, .at_b = {-l, 0, 0}});
  tension = n = 0;
  run.until(free, t, [&] { tension += double(length(free[rod].load().force)), ++n; });
  run.relative("pull in the dumbbell, mean", "N", m * spin * spin * l, tension / n, 1e-3);
  run.relative("speed of the dumbbell's ends", "m/s", spin * l, double(length(free[ends[0]].velocity())), 1e-3);
}

// V27. Force of the joint on a rod that is let go level: along the rod ⁵⁄₂ sin θ, across it ¼ cos θ, in weights, with θ
// the angle below the horizontal. A load is the mean over a sub-step, so it is compared with the law at its middle.
void joint_load(Run& run) {
  const double l = run["length"], m = run["mass"], g = standard_gravity, weight = m * g;
  World w(run.fine_config());
  add_gravity(run, w);
  BodyDef level = thin_rod(l, m);
  level.at = {l / 2, 0, 0};
  const Body rod = w.add(level);
  const Joint ball = w.join(Ball{.b = rod});
  const Rate law = [&](double, const Vector& y) { return Vector{y[1], 1.5 * g / l * std::cos(y[0])}; };
  const double quarter = solve_until(law, 0, {0, 0}, 100, [](double, const Vector& y) { return y[0] - pi / 2; }).t;
  const double half = w.config().dt / 2, t = run["time"];
  double radial = 0, across = 0, radial_exact = 0, across_exact = 0, most = 0;
  Plot& plot = run.plot("Force along the rod", "t [s]", "F/mg");
  run.until(w, 1.2 * quarter, [&] {
    const double theta = solve_ode(law, 0, {0, 0}, w.time() - half)[0];
    const Vec3 along = rotate(w[rod].pose().q, Vec3{1, 0, 0}), force = w[ball].load().force;
    // The load acts in the middle of the sub-step, where the rod was turned half a step less.
    const Vec3 then = rotate(rotation(w[rod].spin() * Real(-half)), along);
    const double pull = -double(dot(force, then)) / weight;
    most = std::max(most, pull);
    plot.theory.emplace_back(w.time() - half, 2.5 * std::sin(theta));
    plot.simulation.emplace_back(w.time() - half, pull);
    if (std::fabs(w.time() - t) > half) return;
    radial = pull, radial_exact = 2.5 * std::sin(theta);
    across = double(length(force + then * Real(pull * weight))) / weight, across_exact = 0.25 * std::cos(theta);
  });
  run.relative("force along the rod", "m g", radial_exact, radial, 0.002);
  run.relative("force across the rod", "m g", across_exact, across, 0.002);
  run.relative("largest force along the rod", "m g", 2.5, most, 0.002);
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

std::vector<Case> joints() {
  return {
      {.id = "V26",
       .title = "Bar joint: conical pendulum and dumbbell",
       .group = "Joints",
       .formula = "ω = √(g/(L cos α)), T = m g/cos α; T = m ω² r",
       .source = "circular motion",
       .parameters = {{"length", 1, 0.1, 10, "m"},
                      {"mass", 1, 0.01, 100, "kg"},
                      {"cone", 40, 5, 80, "°"},
                      {"spin", 5, 0.5, 30, "rad/s"}},
       .sets = {{"60°", {{"cone", 60}, {"spin", 3}}}},
       .run = bar_joint,
       .without = {"impulses", "gravity"},
       .sweep = "the turns of the conical pendulum",
       .order = 2},
      {.id = "V27",
       .title = "Force of a ball joint on a falling rod",
       .group = "Joints",
       .formula = "along the rod ⁵⁄₂ m g sin θ, across it ¼ m g cos θ",
       .source = "energy and angular momentum about the pivot",
       .parameters = {{"length", 1, 0.1, 10, "m"}, {"mass", 1, 0.01, 100, "kg"}, {"time", 0.3, 0.02, 0.5, "s"}},
       .sets = {{"long", {{"length", 2}, {"time", 0.4}}}},
       .run = joint_load,
       .without = {"gravity", "impulses"},
       .others = "Box3D: largest force 24.507 of 24.525 N"},
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
