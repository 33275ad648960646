// Balls that bounce: on a floor, many of them, on a plate that vibrates.
#include <algorithm>
#include <cmath>

#include "verify/cases/cases.h"
#include "verify/numerics.h"
#include "verify/scene.h"

namespace sudar::verify {

namespace {

constexpr double ball_radius = 0.1;

// V13. A bouncing ball: apexes e²ⁿ h.
void bounces(Run& run) {
  const double e = run["restitution"], h = run["height"], g = standard_gravity;
  World w(run.fine_config());
  add_gravity(run, w);
  const Material m = material(0.5, run.with("restitution", e));
  add_ground(w, m);
  const Body ball = w.add({.shape = sphere(Real(ball_radius)), .at = {0, h + ball_radius, 0}, .material = m});
  std::vector<double> apexes;
  double highest = 0;
  bool rising = false;
  Plot& plot = run.plot("Height", "t [s]", "y [m]");
  const double t_first = std::sqrt(2 * h / g);
  run.until(w, 3 * t_first * (1 + e) / (1 - e), [&] {
    const double y = w[ball].center().y - ball_radius, v = double(w[ball].velocity().y);
    if (v > 0 && !rising) rising = true, highest = 0;
    highest = std::max(highest, y);
    if (v <= 0 && rising) rising = false, apexes.push_back(highest);
    if (apexes.size() < 6) plot.simulation.emplace_back(w.time(), y);
  });
  double begin = t_first, speed = std::sqrt(2 * g * h) * e;
  for (int k = 0; k <= 20; ++k) plot.theory.emplace_back(t_first * k / 20, h - g * square(t_first * k / 20) / 2);
  for (int n = 0; n < 6; ++n, speed *= e) {
    for (int k = 0; k <= 20; ++k) {
      const double s = 2 * speed / g * k / 20;
      plot.theory.emplace_back(begin + s, speed * s - g * s * s / 2);
    }
    begin += 2 * speed / g;
  }
  for (std::size_t n = 0; n < 5; ++n) {
    const double got = n < apexes.size() ? apexes[n] : 0;
    run.relative("apex " + std::to_string(n + 1), "m", h * std::pow(e, 2 * double(n + 1)), got, 0.01);
  }
}

// V13b. SimBenchmark, bouncing: 49 elastic balls for 20 s; mean squared error of the energy. Free flight alone makes
// (N ½ m g h)² ⟨v²⟩ of it with symplectic Euler, and no rule for impacts can do better.
void elastic_balls(Run& run) {
  constexpr int side = 7, n = side * side;
  const double m = 10, height = 5, r = 0.1, g = standard_gravity, h = run["sub-step"];
  Config c = run.config();
  c.substeps = run["sub-step"] < 1.0 / 60 ? std::max(1, int(std::lround(1.0 / 60 / h))) : 1;
  c.dt = h * c.substeps;
  World w(c);
  add_gravity(run, w);
  const Material elastic = material(0, run.with("restitution", 1));
  add_ground(w, elastic);
  for (int i = 0; i < n; ++i) {
    w.add({.shape = sphere(Real(r)),
           .at = {double(i % side), height, double(i / side)},
           .mass = Real(m),
           .material = elastic});
  }
  const double energy = n * m * g * height;
  double sum = 0, steps = 0;
  Plot& plot = run.plot("Energy", "t [s]", "E − E₀ [J]");
  run.until(w, 20, [&] {
    const double error = w.energy().total() - energy;
    sum += error * error, ++steps;
    if (w.time() < 5) plot.simulation.emplace_back(w.time(), error);
  });
  plot.theory = {{0, 0}, {5, 0}};
  const double floor = square(n * m * g * h / 2) * 2 * g * (height - r) / 3;
  run.relative("mean squared error of the energy", "J²", floor, sum / steps, 0.02);
}

// V69. A ball on a vibrating plate bounces once a period exactly when A ω²/g ≥ π (1−e)/(1+e).
bool bounces_once_a_period(Run& run, double strength) {
  const double e = run["restitution"], period = 1 / run["frequency"], omega = 2 * pi / period, g = standard_gravity;
  const double amplitude = strength * pi * (1 - e) / (1 + e) * g / square(omega), r = ball_radius;
  const double phase = std::acos(std::min(1.0, 1 / strength));  // of the impacts, where they exist
  World w(run.fine_config());
  add_gravity(run, w);
  const Material m = material(0, e);
  const auto plate_at = [&](double t) { return amplitude * std::sin(omega * t + phase); };
  const Body plate =
      w.add({.shape = box({1, 1, 1}), .at = {0, plate_at(0) - 0.5, 0}, .material = m, .motion = Motion::kinematic});
  const Body ball = w.add({.shape = sphere(Real(r)),
                           .at = {0, plate_at(0) + r, 0},
                           .velocity = {0, Real(g * period / 2), 0},
                           .material = m});
  w.place(plate, {{0, plate_at(0) - 0.5, 0}, {}});
  std::vector<double> impacts;
  Plot& plot = run.plot(strength > 1 ? "Height above the threshold" : "Height below it", "t [s]", "y [m]");
  run.draw(w);
  double before = double(w[ball].velocity().y);
  const double end = 60 * period, dt = w.config().dt;
  while (w.time() < end) {
    w.set_velocity(plate, {0, Real((plate_at(w.time() + dt) - plate_at(w.time())) / dt), 0}, {});
    w.step();
    const double now = double(w[ball].velocity().y);
    if (now > before && w.time() > end / 2) impacts.push_back(w.time());
    before = now;
    if (w.time() < end - 4 * period) continue;
    plot.simulation.emplace_back(w.time(), w[ball].center().y - r);
    const double since = std::fmod(w.time(), period);  // an impact
    if (strength > 1) plot.theory.emplace_back(w.time(), plate_at(0) + g * since * (period - since) / 2);
  }
  run.draw(w);
  if (impacts.size() < 28 || impacts.size() > 32) return false;
  for (std::size_t i = 1; i < impacts.size(); ++i) {
    if (std::fabs(impacts[i] - impacts[i - 1] - period) > 0.1 * period) return false;
  }
  return true;
}

void vibrating_plate(Run& run) {
  run.holds("bounces once a period 5 % above the threshold", bounces_once_a_period(run, 1.05));
  run.holds("does not 5 % below", !bounces_once_a_period(run, 0.95));
}

}

std::vector<Case> bounces() {
  return {
      {.id = "V13",
       .title = "Bouncing ball",
       .group = "Impacts",
       .formula = "hₙ = e²ⁿ h",
       .source = "definition of restitution",
       .parameters = {{"height", 2, 0.2, 20, "m"}, {"restitution", 0.8, 0.7, 0.95, "1"}},
       .sets = {{"e = 0.9", {{"restitution", 0.9}}}},
       .run = bounces,
       .without = {"gravity", "restitution"},
       .bite = {.values = {{"restitution", 0.9}}},
       .others = "first apex: Jolt +0.13 %, Box3D, Rapier −2.4 %, PhysX +5.5 %, Havok −1.9 %"},
      {.id = "V13b",
       .title = "SimBenchmark: bouncing",
       .group = "Impacts",
       .formula = "⟨(E − E₀)²⟩ = (N ½ m g h)² ⟨v²⟩, ⟨v²⟩ = ⅔ g H",
       .source = "symplectic Euler in free flight; leggedrobotics/SimBenchmark",
       .parameters = {{"sub-step", 1.0 / 240, 1e-5, 0.02, "s"}},
       .sets = {{"1 ms", {{"sub-step", 1e-3}}}},
       .run = elastic_balls,
       .without = {"restitution"},
       .bite = {.values = {{"sub-step", 1e-3}}},
       .effort = Effort::normal,
       .others = "1 ms (floor 185): Jolt 184.5, PhysX TGS 184.8, ODE 185.0; PhysX PGS 75 260, Bullet 75 245, Rapier 66 "
                 "120, Box3D "
                 "296 518 (19 131 with 4 sub-steps), Havok 3.2e6"},
      {.id = "V69",
       .title = "Ball on a vibrating plate",
       .group = "Impacts",
       .formula = "one bounce a period exists exactly when A ω²/g ≥ π (1−e)/(1+e)",
       .source = "Holmes, J. Sound Vib. 84 (1982) 173",
       .parameters = {{"restitution", 0.5, 0.2, 0.9, "1"}, {"frequency", 5, 1, 20, "Hz"}},
       .sets = {{"e = 0.8", {{"restitution", 0.8}}}},
       .run = vibrating_plate,
       .without = {"gravity", "impulses"}},
  };
}

}
