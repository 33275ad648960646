// Pendulums on joints: one rod, two, linkages.
#include <algorithm>
#include <cmath>

#include "verify/cases/cases.h"
#include "verify/numerics.h"
#include "verify/scene.h"

namespace sudar::verify {

namespace {

// A rod of the length that hangs from `pivot` at the angle from straight down, in the xy plane.
BodyDef hanging_rod(const Pos& pivot, double length, double mass, double angle) {
  BodyDef def = thin_rod(length, mass);
  const Vec3d along{std::sin(angle), -std::cos(angle), 0};
  def.at = pivot + along * (length / 2);
  def.turn = axis_angle(Vec3{0, 0, 1}, Real(angle - pi / 2));
  return def;
}
Pos tip(const Pos& pivot, double length, double angle) {
  return pivot + Vec3d{std::sin(angle), -std::cos(angle), 0} * length;
}
// The angle of such a rod, −π…π, and its rate.
double angle_of(const BodyView& rod) {
  const Vec3 along = rotate(rod.pose().q, Vec3{1, 0, 0});
  return std::atan2(double(along.x), double(-along.y));
}

// Means of a sampled value over the time of the first and of the last `window`.
class Ends {
 public:
  Ends(double window, double end) : window_(window), end_(end) {}
  void sample(double t, double value) {
    if (t <= window_) first_ += value, ++n_first_;
    if (t > end_ - window_) last_ += value, ++n_last_;
  }
  double change() const { return last_ / n_last_ - first_ / n_first_; }

 private:
  double window_, end_, first_ = 0, last_ = 0;
  int n_first_ = 0, n_last_ = 0;
};

// V07. A rod on a hinge at its end.
void rod_pendulum(Run& run) {
  const double l = run["length"], m = run["mass"], start = run["angle"] * pi / 180, g = standard_gravity;
  const double inertia = m * l * l / 3, t = run["time"];
  const double period = 4 * std::sqrt(inertia / (m * g * l / 2)) * elliptic_k(square(std::sin(start / 2)));
  World w(run.fine_config());
  add_gravity(run, w);
  const Body rod = w.add(hanging_rod({}, l, m, start));
  const Joint hinge = w.join(Hinge{.b = rod});
  Crossings zeros;
  Plot& swings_plot = run.plot("Angle", "t [s]", "θ [°]");
  const double modulus = std::sin(start / 2);  // sin θ/2 = k sn(K − ω t)
  const auto exact = [&](double s) {
    const double u = elliptic_k(square(modulus)) * (1 - 4 * s / period);
    return 2 * std::asin(modulus * jacobi(u, square(modulus)).sn);
  };
  const double window = period * std::max(1.0, std::round(t / 20 / period));
  Ends energy(window, t);
  double gap = 0;
  Plot& plot = run.plot("Energy, mean of a period", "t [s]", "E/E₀ − 1 [%]");
  const double swing = m * g * l / 2 * (1 - std::cos(start));
  double sum = 0, n = 0, begun = 0;
  run.until(w, t, [&] {
    zeros.sample(w.time(), angle_of(w[rod]));
    if (w.time() < 2 * period) {
      swings_plot.theory.emplace_back(w.time(), exact(w.time()) * 180 / pi);
      swings_plot.simulation.emplace_back(w.time(), angle_of(w[rod]) * 180 / pi);
    }
    const double e = w[rod].kinetic_energy() + m * g * (w[rod].center().y + l / 2 * std::cos(start));
    energy.sample(w.time(), e);
    gap = std::max(gap, double(w[hinge].gap()));
    sum += e, ++n;
    if (w.time() < begun + period) return;
    plot.theory.emplace_back(w.time(), 0);
    plot.simulation.emplace_back(w.time(), sum / n / swing * 100);
    begun = w.time(), sum = n = 0;
  });
  const auto& z = zeros.moments();
  const std::size_t swings = z.empty() ? 0 : (z.size() - 1) / 2;
  const double mean = swings > 0 ? (z[2 * swings] - z[0]) / double(swings) : std::nan("");
  run.relative("period, mean of all", "s", period, mean, 5e-4);
  run.deviation(std::fabs(mean - period));
  run.check("change of the energy", "%", 0, 100 * energy.change() / swing, 0.5);
  run.below("largest gap of the hinge", "m", gap, 1e-4);
}

// V08. Two rods, a double pendulum; against an independent solution of its equations.
struct DoublePendulum {
  double l1, l2, m1, m2, g = standard_gravity;
  Vector rate(const Vector& y) const {  // θ₁, θ₂ and their rates
    const double c = std::cos(y[0] - y[1]), s = std::sin(y[0] - y[1]), cross = m2 * l1 * l2 / 2;
    const double a = (m1 / 3 + m2) * l1 * l1, b = cross * c, d = m2 * l2 * l2 / 3;
    const double p = -cross * s * y[3] * y[3] - (m1 / 2 + m2) * g * l1 * std::sin(y[0]);
    const double q = cross * s * y[2] * y[2] - m2 * g * l2 / 2 * std::sin(y[1]);
    const double det = a * d - b * b;
    return {y[2], y[3], (d * p - b * q) / det, (a * q - b * p) / det};
  }
};

void double_pendulum(Run& run) {
  const DoublePendulum law{run["length 1"], run["length 2"], run["mass 1"], run["mass 2"]};
  const double start = run["angle"] * pi / 180, t = 60;
  World w(run.config());
  add_gravity(run, w);
  const Pos middle = tip({}, law.l1, start);
  const Body upper = w.add(hanging_rod({}, law.l1, law.m1, start));
  const Body lower = w.add(hanging_rod(middle, law.l2, law.m2, start));
  w.join(Hinge{.b = upper});
  w.join(Hinge{.a = upper, .b = lower, .at = middle});
  const Rate rate = [&](double, const Vector& y) { return law.rate(y); };
  Plot& plot = run.plot("Upper rod", "t [s]", "θ₁ [rad]");
  Ends energy(5, t);
  const double e0 = w.energy().total(), bottom = -law.g * (law.m1 * law.l1 / 2 + law.m2 * (law.l1 + law.l2 / 2));
  Vector exact{start, start, 0, 0};
  double last = 0, at_one = 0, at_one_exact = 0, lower_got = 0, lower_exact = 0;
  run.until(w, t, [&] {
    energy.sample(w.time(), w.energy().total());
    if (w.time() > 2.005) return;
    exact = solve_ode(rate, last, exact, w.time());
    last = w.time();
    plot.theory.emplace_back(last, std::remainder(exact[0], 2 * pi));
    plot.simulation.emplace_back(last, angle_of(w[upper]));
    if (std::fabs(last - 1) > 1e-6) return;
    at_one = angle_of(w[upper]), lower_got = angle_of(w[lower]);
    at_one_exact = std::remainder(exact[0], 2 * pi), lower_exact = std::remainder(exact[1], 2 * pi);
  });
  run.check("upper angle at 1 s", "rad", at_one_exact, at_one, 0.02);
  run.check("lower angle at 1 s", "rad", lower_exact, lower_got, 0.02);
  run.deviation(std::hypot(at_one - at_one_exact, lower_got - lower_exact));
  run.check("change of the energy in a minute", "%", 0, 100 * energy.change() / (e0 - bottom), 0.5);
}

// V61. IFToMM benchmarks: A01, the simple pendulum; A02, a row of N four-bar linkages, which moves as one pendulum of
// inertia (N+1)/3 + N and weight moment ((N+1)/2 + N) g.
void linkage(Run& run) {
  const double g = standard_gravity;
  Config c = run.config();
  c.dt = 1e-3, c.substeps = 1;
  World pendulum(c);
  add_gravity(run, pendulum);
  const Body weight = pendulum.add({.shape = sphere(0.05),
                                    .at = {-1, 0, 0},
                                    .mass = 1,
                                    .inertia = Mat3::diagonal({Real(1e-5), Real(1e-5), Real(1e-5)})});
  pendulum.join(Hinge{.b = weight});
  run.until(pendulum, 10);
  const Vector end = solve_ode(
      [&](double, const Vector& y) {
        return Vector{y[1], -g * std::sin(y[0])};
      },
      0, {-pi / 2, 0}, 10);
  run.check("A01: x at 10 s", "m", std::sin(end[0]), pendulum[weight].center().x, 0.01);
  run.check("A01: y at 10 s", "m", -std::cos(end[0]), pendulum[weight].center().y, 0.01);

  const int n = int(run["loops"]);
  const double speed = run["speed"], inertia = (n + 1) / 3.0 + n, moment = ((n + 1) / 2.0 + n) * g;
  World w(c);
  add_gravity(run, w);
  std::vector<Body> bars, couplers;
  for (int k = 0; k <= n; ++k) {
    BodyDef bar = thin_rod(1, 1);
    bar.at = {double(k), 0.5, 0}, bar.turn = axis_angle(Vec3{0, 0, 1}, Real(pi / 2));
    bar.velocity = {Real(speed / 2), 0, 0}, bar.spin = {0, 0, Real(-speed)};
    bar.filter.group = -1;
    bars.push_back(w.add(bar));
    w.join(Hinge{.b = bars.back(), .at = {double(k), 0, 0}});
    if (k == 0) continue;
    BodyDef coupler = thin_rod(1, 1);
    coupler.at = {k - 0.5, 1, 0}, coupler.velocity = {Real(speed), 0, 0}, coupler.filter.group = -1;
    couplers.push_back(w.add(coupler));
    w.join(Hinge{.a = bars[std::size_t(k) - 1], .b = couplers.back(), .at = {k - 1.0, 1, 0}});
    w.join(Hinge{.a = couplers.back(), .b = bars.back(), .at = {double(k), 1, 0}});
  }
  // From upright: ω² = v² + 2 moment/inertia (1 − cos).
  const auto rate = [&](double angle) {
    return std::sqrt(speed * speed + 2 * moment / inertia * (1 - std::cos(angle)));
  };
  const double turn = integral([&](double a) { return 1 / rate(a); }, 0, 2 * pi);
  double fastest = 0, angle = 0, before = 0, done = std::nan("");
  Plot& plot = run.plot("A02: turning rate", "angle [rad]", "ω [rad/s]");
  run.until(w, 1.5 * turn, [&] {
    const Vec3 along = rotate(w[bars[0]].pose().q, Vec3{1, 0, 0});
    const double now = std::atan2(double(along.x), double(along.y)), step = std::remainder(now - before, 2 * pi);
    if (std::isnan(done) && angle < 2 * pi && angle + step >= 2 * pi)
      done = w.time() - c.dt * (angle + step - 2 * pi) / step;
    angle += step, before = now;
    fastest = std::max(fastest, -double(w[bars[0]].spin().z));
    if (angle > 2 * pi || std::fmod(double(w.steps()), 10) != 0) return;
    plot.theory.emplace_back(angle, rate(angle));
    plot.simulation.emplace_back(angle, -double(w[bars[0]].spin().z));
  });
  run.check("A02: time of a turn", "s", turn, done, 0.01);
  run.check("A02: rate at the bottom", "rad/s", rate(pi), fastest, 0.01 * rate(pi));
}

}

std::vector<Case> pendulums() {
  return {
      {.id = "V07",
       .title = "Rod pendulum",
       .group = "Joints",
       .formula = "T = 4 √(I/(m g d)) K(sin² θ₀/2); energy constant",
       .source = "complete elliptic integral",
       .parameters = {{"length", 1, 0.1, 10, "m"},
                      {"mass", 1, 0.01, 100, "kg"},
                      {"angle", 90, 1, 179.5, "°"},
                      {"time", 60, 5, 600, "s"}},
       .sets = {{"30°", {{"angle", 30}}}, {"150°", {{"angle", 150}}}, {"179°", {{"angle", 179}}, Effort::quick, false}},
       .run = rod_pendulum,
       .without = {"gravity", "impulses"},
       .others = "90°, 60 s: PhysX TGS +0.15 % period, −2.8 … +4.0 % energy; Box3D −0.25 %, −3.2 … +0.6 %; all others "
                 "lose 60 % "
                 "of the energy or more",
       .sweep = "the period",
       .order = 2},
      {.id = "V08",
       .title = "Double pendulum",
       .group = "Joints",
       .formula = "Lagrange's equations of two rods",
       .source = "independent solution, Dormand & Prince 5(4)",
       .parameters = {{"length 1", 1, 0.1, 10, "m"},
                      {"length 2", 1, 0.1, 10, "m"},
                      {"mass 1", 1, 0.1, 10, "kg"},
                      {"mass 2", 1, 0.1, 10, "kg"},
                      {"angle", 90, 1, 170, "°"}},
       .sets = {{"unequal", {{"length 2", 0.7}, {"mass 2", 0.5}, {"angle", 60}}}},
       .run = double_pendulum,
       .without = {"gravity", "impulses"},
       .sweep = "the angles at 1 s",
       .order = 2},
      {.id = "V61",
       .title = "IFToMM A01 and A02",
       .group = "Joints",
       .formula = "θ¨ = −g sin θ; ω² = v² + 2 G/I (1 − cos θ), I = (N+1)/3 + N, G = ((N+1)/2 + N) g",
       .source = "IFToMM library of computational benchmark problems; 1 kHz",
       .parameters = {{"loops", 2, 1, 20, whole_number}, {"speed", 1, 0.2, 5, "m/s"}},
       .sets = {{"three loops", {{"loops", 3}, {"speed", 2}}}},
       .run = linkage,
       .without = {"gravity", "impulses"},
       .others = "OpenSim: matches"},
  };
}

}
