// Things that tip, fall over and slide off: rocking block, ladder, falling rods, a rod at Painlevé's paradox.
#include <algorithm>
#include <cmath>

#include "verify/cases/cases.h"
#include "verify/numerics.h"
#include "verify/scene.h"

namespace sudar::verify {

namespace {

// V19. A block rocks from one edge to the other; each impact takes 1.5 sin² α of its rate (Housner).
void rocking(Run& run) {
  const double b = run["width"], h = run["height"], g = standard_gravity, m = 1;
  const double alpha = std::atan(b / h), reach = std::hypot(b, h) / 2, start = run["share"] * alpha;
  const double p2 = m * g * reach / (4.0 / 3 * m * reach * reach);  // θ¨ = −p² sin(α − θ), about the edge
  const auto law = [&](double, const Vector& y) { return Vector{y[1], -p2 * std::sin(alpha - y[0])}; };
  const Moment down = solve_until(law, 0, {start, 0}, 100, [](double, const Vector& y) { return -y[0]; });
  const double ratio = 1 - 1.5 * square(std::sin(alpha));
  World w(run.fine_config());
  add_gravity(run, w);
  const Material m_ = material(10);
  add_ground(w, m_);
  // Tilted about its edge at the origin: the centre is at (−b/2, h/2) turned by −θ.
  const Quat turn = axis_angle(Vec3{0, 0, 1}, Real(start));
  const Body block = w.add({.shape = box({Real(b), Real(h), Real(b)}),
                            .at = Pos{} + rotate(convert<double>(turn), Vec3d{b / 2, h / 2, 0}),
                            .turn = turn,
                            .mass = Real(m),
                            .material = m_});
  const auto angle = [&] {
    const Vec3 up = rotate(w[block].pose().q, Vec3{0, 1, 0});
    return std::atan2(-double(up.x), double(up.y));
  };
  // The rate at θ = 0 on the way of the law that the block is on.
  const auto at_zero = [&](double theta, double rate) {
    return std::sqrt(std::max(0.0, rate * rate + 2 * p2 * (std::cos(alpha - std::fabs(theta)) - std::cos(alpha))));
  };
  double before = 0, after = std::nan(""), t = std::nan(""), last = start;
  int since = -1;
  Plot& plot = run.plot("Tilt", "t [s]", "θ [rad]");
  run.until(w, 1.5 * down.t, [&] {
    const double theta = angle(), rate = double(w[block].spin().z);
    plot.simulation.emplace_back(w.time(), theta);
    if (since < 0 && theta > 0) before = at_zero(theta, rate), last = theta;
    if (since < 0 && theta <= 0) t = w.time() - w.config().dt * theta / (theta - last), since = 0;
    if (since >= 0 && ++since == 5) after = at_zero(theta, rate);
  });
  for (int k = 0; k <= 40; ++k)
    plot.theory.emplace_back(down.t * k / 40, solve_ode(law, 0, {start, 0}, down.t * k / 40)[0]);
  run.deviation(std::fabs(before + down.y[1]));
  run.relative("time of the impact", "s", down.t, t, 0.03);
  run.relative("rate before it", "rad/s", -down.y[1], before, 0.03);
  run.relative("rate after / before", "1", ratio, after / before, 0.03);
}

// A thin rod with round ends that leans with its foot at x = 0 against a wall on the right of it, at an angle from
// level.
constexpr double rod_radius = 1e-3;
BodyDef leaning_rod(double length, double angle, const Material& m) {
  const Real across = Real(length * length / 12);
  return {.shape = capsule(Real(rod_radius), Real(length)),
          .at = {length / 2 * std::cos(angle), length / 2 * std::sin(angle) + rod_radius, 0},
          .turn = axis_angle(Vec3{0, 0, 1}, Real(angle - pi / 2)),
          .mass = 1,
          .inertia = Mat3::diagonal({across, across / 1000, across}),
          .material = m};
}
double elevation(const BodyView& rod) {
  const Vec3 along = rotate(rod.pose().q, Vec3{0, 1, 0});
  return std::atan2(double(along.y), double(along.x));
}

// V20. A ladder: stands when tan θ > 1/2μ (smooth wall) or (1−μ²)/2μ (rough wall); without friction it leaves the wall
// at sin θ = ⅔ sin θ₀.
World ladder(Run& run, double length, double angle, double floor, double wall) {
  World w(run.fine_config());
  add_gravity(run, w);
  add_ground(w, material(floor));
  const double x = length * std::cos(angle) + rod_radius;
  const Body side = w.add({.shape = half_space(),
                           .at = {x, 0, 0},
                           .turn = axis_angle(Vec3{0, 0, 1}, Real(pi / 2)),
                           .material = material(wall),
                           .motion = Motion::fixed});
  static_cast<void>(side);
  BodyDef rod = leaning_rod(length, angle, material(1));
  rod.name = "ladder";
  w.add(rod);
  return w;
}

void lean(Run& run) {
  const double mu = run["friction"], l = run["length"], g = standard_gravity, degree = pi / 180;
  const double rough = run.with("friction", mu);
  // Mixed geometrically with the rod's 1: a surface of μ² makes a pair of μ.
  const auto stands = [&](double angle, double wall) {
    World w = ladder(run, l, angle, square(rough), square(wall));
    run.until(w, 3);
    return std::fabs(elevation(w[w.find("ladder")]) - angle) < 0.5 * degree;
  };
  const double smooth = std::atan(1 / (2 * mu)), both = std::atan((1 - mu * mu) / (2 * mu));
  run.holds("smooth wall: stands 1° above the limit", stands(smooth + degree, 0));
  run.holds("smooth wall: slides 1° below", !stands(smooth - degree, 0));
  run.holds("rough wall: stands 1° above the limit", stands(both + degree, rough));
  run.holds("rough wall: slides 1° below", !stands(both - degree, rough));

  const double start = run["start"] * degree;
  World w = ladder(run, l, start, 0, 0);
  const Body rod = w.find("ladder");
  double leaves = std::nan(""), t = std::nan("");
  Plot& plot = run.plot("Elevation, no friction", "t [s]", "θ [rad]");
  run.until(w, 2, [&] {
    bool pressed = false;
    for (const Contact& c : w.contacts()) {
      const bool at_wall = std::fabs(double(c.normal.x)) > 0.5;
      for (int k = 0; k < c.count; ++k) pressed |= at_wall && c.points[std::size_t(k)].normal_impulse > 0;
    }
    if (w.time() > 0.1 && std::isnan(leaves) && !pressed) leaves = elevation(w[rod]), t = w.time();
    if (w.time() < 0.8) plot.simulation.emplace_back(w.time(), elevation(w[rod]));
  });
  const double exact = std::asin(2.0 / 3 * std::sin(start));
  // After it has sunk by the angle d: sin θ₀ − sin(θ₀ − d) without cancellation.
  const auto rate = [&](double d) { return std::sqrt(6 * g / l * std::cos(start - d / 2) * std::sin(d / 2)); };
  const double time = time_from_rest(rate, start - exact);
  for (int k = 1; k <= 40; ++k) {
    const double d = (start - exact) * square(k / 40.0);
    plot.theory.emplace_back(time_from_rest(rate, d), start - d);
  }
  run.check("no friction: leaves the wall at", "°", exact / degree, leaves / degree, 1);
  run.relative("no friction: leaves it after", "s", time, t, 0.02);
}

// V57. Rods that fall from the upright: pinned, and on a smooth floor; both arrive with ω = √(3 g cos θ₀/L). Let go
// level, a pinned rod's tip falls with 1.5 g and its pin bears m g/4.
void falling_rods(Run& run) {
  const double l = run["length"], start = run["from"], g = standard_gravity;
  const double end = run["to"];  // where the rod is timed, from upright
  // After it has turned by d: cos θ₀ − cos(θ₀ + d) without cancellation.
  const auto energy = [&](double d) { return 2 * std::sin(start + d / 2) * std::sin(d / 2); };
  const auto pinned = [&](double d) { return std::sqrt(3 * g / l * energy(d)); };
  const auto smooth = [&](double d) {
    return std::sqrt(12 * g / l * energy(d) / (1 + 3 * square(std::sin(start + d))));
  };
  for (const bool pin : {true, false}) {
    const auto exact = [&](double d) { return pin ? pinned(d) : smooth(d); };
    World w(run.fine_config());
    add_gravity(run, w);
    if (!pin) add_ground(w, material(0));
    const Body rod = w.add(leaning_rod(l, pi / 2 - start, material(0)));
    if (pin) w.join(Hinge{.b = rod, .at = {0, rod_radius, 0}});
    double t = std::nan(""), rate = std::nan(""), before = start, rate_before = 0;
    Plot& plot = run.plot(pin ? "Rate, pinned" : "Rate on a smooth floor", "angle from upright [rad]", "ω [rad/s]");
    run.until(w, 2, [&] {
      const double a = pi / 2 - elevation(w[rod]), omega = -double(w[rod].spin().z);
      if (a <= end)
        plot.simulation.emplace_back(a, omega), plot.theory.emplace_back(a, a > start ? exact(a - start) : 0);
      if (std::isnan(t) && a >= end) {
        const double share = (end - before) / (a - before);
        t = w.time() - w.config().dt * (1 - share);
        rate = rate_before + share * (omega - rate_before);
      }
      before = a, rate_before = omega;
    });
    const double time = time_from_rest(exact, end - start);
    const std::string name = pin ? "pinned: " : "smooth floor: ";
    if (!pin) run.deviation(std::fabs(rate - exact(end - start)));
    run.relative(name + "time", "s", time, t, 0.005);
    run.relative(name + "rate", "rad/s", exact(end - start), rate, 0.005);
  }
  World w(run.fine_config());
  add_gravity(run, w);
  const Body rod = w.add(leaning_rod(l, 0, material(0)));
  const Joint pin = w.join(Hinge{.b = rod, .at = {0, rod_radius, 0}});
  w.step();
  run.relative("let go level: acceleration of the tip", "m/s²", 1.5 * g, -double(w[rod].spin().z) * l / w.config().dt,
               0.005);
  run.relative("let go level: force of the pin", "N", g / 4, double(w[pin].load().force.y), 0.005);
}

// V34. Painlevé: a rod slides foot first with more friction than rigid bodies allow (μ > ⁴⁄₃ at tan θ = 2): no force
// solves it, but an impulse does. The engine has to give a finite one, and no energy.
void painleve(Run& run) {
  const double mu = run["friction"], angle = run["elevation"] * pi / 180, v = run["speed"], l = 1;
  World w(run.fine_config());
  add_gravity(run, w);
  add_ground(w, material(mu));
  BodyDef def = leaning_rod(l, angle, material(mu));
  def.velocity = {Real(-v), 0, 0};  // away from where the rod leans: its friction digs the foot in
  const Body rod = w.add(def);
  const double start = w.energy().total();
  double gained = 0, hardest = 0, deepest = 0;
  Plot& plot = run.plot("Energy", "t [s]", "E − E₀ [J]");
  run.until(w, 1, [&] {
    const double energy = w.energy().total() - start;
    gained = std::max(gained, std::isfinite(energy) ? energy : 1e9);
    plot.simulation.emplace_back(w.time(), energy);
    for (const Contact& c : w.contacts()) {
      for (int k = 0; k < c.count; ++k) {
        hardest = std::max(hardest, double(c.points[std::size_t(k)].normal_impulse));
        deepest = std::max(deepest, -double(c.points[std::size_t(k)].separation));
      }
    }
  });
  plot.theory = {{0, 0}, {1, 0}};
  const double limit = (1 + 3 * square(std::cos(angle))) / (3 * std::sin(angle) * std::cos(angle));  // of μ
  run.holds("is a paradox: μ above its limit", mu > limit);
  run.holds("state stays finite",
            is_finite(w[rod].velocity()) && is_finite(w[rod].spin()) && w.events().quarantined.empty());
  run.below("energy gained / at the start", "1", gained / start, 1e-3);
  run.below("largest impulse of the floor", "N s", hardest, 10 * v);
  run.below("deepest penetration", "m", deepest, 0.01);
}

}

std::vector<Case> toppling() {
  return {
      {.id = "V19",
       .title = "Rocking block",
       .group = "Toppling",
       .formula = "θ¨ = −p² sin(α − θ), p² = 3 g/4R; impact ω' = (1 − 1.5 sin² α) ω",
       .source = "Housner 1963; independent solution, Dormand & Prince 5(4)",
       .parameters = {{"width", 0.5, 0.05, 1, "m"}, {"height", 2, 0.2, 5, "m"}, {"share", 0.5, 0.1, 0.9, "of α"}},
       .sets = {{"slender", {{"width", 0.3}}}},
       .run = rocking,
       .without = {"gravity", "impulses"},
       .others = "Box3D: −0.532 → −0.452 rad/s (exact −0.565 → −0.515)",
       .sweep = "the rate before the impact",
       .order = 1},
      {.id = "V20",
       .title = "Ladder",
       .group = "Toppling",
       .formula = "tan θ = 1/2μ, (1 − μ²)/2μ; without friction it leaves the wall at sin θ = ⅔ sin θ₀",
       .source = "statics; energy of the sliding ladder",
       .parameters = {{"friction", 0.4, 0.1, 0.9, "1"}, {"length", 2, 0.5, 10, "m"}, {"start", 75, 40, 85, "°"}},
       .sets = {{"rougher", {{"friction", 0.6}, {"start", 65}}}},
       .run = lean,
       .without = {"friction", "gravity", "impulses"}},
      {.id = "V34",
       .title = "Painlevé's rod",
       .group = "Toppling",
       .formula = "no force solves it when μ > (1 + 3 cos² θ)/(3 sin θ cos θ): an impulse must, without making energy",
       .source = "Painlevé 1895; Champneys & Várkonyi 2016",
       .parameters = {{"friction", 1.6, 0.5, 5, "1"},
                      {"elevation", 63.434948822922, 20, 85, "°"},
                      {"speed", 3, 0.1, 20, "m/s"}},
       .sets = {{"rougher", {{"friction", 2}, {"elevation", 55}}}},
       .run = painleve,
       .without = {"impulses"}},
      {.id = "V57",
       .title = "Falling rods",
       .group = "Toppling",
       .formula = "pinned ω² = 3 g/L (cos θ₀ − cos θ); smooth floor ω² = 12 g/L (cos θ₀ − cos θ)/(1 + 3 sin² θ)",
       .source = "energy; quadrature of the time",
       .parameters = {{"length", 1, 0.2, 10, "m"}, {"from", 0.1, 0.02, 1, "rad"}, {"to", 1.5, 1.1, 1.55, "rad"}},
       .sets = {{"from 0.3 rad", {{"from", 0.3}, {"length", 2}}}},
       .run = falling_rods,
       .without = {"gravity", "impulses"},
       .bite = {.substeps = 8},
       .sweep = "the rate on a smooth floor",
       .order = 1},
  };
}

}
