// Round bodies that roll: from sliding to rolling, down inclines; rolling resistance.
#include <algorithm>
#include <cmath>

#include "verify/cases/cases.h"
#include "verify/numerics.h"
#include "verify/scene.h"

namespace sudar::verify {

namespace {

// The same as it rolls along x: what is round as a cylinder is one, lying along z.
BodyDef rolling_body(double radius, double k, const Material& m) {
  if (k != 0.5 && k != 1) return round_body(radius, k, m);
  BodyDef def = round_body(radius, k, m);
  def.shape = cylinder(Real(radius), Real(radius));
  def.turn = axis_angle(Vec3{1, 0, 0}, Real(pi / 2));
  return def;
}

const std::vector<ParameterSet> round_bodies = {
    {"cylinder", {{"k", 0.5}}}, {"shell", {{"k", 2.0 / 3}}}, {"hoop", {{"k", 1}}}};

// V17. From sliding to rolling: after t = v₀ k/(μ g (1+k)) it rolls with v₀/(1+k), and goes on so.
void slide_to_roll(Run& run) {
  const double g = standard_gravity, mu = run["friction"], v0 = run["speed"], k = run["k"], r = 0.1;
  const double t = v0 * k / (mu * g * (1 + k)), v = v0 / (1 + k), way = v0 * t - mu * g * t * t / 2;
  World w(run.fine_config());
  add_gravity(run, w);
  const Material m = material(run.with("friction", mu));
  add_ground(w, m);
  BodyDef def = rolling_body(r, k, m);
  def.at = {0, r, 0}, def.velocity = {Real(v0), 0, 0};
  const Body ball = w.add(def);
  const auto slip = [&] { return double(w[ball].velocity().x + w[ball].spin().z * Real(r)); };
  double rolls = std::nan(""), before = v0, at_t = 0, v_rolling = 0, worst = 0;
  Plot& plot = run.plot("Velocity", "t [s]", "v [m/s]");
  run.until(w, t + 10, [&] {
    // The slip falls evenly: from two moments well before its end follows the end.
    if (std::isnan(rolls) && slip() < 0.2 * v0) rolls = w.time() + slip() * w.config().dt / (before - slip());
    before = slip();
    const double now = double(w[ball].velocity().x);
    if (std::fabs(w.time() - t) <= w.config().dt / 2) at_t = w[ball].center().x - now * (w.time() - t);
    if (w.time() > t + 0.1 && v_rolling == 0) v_rolling = now;
    if (v_rolling > 0) worst = std::max(worst, std::fabs(now / v_rolling - 1));
    if (w.time() > 2 * t) return;
    plot.theory.emplace_back(w.time(), std::max(v, v0 - mu * g * w.time()));
    plot.simulation.emplace_back(w.time(), now);
  });
  run.relative("velocity of rolling", "m/s", v, v_rolling, 1e-3);
  run.relative("time until it rolls", "s", t, rolls, 1e-3);
  run.relative("way until then", "m", way, at_t, 1e-3);
  run.below("change of the velocity in the next 10 s", "1", worst, 1e-5);
  run.deviation(std::fabs(at_t - way));
}

// V18. Rolling down an incline: a = g sin α/(1+k), without slip while μ > tan α/(1 + 1/k).
void roll_down(Run& run) {
  const double g = standard_gravity, angle = run["slope"] * pi / 180, k = run["k"], r = 0.1, t = 2;
  const double least = std::tan(angle) / (1 + 1 / k);
  const Quat turn = axis_angle(Vec3{0, 0, -1}, Real(angle));
  Plot& plot = run.plot("Velocity down the incline", "t [s]", "v [m/s]");
  const auto roll = [&](double mu) {  // velocity down the incline, and of the contact point
    World w(run.config());
    add_gravity(run, w);
    const Material m = material(run.with("friction", mu));
    add_ground(w, m, {}, turn);
    BodyDef def = rolling_body(r, k, m);
    def.at = Pos{} + rotate(turn, Vec3{0, Real(r), 0});
    const Body ball = w.add(def);
    run.until(w, t, [&] {
      if (mu <= 2 * least) return;
      plot.theory.emplace_back(w.time(), g * std::sin(angle) / (1 + k) * w.time());
      plot.simulation.emplace_back(w.time(), double(rotate_back(turn, w[ball].velocity()).x));
    });
    const Vec3 v = rotate_back(turn, w[ball].velocity());
    return std::pair{double(v.x), double(v.x + w[ball].spin().z * Real(r))};
  };
  run.relative("acceleration", "m/s²", g * std::sin(angle) / (1 + k), roll(10 * least).first / t, 0.005);
  run.below("slip with 5 % more friction than needed", "m/s", std::fabs(roll(1.05 * least).second), 0.005);
  const double slips = t * g * std::cos(angle) * (1 + 1 / k) * 0.05 * least;  // with 5 % less
  run.relative("slip with 5 % less", "m/s", slips, roll(0.95 * least).second, 0.05);
}

// V29. Rolling and spinning resistance, as lengths; the friction of a cube that spins on its four lower corners.
void resistance(Run& run) {
  const double g = standard_gravity, rho = run["rolling"], r = run["radius"], v = run["speed"];
  World w(run.fine_config());
  add_gravity(run, w);
  Material m = material(0.6);
  m.rolling = Real(run.with("resistance", rho));
  add_ground(w, m);
  const Body ball = w.add({.shape = sphere(Real(r)),
                           .at = {0, r, 0},
                           .velocity = {Real(v), 0, 0},
                           .spin = {0, 0, Real(-v / r)},
                           .mass = 1,
                           .material = m});
  const double a = 5 * rho * g / (7 * r);
  double rest = std::nan("");
  Plot& plot = run.plot("Velocity of a rolling ball", "t [s]", "v [m/s]");
  plot.theory = {{0, v}, {v / a, 0}, {1.1 * v / a, 0}};
  run.until(w, 1.1 * v / a, [&] {
    if (w.steps() % 20 == 0) plot.simulation.emplace_back(w.time(), double(w[ball].velocity().x));
    if (std::isnan(rest) && double(w[ball].velocity().x) < 1e-3 * v) rest = w.time();
  });
  run.deviation(std::fabs(w[ball].center().x - v * v / (2 * a)));
  run.relative("rolling: way to rest", "m", v * v / (2 * a), w[ball].center().x, 0.02);
  run.relative("rolling: time to rest", "s", v / a, rest, 0.02);

  const double twist = run["spinning"], omega = run["spin"];
  World s(run.fine_config());
  add_gravity(run, s);
  m = material(0.6);
  m.spinning = Real(run.with("resistance", twist));
  add_ground(s, m);
  const Body top =
      s.add({.shape = sphere(Real(r)), .at = {0, r, 0}, .spin = {0, Real(omega), 0}, .mass = 1, .material = m});
  const double exact = 0.4 * r * r * omega / (twist * g);
  rest = std::nan("");
  run.until(s, 1.1 * exact, [&] {
    if (std::isnan(rest) && double(s[top].spin().y) < 1e-3 * omega) rest = s.time();
  });
  run.relative("spinning: time to rest", "s", exact, rest, 0.02);

  const double mu = run["friction"], turns = run["cube spin"], edge = 1;
  World c(run.fine_config());
  add_gravity(run, c);
  const Material rough = material(run.with("friction", mu));
  add_ground(c, rough);
  const Body cube = c.add({.shape = box({Real(edge), Real(edge), Real(edge)}),
                           .at = {0, edge / 2, 0},
                           .spin = {0, Real(turns), 0},
                           .mass = 1,
                           .material = rough});
  const double alpha = mu * g * (edge / std::sqrt(2)) / (edge * edge / 6);
  double angle = 0;
  rest = std::nan("");
  run.until(c, 1.2 * turns / alpha, [&] {
    angle += double(c[cube].spin().y) * c.config().dt;
    if (std::isnan(rest) && double(c[cube].spin().y) < 1e-3 * turns) rest = c.time();
  });
  run.relative("cube: time to rest", "s", turns / alpha, rest, 0.02);
  run.relative("cube: turn", "rad", turns * turns / (2 * alpha), angle, 0.02);
}

}

std::vector<Case> rolling() {
  return {
      {.id = "V17",
       .title = "From sliding to rolling",
       .group = "Rolling",
       .formula = "t = v₀ k/(μ g (1+k)), v = v₀/(1+k)",
       .source = "momentum and angular momentum about the contact",
       .parameters = {{"friction", 0.2, 0.02, 1, "1"}, {"speed", 7, 0.5, 20, "m/s"}, {"k", 0.4, 0.05, 1, "m R²"}},
       .sets = round_bodies,
       .run = slide_to_roll,
       .without = {"friction", "gravity"},
       .others = "velocity (5): PhysX 5.00001, Bullet 4.99993, Jolt 4.99986, Havok 4.995, Box3D 4.952, Rapier 4.931",
       .sweep = "the way until it rolls",
       .order = 1},
      {.id = "V18",
       .title = "Rolling down an incline",
       .group = "Rolling",
       .formula = "a = g sin α/(1+k); rolls while μ > tan α/(1 + 1/k)",
       .source = "angular momentum about the contact",
       .parameters = {{"slope", 20, 2, 45, "°"}, {"k", 0.4, 0.05, 1, "m R²"}},
       .sets = round_bodies,
       .run = roll_down,
       .without = {"friction", "gravity"}},
      {.id = "V29",
       .title = "Rolling and spinning resistance, spinning cube",
       .group = "Rolling",
       .formula = "a = 5 ρ g/7R; t = I ω/(ρ_s N); α = μ g ρ_c/(I/m) with ρ_c = a/√2 on four corners",
       .source = "torque = length × normal force",
       .parameters = {{"rolling", 0.002, 1e-4, 0.02, "m"},
                      {"radius", 0.1, 0.01, 1, "m"},
                      {"speed", 2, 0.1, 10, "m/s"},
                      {"spinning", 0.002, 1e-4, 0.02, "m"},
                      {"spin", 25, 1, 200, "rad/s"},
                      {"friction", 0.3, 0.05, 1, "1"},
                      {"cube spin", 10, 1, 30, "rad/s"}},
       .sets = {{"rougher", {{"rolling", 0.005}, {"spinning", 0.001}, {"friction", 0.6}}}},
       .run = resistance,
       .without = {"resistance", "friction", "gravity"},
       .others = "cube: Box3D 0.8167 s, 3.92 rad (exact 0.8009, 4.004)",
       .sweep = "the way that a ball rolls",
       .order = 1},
  };
}

}
