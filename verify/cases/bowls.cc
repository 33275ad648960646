// Balls that roll on what is round or turns: in a pipe and a bowl, off a ball, on a turntable.
#include <algorithm>
#include <cmath>

#include "verify/cases/cases.h"
#include "verify/numerics.h"
#include "verify/scene.h"

namespace sudar::verify {

namespace {

// V54. A ball that circles in a vertical pipe with the rate W: its height swings, with ν² = W² k/(1 + k) and the dip
// 2 g/((1 + k) ν²), for the spin about the wall's normal turns into rolling along the wall.
void pipe(Run& run) {
  const double big = run["pipe"], r = run["ball"], rate = run["rate"], k = 0.4, g = standard_gravity;
  const double nu = rate * std::sqrt(k / (1 + k)), period = 2 * pi / nu, dip = 2 * g / ((1 + k) * nu * nu),
               v = rate * (big - r);
  World w(with_small_slop(run.fine_config()));
  add_gravity(run, w);
  const Material rough = material(10);
  w.add({.shape = hollow_cylinder(Real(big), Real(20)), .material = rough, .motion = Motion::fixed});
  const Body ball = w.add({.shape = sphere(Real(r)),
                           .at = {big - r, 0, 0},
                           .velocity = {0, 0, Real(-v)},
                           .spin = {0, Real(-v / r), 0},
                           .mass = 1,
                           .material = rough});
  Crossings turns;  // of the vertical velocity
  double lowest = 0;
  Plot& plot = run.plot("Height", "t [s]", "y [m]");
  run.until(w, 2.2 * period, [&] {
    const double y = w[ball].center().y;
    turns.sample(w.time(), double(w[ball].velocity().y));
    if (turns.moments().size() < 2) lowest = std::min(lowest, y);
    plot.theory.emplace_back(w.time(), -dip / 2 * (1 - std::cos(nu * w.time())));
    plot.simulation.emplace_back(w.time(), y);
  });
  const auto& t = turns.moments();
  run.relative("vertical period", "s", period, t.size() > 2 ? t[2] - t[0] : std::nan(""), 0.02);
  run.relative("dip", "m", dip, -lowest, 0.02);
  run.deviation(std::fabs(dip + lowest));
}

// V55. A ball in a bowl is a pendulum of the length R − r; rolling slows it as if g were ⁵⁄₇ g.
void bowl(Run& run) {
  const double big = run["bowl"], r = run["ball"], start = run["from"], g = standard_gravity;
  for (const bool rolls : {true, false}) {
    const double slower = rolls ? 7.0 / 5 : 1, l = big - r;
    const double period = 4 * std::sqrt(slower * l / g) * elliptic_k(square(std::sin(start / 2)));
    World w(with_small_slop(run.fine_config()));
    add_gravity(run, w);
    const Material m = material(rolls ? 10 : 0);
    w.add({.shape = hollow_sphere(Real(big)), .material = m, .motion = Motion::fixed});
    const Body ball = w.add(
        {.shape = sphere(Real(r)), .at = {l * std::sin(start), -l * std::cos(start), 0}, .mass = 1, .material = m});
    const auto law = [&](double, const Vector& y) { return Vector{y[1], -g / (slower * l) * std::sin(y[0])}; };
    Crossings zeros;
    Vector exact{start, 0};
    Plot& plot = run.plot(rolls ? "Angle, rolling" : "Angle, sliding without friction", "t [s]", "θ [rad]");
    run.until(w, 2.3 * period, [&] {
      const double angle = std::atan2(w[ball].center().x, -w[ball].center().y);
      zeros.sample(w.time(), angle);
      exact = solve_ode(law, 0, exact, w.config().dt);
      plot.theory.emplace_back(w.time(), exact[0]);
      plot.simulation.emplace_back(w.time(), angle);
    });
    const auto& t = zeros.moments();
    run.relative(rolls ? "period, rolling" : "period, smooth", "s", period, t.size() > 2 ? t[2] - t[0] : std::nan(""),
                 0.005);
  }
}

// V53. A ball on a turntable goes round a circle with two sevenths of the table's rate.
void turntable(Run& run) {
  const double r = 0.05, omega = run["rate"], x0 = run["start"], v0 = run["speed"];
  World w(run.config());
  add_gravity(run, w);
  const Material m = material(run.with("friction", 1));
  w.add({.shape = cylinder(2, 1),
         .at = {0, -0.5, 0},
         .spin = {0, Real(omega), 0},
         .material = m,
         .motion = Motion::kinematic});
  // Seen from above with the second axis along −z; the lowest point moves with the table: v + ω × (−r ŷ) = Ω × x.
  const Vec3 at{Real(x0), 0, 0}, velocity{0, 0, Real(-v0)}, table = cross(Vec3{0, Real(omega), 0}, at),
                                                            slip = table - velocity;
  const Vec3 spin = cross(slip, Vec3{0, 1, 0}) * Real(1 / r);
  const Body ball =
      w.add({.shape = sphere(Real(r)), .at = {x0, r, 0}, .velocity = velocity, .spin = spin, .mass = 1, .material = m});
  const double rate = 2 * omega / 7, radius = v0 / rate, center = x0 - radius;
  const auto exact = [&](double t) {
    return std::pair{center + radius * std::cos(rate * t), radius * std::sin(rate * t)};
  };
  Plot& plot = run.plot("Path from above", "x [m]", "−z [m]");
  double at_two = std::nan(""), radius_seen = 0;
  run.until(w, 16.7, [&] {
    const Pos p = w[ball].center();
    const auto [x, y] = exact(w.time());
    plot.theory.emplace_back(x, y);
    plot.simulation.emplace_back(p.x, -p.z);
    if (std::fabs(w.time() - 2) < 1e-6) at_two = std::hypot(p.x - x, -p.z - y);
    radius_seen = std::hypot(p.x - center, p.z);
  });
  run.below("distance from the exact place at 2 s", "m", at_two, 5e-4);
  run.relative("radius at 16.7 s", "m", radius, radius_seen, 0.01);
}

// V56. A ball leaves the ball that it runs down at cos θ = 2 cos θ₀/(3 + k); k = 0 where it slides without friction.
void leaves_ball(Run& run) {
  const double g = standard_gravity, big = run["big"], r = run["small"], start = run["from"], k = run["k"],
               gap = run["gap"];
  const double distance = big + r, leaves = 2 * std::cos(start) / (3 + k);
  // Then it flies: the cosine when the gap is so wide.
  const double sine = std::sqrt(1 - leaves * leaves), v = std::sqrt(distance * g * leaves);
  const auto flown = [&](double t) {
    return std::pair{distance * sine + v * leaves * t, distance * leaves - v * sine * t - g * t * t / 2};
  };
  const double t =
      root([&](double s) { return std::hypot(flown(s).first, flown(s).second) - distance - gap; }, 1e-3, 1);
  const double exact = flown(t).second / (distance + gap);
  World w(run.fine_config());
  add_gravity(run, w);
  const Material m = material(k > 0 ? 100 : 0);
  w.add({.shape = sphere(Real(big)), .material = m, .motion = Motion::fixed});
  BodyDef def = round_body(r, k > 0 ? k : 0.4, m);
  def.at = {distance * std::sin(start), distance * std::cos(start), 0};
  const Body ball = w.add(def);
  double got = std::nan(""), gap_before = 0, cosine_before = 1;
  Plot& plot = run.plot("Distance of the surfaces", "cos θ", "gap [m]");
  run.until(w, 10, [&] {
    const Pos p = w[ball].center();
    const double d = std::hypot(p.x, p.y), c = p.y / d;
    if (d - distance < 3 * gap && c > 0) plot.simulation.emplace_back(c, d - distance);
    if (std::isnan(got) && d - distance > gap) {
      const double share = (gap - gap_before) / (d - distance - gap_before);
      got = cosine_before + share * (c - cosine_before);
    }
    gap_before = d - distance, cosine_before = c;
  });
  for (int i = 0; i <= 30; ++i) {
    const auto [x, y] = flown(1.5 * t * i / 30);
    plot.theory.emplace_back(y / std::hypot(x, y), std::hypot(x, y) - distance);
  }
  run.check("cosine at the gap", "1", exact, got, 0.005);
}

}

std::vector<Case> bowls() {
  return {
      {.id = "V54",
       .title = "Ball in a vertical pipe",
       .group = "Rolling",
       .formula = "vertical period 2π/(√(²⁄₇) W), dip 2 g/((1+k) ν²)",
       .source = "Gualtieri et al., Am. J. Phys. 74 (2006) 497",
       .parameters = {{"pipe", 0.5, 0.1, 10, "m"}, {"ball", 0.05, 0.005, 1, "m"}, {"rate", 8, 3, 50, "rad/s"}},
       .sets = {{"faster", {{"rate", 12}, {"ball", 0.1}}}},
       .run = pipe,
       .without = {"gravity", "impulses"},
       .bite = {.substeps = 64},
       .sweep = "the dip",
       .order = 2},
      {.id = "V55",
       .title = "Ball in a bowl",
       .group = "Rolling",
       .formula = "pendulum of length R − r, rolling with ⁵⁄₇ g",
       .source = "complete elliptic integral",
       .parameters = {{"bowl", 1, 0.1, 10, "m"}, {"ball", 0.1, 0.01, 1, "m"}, {"from", 0.5, 0.01, 1.4, "rad"}},
       .sets = {{"farther", {{"from", 1}, {"ball", 0.2}}}},
       .run = bowl,
       .without = {"gravity", "impulses"}},
      {.id = "V53",
       .title = "Ball on a turntable",
       .group = "Rolling",
       .formula = "circle with rate ²⁄₇ Ω, radius 7 v/2Ω",
       .source = "Weltner, Am. J. Phys. 47 (1979) 984",
       .parameters = {{"rate", 3, 0.2, 10, "rad/s"}, {"start", 0.3, 0, 1, "m"}, {"speed", 0.2, 0.01, 1, "m/s"}},
       .sets = {{"slow", {{"rate", 1.5}, {"speed", 0.1}}}},
       .run = turntable,
       .without = {"friction"},
       .others =
           "error at 2 s: Havok 2.7 mm, Jolt, PhysX TGS 2.9, Box3D, Rapier 3.8; the radius of all grows by 9 … 11 %"},
      {.id = "V56",
       .title = "Ball that leaves a ball",
       .group = "Rolling",
       .formula = "cos θ = 2 cos θ₀/(3 + k): smooth k = 0, solid ²⁄₅, hoop 1; then free flight",
       .source = "energy and the vanishing normal force",
       .parameters = {{"big", 1, 0.1, 10, "m"},
                      {"small", 0.1, 0.01, 1, "m"},
                      {"from", 0.1, 0.02, 0.5, "rad"},
                      {"k", 0, 0, 1, "m R²"},
                      {"gap", 0.02, 0.001, 0.1, "m"}},
       .sets = {{"solid", {{"k", 0.4}}}, {"hoop", {{"k", 1}}}},
       .run = leaves_ball,
       .without = {"gravity", "impulses"},
       .others = "smooth, solid (exact 0.3592, 0.2803): Jolt 0.3677, 0.2887; PhysX 0.3678, 0.2898; Rapier –, 0.289"},
  };
}

}
