// Bodies that nothing touches: free fall, drag, an oscillator, an orbit.
#include <algorithm>
#include <cmath>

#include "verify/cases/cases.h"
#include "verify/numerics.h"
#include "verify/scene.h"

namespace sudar::verify {

namespace {

// V01. Symplectic Euler falls in steps of h: v = −g h N, y = y₀ − ½ g h² N (N+1).
void free_fall(Run& run) {
  const double g = standard_gravity, t = run["time"], y0 = run["height"];
  World w(run.config());
  add_gravity(run, w);
  const Body b = w.add({.shape = sphere(0.1), .at = {0, y0, 0}, .mass = Real(run["mass"])});
  Plot& plot = run.plot("Height", "t [s]", "y [m]");
  run.until(w, t, [&] {
    plot.theory.emplace_back(w.time(), y0 - g * square(w.time()) / 2);
    plot.simulation.emplace_back(w.time(), w[b].center().y);
  });
  const double h = run.h(), steps = std::round(t / h), v = -g * h * steps;
  const double y_got = w[b].center().y, v_got = double(w[b].velocity().y);
  const double tolerance = by_precision(5e-5, 1e-11);
  run.check("height", "m", y0 - g * h * h * steps * (steps + 1) / 2, y_got, tolerance);
  run.check("velocity", "m/s", v, v_got, tolerance);
  const double energy = square(v_got) / 2 + g * (y_got - y0);
  run.check("energy error a kilogram", "J/kg", g * h * v / 2, energy, tolerance * std::fabs(v));
  run.deviation(std::fabs(y_got - (y0 - g * t * t / 2)));
}

// V02. Linear drag, implicit: v ← (v + g h) / (1 + k h).
void linear_drag(Run& run) {
  const double g = standard_gravity, k = run["drag"], t = run["time"], vx = run["vx"], vy = run["vy"];
  World w(run.config());
  add_gravity(run, w);
  if (!run.without("drag")) w.add(Drag{.linear = Real(k)});
  const Body b = w.add({.shape = sphere(0.1), .velocity = {Real(vx), Real(vy), 0}});
  const auto exact = [&](double s) {
    const double e = std::exp(-k * s);
    return std::pair{vx / k * (1 - e), (vy + g / k) / k * (1 - e) - g / k * s};
  };
  Plot& plot = run.plot("Path", "x [m]", "y [m]");
  run.until(w, t, [&] {
    plot.theory.push_back(exact(w.time()));
    plot.simulation.emplace_back(w[b].center().x, w[b].center().y);
  });
  // vₙ = v₀ rⁿ − g h r (1 − rⁿ)/(1 − r), summed over the steps.
  const double h = run.h(), n = std::round(t / h), r = 1 / (1 + k * h), rn = std::pow(r, n);
  const double sum = r * (1 - rn) / (1 - r), terminal = g * h * r / (1 - r);
  const double x = h * vx * sum, y = h * (vy * sum - terminal * (n - sum));
  const double vx_end = vx * rn, vy_end = vy * rn - terminal * (1 - rn);
  const double share = by_precision(1e-5, 1e-11);
  const Pos at = w[b].center();
  const Vec3d v = convert<double>(w[b].velocity());
  run.relative("x, discrete law", "m", x, at.x, share);
  run.relative("y, discrete law", "m", y, at.y, share);
  run.relative("vx, discrete law", "m/s", vx_end, v.x, share);
  run.relative("vy, discrete law", "m/s", vy_end, v.y, share);
  run.deviation(std::hypot(at.x - exact(t).first, at.y - exact(t).second));
}

// V03. Drag that grows with the square of speed.
void quadratic_drag(Run& run) {
  const double g = standard_gravity, vt = run["terminal speed"], up = run["upward"];
  const auto thrown = [&](const Vec3& velocity) {
    World w(run.fine_config());
    add_gravity(run, w);
    if (!run.without("drag")) w.add(Drag{.quadratic = Real(g / square(vt))});
    w.add({.shape = sphere(0.1), .velocity = velocity, .name = "ball"});
    return w;
  };
  const auto ball = [](const World& w) { return w[w.find("ball")]; };

  World fall = thrown({});
  const double t = run["fall"];
  const auto depth = [&](double s) { return vt * vt / g * std::log(std::cosh(g * s / vt)); };
  Plot& plot = run.plot("Fall from rest", "t [s]", "y [m]");
  run.until(fall, t, [&] {
    plot.theory.emplace_back(fall.time(), -depth(fall.time()));
    plot.simulation.emplace_back(fall.time(), ball(fall).center().y);
  });
  run.relative("depth fallen", "m", depth(t), -ball(fall).center().y, 0.01);
  run.relative("speed of fall", "m/s", vt * std::tanh(g * t / vt), -double(ball(fall).velocity().y), 0.01);
  run.deviation(std::fabs(ball(fall).center().y + depth(t)));

  World rise = thrown({0, Real(up), 0});
  Crossings apex;
  double highest = 0;
  run.until(rise, 2 * up / g, [&] {
    apex.sample(rise.time(), double(ball(rise).velocity().y));
    highest = std::max(highest, ball(rise).center().y);
  });
  run.relative("time to the apex", "s", vt / g * std::atan(up / vt), apex.first(), 0.01);
  run.relative("apex", "m", vt * vt / (2 * g) * std::log(1 + square(up / vt)), highest, 0.01);

  const double v = run["oblique"], flight = run["flight"];
  World oblique = thrown({Real(v), Real(v), 0});
  run.until(oblique, flight);
  const auto law = [&](double, const Vector& y) {
    const double k = g / square(vt) * std::hypot(y[2], y[3]);
    return Vector{y[2], y[3], -k * y[2], -k * y[3] - g};
  };
  const Vector end = solve_ode(law, 0, {0, 0, v, v}, flight);
  run.relative("oblique throw, x", "m", end[0], ball(oblique).center().x, 0.01);
  run.relative("oblique throw, y", "m", end[1], ball(oblique).center().y, 0.01);
}

// V52. Symplectic Euler on x'' = −ω² x turns the phase by φ = 2 asin(ω h/2) a step, and keeps a shadow energy.
void oscillator(Run& run) {
  const double omega = run["omega"], m = 2;
  Config c = run.config();
  c.substeps = 1;  // a push lasts a step
  World w(c);
  const Body b = w.add({.shape = sphere(0.1), .at = {1, 0, 0}, .mass = Real(m)});
  const double n = run["steps"], dt = c.dt;
  const double phi = 2 * std::asin(omega * dt / 2), sine = -square(omega * dt) / (2 * std::sin(phi));
  const auto exact = [&](double k) { return std::cos(k * phi) + sine * std::sin(k * phi); };
  Plot& plot = run.plot("The last hundred steps", "t [s]", "x [m]");
  run.draw(w);
  double worst = 0;
  for (double k = 1; k <= n; ++k) {
    const Pos at = w[b].center();
    w.push(b, {Real(-run.with("spring", m * omega * omega * at.x)), 0, 0}, at);
    w.step();
    const double x = w[b].center().x, v = double(w[b].velocity().x);
    const double shadow = v * v / 2 + square(omega * x) / 2 - dt * omega * omega * x * v / 2;
    worst = std::max(worst, std::fabs(shadow / (omega * omega / 2) - 1));
    if (k < n - 100) continue;
    plot.theory.emplace_back(k * dt, exact(k));
    plot.simulation.emplace_back(k * dt, x);
  }
  run.draw(w);
  const double tolerance = by_precision(1e-5, 1e-11);
  run.check("x at the end", "m", exact(n), w[b].center().x, tolerance);
  run.below("shadow energy, largest relative error", "1", worst, tolerance);
}

// V09. Kick and drift keep a circular orbit exactly on its circle, with a phase step of φ = 2 asin(ω Δt/2), when the
// velocity starts half a step early: v₀ = (x₀ − x₋₁)/Δt. The unit of length is 1 AU.
void orbit(Run& run) {
  constexpr double astronomical_unit = 1.495978707e11, sun = 1.32712440018e20;  // m; G M, m³/s² (IAU 2015)
  const double radius = run["radius"], mu = sun / std::pow(astronomical_unit, 3);
  Config c = run.config();
  c.substeps = 1;
  c.time_factor = Real(run["time factor"]);
  const double dt = c.dt * double(c.time_factor), omega = std::sqrt(mu / std::pow(radius, 3));
  const double phi = 2 * std::asin(omega * dt / 2);
  World w(c);
  w.add(NBody{.gravitational_constant = Real(run.with("gravity", mu))});
  w.add({.shape = sphere(0.005), .mass = 1, .motion = Motion::fixed});
  const Vec3d v{radius * (1 - std::cos(phi)) / dt, 0, -radius * std::sin(phi) / dt};
  const Body planet =
      w.add({.shape = sphere(0.001), .at = {radius, 0, 0}, .velocity = convert<Real>(v), .mass = Real(1e-6)});
  const double steps = std::round(run["orbits"] * 2 * pi / phi);
  double worst = 0, lag = 0;
  Plot& plot = run.plot("Radius", "orbits", "r/r₀ − 1");
  run.draw(w);
  for (double n = 1; n <= steps; ++n) {
    w.step();
    if (n == std::round(pi / 2 / phi)) run.draw(w);
    const Pos p = w[planet].center();
    const double drift = std::hypot(p.x, p.z) / radius - 1, turned = std::atan2(-p.z, p.x);
    worst = std::max(worst, std::fabs(drift));
    lag = std::remainder(turned - n * phi, 2 * pi);
    if (std::fmod(n, std::ceil(steps / 500)) == 0) plot.simulation.emplace_back(n * phi / (2 * pi), drift);
  }
  plot.theory = {{0, 0}, {run["orbits"], 0}};
  run.below("largest drift of the radius", "1", worst, 1e-6);
  run.check("phase error against the formula, per orbit", "rad", 0, lag / run["orbits"], 1e-9);
}

}

std::vector<Case> free_bodies() {
  return {
      {.id = "V01",
       .title = "Free fall",
       .group = "Free bodies",
       .formula = "symplectic Euler: v = −g h N, y = y₀ − ½ g h² N (N + 1); energy error ½ g h v per kilogram",
       .source = "sum of the discrete law; Hairer, Lubich, Wanner, Geometric Numerical Integration, I.1",
       .parameters = {{"height", 10, 1, 1000, "m"}, {"mass", 1, 1e-3, 1e6, "kg"}, {"time", 2, 0.1, 20, "s"}},
       .sets = {{"4 kg", {{"mass", 4}}}, {"1 s", {{"time", 1}, {"height", 5}}}},
       .run = free_fall,
       .without = {"gravity"},
       .others = "Jolt, Bullet, PhysX 8.9e-6 m; Box3D 4.9e-5 m (float); MuJoCo 3e-14 m",
       .sweep = "the distance from the continuous law",
       .order = 1},
      {.id = "V02",
       .title = "Projectile with linear drag",
       .group = "Free bodies",
       .formula = "v ← (v + g h)/(1 + k h); continuous: x = v₀/k (1 − e^(−kt))",
       .source = "geometric sum of the implicit step",
       .parameters = {{"drag", 0.5, 0.01, 20, "1/s"},
                      {"vx", 10, -100, 100, "m/s"},
                      {"vy", 15, -100, 100, "m/s"},
                      {"time", 2, 0.1, 20, "s"}},
       .sets = {{"thick air", {{"drag", 3}, {"vx", -20}}}},
       .run = linear_drag,
       .without = {"drag", "gravity"},
       .bite = {.values = {{"drag", 3}, {"vx", -20}}},
       .sweep = "the distance from the continuous law",
       .order = 1},
      {.id = "V03",
       .title = "Quadratic drag",
       .group = "Free bodies",
       .formula = "v = v_t tanh(g t/v_t), y = v_t²/g ln cosh(g t/v_t), t_apex = v_t/g atan(v₀/v_t)",
       .source = "separation of variables; the oblique throw by an independent solution of the equations of motion",
       .parameters = {{"terminal speed", 20, 1, 200, "m/s"},
                      {"fall", 3, 0.5, 20, "s"},
                      {"upward", 30, 1, 100, "m/s"},
                      {"oblique", 20, 1, 100, "m/s"},
                      {"flight", 2, 0.5, 10, "s"}},
       .sets = {{"light ball", {{"terminal speed", 12}, {"fall", 2}}}},
       .run = quadratic_drag,
       .without = {"drag", "gravity"},
       .sweep = "the distance from the continuous law",
       .order = 1},
      {.id = "V09",
       .title = "Circular orbit",
       .group = "Free bodies",
       .formula = "kick and drift stay on the circle, with the phase step φ = 2 asin(ω Δt/2)",
       .source = "x₊ − 2x + x₋ = −4 sin²(φ/2) x; staggered start v₀ = (x₀ − x₋₁)/Δt",
       .parameters = {{"radius", 1, 0.3, 30, "AU"}, {"time factor", 1e6, 1e3, 1e7, "1"}, {"orbits", 100, 1, 1e4, "1"}},
       .sets = {{"Jupiter", {{"radius", 5.2}, {"time factor", 5e6}}},
                {"1000 orbits", {{"orbits", 1000}}, Effort::normal}},
       .run = orbit,
       .without = {"gravity"}},
      {.id = "V52",
       .title = "Harmonic oscillator",
       .group = "Free bodies",
       .formula = "phase step φ = 2 asin(ω h/2); v²/2 + ω²x²/2 − ½ h ω² x v is exactly constant",
       .source = "Hairer, Lubich, Wanner, Geometric Numerical Integration, I.1",
       .parameters = {{"omega", 10, 0.1, 60, "rad/s"}, {"steps", 600, 10, 1e5, whole_number}},
       .sets = {{"stiff", {{"omega", 40}, {"steps", 300}}}},
       .run = oscillator,
       .without = {"spring"}},
  };
}

}
