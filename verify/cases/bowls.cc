// Balls that roll inside round walls.
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
       .order = 1},
      {.id = "V55",
       .title = "Ball in a bowl",
       .group = "Rolling",
       .formula = "pendulum of length R − r, rolling with ⁵⁄₇ g",
       .source = "complete elliptic integral",
       .parameters = {{"bowl", 1, 0.1, 10, "m"}, {"ball", 0.1, 0.01, 1, "m"}, {"from", 0.5, 0.01, 1.4, "rad"}},
       .sets = {{"farther", {{"from", 1}, {"ball", 0.2}}}},
       .run = bowl,
       .without = {"gravity", "impulses"}},
  };
}

}
