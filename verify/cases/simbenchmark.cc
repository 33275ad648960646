// Tasks of SimBenchmark (Kang & Hwangbo, leggedrobotics/SimBenchmark) with their metrics, in steps without sub-steps as
// there; bouncing is V13b.
#include <algorithm>
#include <cmath>

#include "verify/cases/cases.h"
#include "verify/numerics.h"
#include "verify/scene.h"

namespace sudar::verify {

namespace {

Config single_steps(const Run& run) {
  Config c = run.config();
  c.dt = run["step"], c.substeps = 1;
  c.impulse_2007.slop = Real(run["slop"]);
  return c;
}

// B1. A slab with 25 balls on it is pushed over the floor; the balls roll. Friction ball–slab 0.8, slab–floor 0.4.
void rolling_slab(Run& run) {
  const double g = standard_gravity, m_slab = 10, m_ball = 1, n = 25, r = 0.5, force = run["force"], t = 4;
  const double angle = run["direction"] * pi / 180, friction = run.with("friction", 0.4) * (m_slab + n * m_ball) * g;
  // A ball that rolls on the slab takes the force f, which speeds it up by f/m and its surface by 7/2 f/m.
  const double taken = (force - friction) / m_slab / (3.5 / m_ball + n / m_slab);
  const double a_slab = (force - friction - n * taken) / m_slab, a_ball = taken / m_ball;
  World w(single_steps(run));
  add_gravity(run, w);
  add_ground(w, material(square(run.with("friction", 0.4))));  // mixed geometrically with the slab's 1
  const Body slab =
      w.add({.shape = box({20, 1, 20}), .at = {0, 0.5, 0}, .mass = Real(m_slab), .material = material(1)});
  std::vector<Body> balls;
  for (int i = 0; i < 25; ++i) {
    balls.push_back(w.add({.shape = sphere(Real(r)),
                           .at = {2.0 * (i % 5 - 2), 1 + r, 2.0 * (i / 5 - 2)},
                           .mass = Real(m_ball),
                           .material = material(0.64)}));
  }
  const Vec3d along{std::cos(angle), 0, std::sin(angle)};
  double sum = 0, steps = 0;
  Plot& plot = run.plot("Velocity of the slab", "t [s]", "v [m/s]");
  run.draw(w);
  while (w.time() < t - w.config().dt / 2) {
    w.push(slab, convert<Real>(along * force), w[slab].center());
    w.step();
    const auto off = [&](Body b, double a) {
      const Vec3d d = convert<double>(w[b].velocity()) - along * (a * w.time());
      return dot(d, d);
    };
    sum += off(slab, a_slab) + off(balls[0], a_ball), ++steps;
    if (w.steps() % 50 != 0) continue;
    plot.theory.emplace_back(w.time(), a_slab * w.time());
    plot.simulation.emplace_back(w.time(), dot(convert<double>(w[slab].velocity()), along));
  }
  run.draw(w);
  run.below("mean squared error of the velocities", "m²/s²", sum / steps, 1e-6);
}

// 6 × 6 × 6 balls, each a little off its place.
std::vector<Body> add_666(World& w, double bottom, const Material& m) {
  Random random{1};
  std::vector<Body> balls;
  for (int i = 0; i < 216; ++i) {
    const Pos at{0.21 * (i % 6) + random.between(0, 0.001), bottom + 0.21 * (i / 36) + random.between(0, 0.001),
                 0.21 * (i / 6 % 6) + random.between(0, 0.001)};
    balls.push_back(w.add({.shape = sphere(Real(0.1)), .at = at, .mass = 10, .material = m}));
  }
  return balls;
}

// B2. They fall and scatter without friction; how deep they lie in each other.
void balls_666(Run& run) {
  World w(single_steps(run));
  add_gravity(run, w);
  add_ground(w, material(0));
  const std::vector<Body> balls = add_666(w, 0.101, material(0));
  double sum = 0, steps = 0;
  Plot& plot = run.plot("Sum of the squared overlaps", "t [s]", "m²");
  run.until(w, 10, [&] {
    double now = 0;
    for (const Body b : balls) now += square(std::max(0.0, 0.1 - w[b].center().y));
    for (const Contact& c : w.contacts()) {
      const bool both_balls = w[c.a].motion() == Motion::dynamic && w[c.b].motion() == Motion::dynamic;
      if (both_balls) now += square(std::max(0.0, 0.2 - length(w[c.a].center() - w[c.b].center())));
    }
    sum += now, ++steps;
    if (w.steps() % std::max(1, int(0.05 / run["step"])) == 0) plot.simulation.emplace_back(w.time(), now);
  });
  plot.theory = {{0, 0}, {10, 0}};
  run.below("mean of the squared overlaps", "m²", sum / steps, run["step"] < 0.002 ? 1e-6 : 1e-5);
}

// B3. The same elastic, from 1 m: how well they keep their energy.
void elastic_666(Run& run) {
  World w(single_steps(run));
  add_gravity(run, w);
  const Material m = material(0, run.with("restitution", 1));
  add_ground(w, m);
  add_666(w, 1.101, m);
  const double energy = w.energy().total();
  double sum = 0, steps = 0;
  Plot& plot = run.plot("Energy", "t [s]", "E − E₀ [J]");
  run.until(w, 10, [&] {
    const double off = w.energy().total() - energy;
    sum += off * off, ++steps;
    if (w.steps() % std::max(1, int(0.05 / run["step"])) == 0) plot.simulation.emplace_back(w.time(), off);
  });
  plot.theory = {{0, 0}, {10, 0}};
  // What ODE reaches with 1 ms; an error of first order.
  run.below("mean squared error of the energy", "J²", sum / steps, 112 * square(run["step"] / 1e-3));
}

// B4. A round tower of 102 small blocks: six floors of eight uprights and the eight planks that join them, and six
// planks on the roof. How many steps of 10 ms it stands.
void kapla(Run& run) {
  Config c = single_steps(run);  // of collisions the default passes, if they are fewer
  c.impulse_2007.contact_passes = std::min(c.impulse_2007.contact_passes, int(run["passes"]));
  c.impulse_2007.collision_passes = std::min(c.impulse_2007.collision_passes, int(run["passes"]));
  World w(c);
  add_gravity(run, w);
  const Material m = material(0.6);
  add_ground(w, m);
  Body top;
  double y = 0;
  // A block with its edges radial, upright and tangential, at an eighth of the circle.
  const auto add_block = [&](double eighth, double radius, double height, const Vec3& edges) {
    const double angle = eighth * pi / 4;
    return w.add({.shape = box(edges),
                  .at = {radius * std::cos(angle), height, -radius * std::sin(angle)},
                  .turn = axis_angle(Vec3{0, 1, 0}, Real(angle)),
                  .material = m});
  };
  const double ring = 0.125 / std::sin(pi / 8);  // 25 cm from upright to upright
  const Vec3 upright{Real(0.05), Real(0.2), Real(0.1)}, plank{Real(0.1), Real(0.05), Real(0.2)};
  for (int floor = 0; floor < 6; ++floor, y += 0.25) {
    for (int i = 0; i < 8; ++i)
      add_block(i, ring, y + 0.1, upright), add_block(i + 0.5, ring * std::cos(pi / 8), y + 0.225, plank);
  }
  for (int i = 0; i < 6; ++i) top = add_block(i + 0.5, ring * std::cos(pi / 8), y + 0.025, plank);
  const double start = w[top].center().y;
  Plot& plot = run.plot("Sinking of the top", "step", "m");
  run.draw(w);
  while (double(w.steps()) < run["steps"] && w[top].center().y > start - 0.1) {
    w.step();
    if (w.steps() % 100 == 0) plot.simulation.emplace_back(double(w.steps()), start - w[top].center().y);
  }
  run.draw(w);
  plot.theory = {{0, 0}, {run["steps"], 0}};
  run.check("steps that it stands", "1", run["steps"], double(w.steps()), 0);
}

}

std::vector<Case> simbenchmark() {
  const auto step = [](double s) { return Parameter{"step", s, 1e-5, 0.02, "s"}; };
  const Parameter slop{"slop", 1e-4, 0, 0.01, "m"};
  return {
      {.id = "B1",
       .title = "SimBenchmark: rolling",
       .group = "SimBenchmark",
       .formula = "a ball takes f = (F − μ M g)/m_slab/(7/2m + n/m_slab)",
       .source = "leggedrobotics/SimBenchmark; balls that roll on a slab that slides",
       .parameters = {step(1e-3), {"force", 150, 140, 200, "N"}, {"direction", 60, 0, 360, "°"}, slop},
       .sets = {{"along an edge", {{"direction", 90}}}},
       .run = rolling_slab,
       .without = {"friction"},
       .others = "published, 1 ms: Bullet 3.9e-27, RaiSim 4.1e-7, MuJoCo Newton 6.9e-3, ODE and DART 3.14 (a pyramid "
                 "for the cone); measured: Box3D "
                 "1.2e-6, Rapier 2.9e-6, Jolt 1.7e-4, PhysX 7e-4, Havok 0.29"},
      {.id = "B2",
       .title = "SimBenchmark: 666",
       .group = "SimBenchmark",
       .formula = "balls do not overlap",
       .source = "leggedrobotics/SimBenchmark; 216 balls without friction, 10 s",
       .parameters = {step(1e-2), slop},
       .sets = {{"4 ms", {{"step", 4e-3}}}, {"1 ms", {{"step", 1e-3}}, Effort::full}},
       .run = balls_666,
       .without = {"impulses"},
       .bite = {.values = {{"step", 4e-3}}},
       .effort = Effort::normal,
       .others =
           "10 ms, with stabilisation: PhysX TGS 2.2e-6, Havok 4.3e-6, Jolt 6.9e-6, PhysX PGS 1.6e-5, Rapier 1.7e-5, "
           "Bullet 1.5e-4, MuJoCo "
           "2.2e-4, Box3D 3.5e-3; published, without: RaiSim 0.0153, ODE 0.0161, MuJoCo 0.934, Bullet 37.4, DART 215"},
      {.id = "B3",
       .title = "SimBenchmark: elastic 666",
       .group = "SimBenchmark",
       .formula = "energy constant",
       .source = "leggedrobotics/SimBenchmark; 216 elastic balls from 1 m, 10 s",
       .parameters = {step(1e-3), slop},
       .sets = {{"4 ms", {{"step", 4e-3}}}},
       .run = elastic_666,
       .without = {"restitution"},
       .effort = Effort::normal,
       .others = "1 ms: published RaiSim 8.37, ODE 112, Bullet 4.1e4, DART 3.5e5; measured PhysX PGS 2.9e5, Jolt "
                 "5.4e5, Rapier 1.6e6, Box3D 3.7e7"},
      {.id = "B4",
       .title = "SimBenchmark: Kapla",
       .group = "SimBenchmark",
       .formula = "stands for 60 000 steps of 10 ms",
       .source = "leggedrobotics/SimBenchmark; 102 blocks 5 × 20 × 10 cm",
       .parameters =
           {step(1e-2), slop, {"passes", 80, 1, 80, whole_number}, {"steps", 60000, 100, 60000, whole_number}},
       .sets = {{"40 passes", {{"passes", 40}}}, {"10 passes", {{"passes", 10}}}},
       .run = kapla,
       .without = {"impulses"},
       .bite = {.values = {{"steps", 200}}},
       .effort = Effort::full,
       .others = "steps survived with 10/40/100 iterations: RaiSim 25/89/263, Bullet with ERP 52/334/846, ODE with ERP "
                 "1104/5234/5990; MuJoCo at most 3297, DART 19"},
  };
}

}
