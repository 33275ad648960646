// Bodies that turn: free rotation by Euler's equations, the heavy top, the gyroscope on a ball joint.
#include <algorithm>
#include <cmath>

#include "verify/cases/cases.h"
#include "verify/numerics.h"
#include "verify/scene.h"

namespace sudar::verify {

namespace {

// The motion of ω₂ by Jacobi's functions for I₁ < I₂ < I₃ and L² > 2 T I₂ (else 1 and 3 change places): Landau &
// Lifshitz, Mechanics, §37.
struct FreeRotation {
  double amplitude, rate, m, phase;  // ω₂ = amplitude · sn(rate t + phase | m)
  double zero(int n) const { return (2 * elliptic_k(m) * n - phase) / rate; }
};
FreeRotation free_rotation(std::array<double, 3> i, std::array<double, 3> w) {
  double energy = 0, momentum = 0;  // 2 T and L²
  for (std::size_t k = 0; k < 3; ++k) energy += i[k] * w[k] * w[k], momentum += square(i[k] * w[k]);
  if (momentum < energy * i[1]) std::swap(i[0], i[2]), std::swap(w[0], w[2]);
  const double low = momentum - energy * i[0], high = energy * i[2] - momentum;
  FreeRotation r{};
  r.amplitude = std::sqrt(high / (i[1] * (i[2] - i[1])));
  r.rate = std::sqrt((i[2] - i[1]) * low / (i[0] * i[1] * i[2]));
  r.m = (i[1] - i[0]) * high / ((i[2] - i[1]) * low);
  const double early = std::copysign(elliptic_f(std::asin(std::fabs(w[1]) / r.amplitude), r.m), w[1]);
  r.phase = w[0] * w[2] > 0 ? early : 2 * elliptic_k(r.m) - early;  // ω₂ rises or falls at the start
  return r;
}

// V04. Rotation about the middle axis turns over and over (Dzhanibekov).
void dzhanibekov(Run& run) {
  const std::array<double, 3> moments{run["I1"], run["I2"], run["I3"]};
  const std::array<double, 3> start{run["w1"], run["w2"], run["w3"]};
  World w(run.fine_config());
  const double same = run.without("asymmetry") ? moments[1] : 0;
  const Vec3 inertia{Real(same > 0 ? same : moments[0]), Real(moments[1]), Real(same > 0 ? same : moments[2])};
  const Body b = w.add({.shape = sphere(1),
                        .spin = {Real(start[0]), Real(start[1]), Real(start[2])},
                        .mass = 1,
                        .inertia = Mat3::diagonal(inertia)});
  const FreeRotation exact = free_rotation(moments, start);
  // From the spin, for the engine's own account of the momentum could not be wrong here: it is what it advances. A spin
  // in single precision tells it to 1e-6, means over a second tell more.
  const auto momentum = [&] {
    const Vec3d spin = rotate_back(convert<double>(w[b].pose().q), convert<double>(w[b].spin()));
    return length(Vec3d{moments[0] * spin.x, moments[1] * spin.y, moments[2] * spin.z});
  };
  const double momentum_before = momentum(), energy = w[b].kinetic_energy();
  const auto second = std::lround(1 / w.config().dt);  // in steps
  double momentum_sum = 0;
  double worst_momentum = 0, worst_energy = 0;
  Crossings zeros;
  Plot& plot = run.plot("Spin about the middle axis", "t [s]", "ω₂ [rad/s]");
  run.until(w, run["time"], [&] {
    const double spin = double(rotate_back(w[b].pose().q, w[b].spin()).y);
    zeros.sample(w.time(), spin);
    plot.theory.emplace_back(w.time(), exact.amplitude * jacobi(exact.rate * w.time() + exact.phase, exact.m).sn);
    plot.simulation.emplace_back(w.time(), spin);
    momentum_sum += momentum();
    if (w.steps() % second == 0) {
      worst_momentum = std::max(worst_momentum, std::fabs(momentum_sum / double(second) / momentum_before - 1));
      momentum_sum = 0;
    }
    worst_energy = std::max(worst_energy, std::fabs(w[b].kinetic_energy() / energy - 1));
  });
  const auto seen = [&](std::size_t n) { return zeros.moments().size() > n ? zeros.moments()[n] : std::nan(""); };
  if (exact.zero(1) < run["time"]) run.check("first turn", "s", exact.zero(1), seen(0), 0.02);
  if (exact.zero(3) < run["time"]) run.check("third turn", "s", exact.zero(3), seen(2), 0.02);
  run.below("drift of |L|", "1", worst_momentum, 1e-6);
  run.below("drift of the energy", "1", worst_energy, 1e-5);
}

// V05. The axis of a symmetric free top goes round the angular momentum with the rate |L|/I₁.
void symmetric_top(Run& run) {
  const double i1 = run["I1"], i3 = run["I3"], t = run["time"];
  const Vec3d spin{run["w1"], 0, run["w3"]}, momentum{i1 * spin.x, 0, i3 * spin.z};
  World w(run.config());
  const double broken = run.without("asymmetry") ? i1 : i3;
  const Body b = w.add({.shape = sphere(1),
                        .spin = convert<Real>(spin),
                        .mass = 1,
                        .inertia = Mat3::diagonal({Real(i1), Real(i1), Real(broken)})});
  const auto exact = [&](double s) { return rotate(rotation(momentum * (s / i1)), Vec3d{0, 0, 1}); };
  const auto axis = [&] { return rotate(convert<double>(w[b].pose().q), Vec3d{0, 0, 1}); };
  Plot& plot = run.plot("The axis from above", "x", "y");
  double worst = 0;
  run.until(w, t, [&] {
    plot.theory.emplace_back(exact(w.time()).x, exact(w.time()).y);
    plot.simulation.emplace_back(axis().x, axis().y);
    worst = std::max(worst, length(axis() - exact(w.time())));
  });
  run.check("x of the axis", "1", exact(t).x, axis().x, 1e-4);
  run.check("y of the axis", "1", exact(t).y, axis().y, 1e-4);
  run.below("largest angle between the axes", "rad", worst, 1e-4);
  run.deviation(worst);
}

// V06. A heavy top released with its axis at rest: u = cos θ moves as u̇² = β (u₀ − u)(u − u₁)(u₂ − u).
struct Nutation {
  double lowest, period, advance;  // u₁; of the nutation; of φ in that time
};
Nutation nutation(double u0, double a, double beta) {  // a = I₃ω₃/I₁, β = 2 m g l/I₁
  const double p = a * a / beta, s = std::sqrt(p * p / 4 - p * u0 + 1);
  const double u1 = p / 2 - s, u2 = p / 2 + s;
  Nutation n{};
  n.lowest = u1;
  n.period = 4 * elliptic_k((u0 - u1) / (u2 - u1)) / std::sqrt(beta * (u2 - u1));
  n.advance = integral(
      [&](double x) {
        const double u = u1 + (u0 - u1) * square(std::sin(x));
        return 4 * a * (u0 - u) / ((1 - u * u) * std::sqrt(beta * (u2 - u)));
      },
      0, pi / 2);
  return n;
}

void heavy_top(Run& run) {
  const double m = run["mass"], r = run["radius"], l = run["arm"], g = standard_gravity, w3 = run["spin"];
  const double i3 = m * r * r / 2, i1 = i3 / 2 + m * l * l, tilt = run["tilt"] * pi / 180;
  World w(run.fine_config());
  add_gravity(run, w);
  const Quat turn = axis_angle(Vec3{0, 0, -1}, Real(tilt));
  const Vec3 axis = rotate(turn, Vec3{0, 1, 0});
  const Body top = w.add({.shape = sphere(0.01),
                          .at = Pos{} + axis * Real(l),
                          .turn = turn,
                          .spin = axis * Real(w3),
                          .mass = Real(m),
                          .inertia = Mat3::diagonal({Real(i3 / 2), Real(i3), Real(i3 / 2)})});
  w.join(Ball{.b = top});
  const Nutation exact = nutation(std::cos(tilt), i3 * w3 / i1, 2 * m * g * l / i1);
  Crossings turning;
  double least = pi, most = 0, phi = 0, before = 0;
  Plot& plot = run.plot("Tilt", "t [s]", "θ [rad]");
  run.until(w, 5, [&] {
    const Vec3 arm = w[top].center() - Pos{};
    const double theta = std::atan2(std::hypot(double(arm.x), double(arm.z)), double(arm.y));
    turning.sample(w.time(), double(w[top].velocity().y));
    least = std::min(least, theta), most = std::max(most, theta);
    const double angle = std::atan2(double(-arm.z), double(arm.x));
    phi += std::remainder(angle - before, 2 * pi);
    before = angle;
    if (w.time() < 6 * exact.period) plot.simulation.emplace_back(w.time(), theta);
  });
  plot.theory = {{0, std::acos(exact.lowest)}, {6 * exact.period, std::acos(exact.lowest)}};
  // Zeros of the vertical velocity: lowest, highest, lowest … two to a nutation.
  const auto& zeros = turning.moments();
  const std::size_t periods = zeros.empty() ? 0 : (zeros.size() - 1) / 2;
  const double period = periods > 0 ? (zeros[2 * periods] - zeros[0]) / double(periods) : std::nan("");
  run.relative("period of the nutation", "s", exact.period, period, 0.02);
  run.relative("mean precession", "rad/s", exact.advance / exact.period, phi / 5, 0.01);
  run.check("largest tilt", "°", std::acos(exact.lowest) * 180 / pi, most * 180 / pi, 0.3);
  run.check("least tilt", "°", run["tilt"], least * 180 / pi, 0.3);
}

// V51. A wheel on a ball joint, its axle level, precesses with Ω = m g l/(I₃ ω) and neither sinks nor slows.
void gyroscope(Run& run) {
  const double m = run["mass"], r = run["radius"], l = run["arm"], g = standard_gravity, spin = run["spin"];
  const double i3 = m * r * r, precession = m * g * l / (i3 * spin), t = run["time"];
  World w(run.config());
  add_gravity(run, w);
  const Body wheel = w.add({.shape = sphere(0.1),
                            .at = {l, 0, 0},
                            .velocity = {0, 0, Real(-precession * l)},
                            .spin = {Real(spin), Real(precession), 0},
                            .mass = Real(m),
                            .inertia = Mat3::diagonal({Real(i3), Real(i3 / 2), Real(i3 / 2)})});
  w.join(Ball{.b = wheel});
  double worst = 0, phi = 0, before = 0;
  Plot& plot = run.plot("Angle of precession", "t [s]", "φ [rad]");
  Plot& height = run.plot("Height of the wheel", "t [s]", "y [m]");
  run.until(w, t, [&] {
    const Pos p = w[wheel].center();
    worst = std::max(worst, std::fabs(p.y));
    const double angle = std::atan2(-p.z, p.x);
    phi += std::remainder(angle - before, 2 * pi);
    before = angle;
    plot.theory.emplace_back(w.time(), precession * w.time());
    plot.simulation.emplace_back(w.time(), phi);
    height.theory.emplace_back(w.time(), 0);
    height.simulation.emplace_back(w.time(), p.y);
  });
  const Vec3 axle = rotate(w[wheel].pose().q, Vec3{1, 0, 0});
  run.relative("angle of precession", "rad", precession * t, phi, 0.002);
  run.below("largest drop of the wheel", "m", worst, 0.005);
  run.relative("spin along the axle", "rad/s", spin, double(dot(w[wheel].spin(), axle)), 0.001);
}

}

std::vector<Case> rotations() {
  return {
      {.id = "V04",
       .title = "Rotation about the middle axis",
       .group = "Free bodies",
       .formula = "ω₂ = A sn(λ t + φ | m), |L| and E constant",
       .source = "Landau & Lifshitz, Mechanics, §37",
       .parameters = {{"I1", 1, 0.1, 10, "kg m²"},
                      {"I2", 2, 0.1, 10, "kg m²"},
                      {"I3", 3, 0.1, 10, "kg m²"},
                      {"w1", 0.01, -10, 10, "rad/s"},
                      {"w2", 1, -10, 10, "rad/s"},
                      {"w3", 0.02, -10, 10, "rad/s"},
                      {"time", 60, 1, 1000, "s"}},
       .sets = {{"fast", {{"I3", 2.5}, {"w1", 0.3}, {"w2", 4}, {"w3", 0.1}, {"time", 20}}}},
       .run = dzhanibekov,
       .without = {"asymmetry"},
       .others =
           "60 s, turns (exact 8.813, 25.411, 42.008 s): MuJoCo 8.844/25.447/42.050, Rapier 8.822/25.366/41.862, Box3D "
           "8.805/25.539/42.305, Jolt 8.850/25.596/42.484; drift of |L|: PhysX 1.2e-5, Jolt 1.5e-4, Rapier 1.4e-3, "
           "Box3D "
           "5.6e-3, MuJoCo 3.8e-2; Havok has no gyroscopic term"},
      {.id = "V05",
       .title = "Symmetric free top",
       .group = "Free bodies",
       .formula = "the axis goes round L with |L|/I₁",
       .source = "Landau & Lifshitz, Mechanics, §33",
       .parameters = {{"I1", 2, 0.1, 10, "kg m²"},
                      {"I3", 3, 0.1, 10, "kg m²"},
                      {"w1", 0.3, -5, 5, "rad/s"},
                      {"w3", 5, -50, 50, "rad/s"},
                      {"time", 4, 0.1, 60, "s"}},
       .sets = {{"long", {{"I3", 1.2}, {"w1", 0.6}, {"w3", 3}}}},
       .run = symmetric_top,
       .without = {"asymmetry"},
       .sweep = "the angle between the axes",
       .order = 2},
      {.id = "V06",
       .title = "Heavy top",
       .group = "Joints",
       .formula = "u̇² = β (u₀ − u)(u − u₁)(u₂ − u), u = cos θ: T = 4 K(k²)/√(β (u₂ − u₁)), Δφ by quadrature",
       .source = "Goldstein, Classical Mechanics, §5.7",
       .parameters = {{"mass", 0.5, 0.01, 10, "kg"},
                      {"radius", 0.05, 0.01, 1, "m"},
                      {"arm", 0.05, 0.01, 1, "m"},
                      {"tilt", 30, 5, 85, "°"},
                      {"spin", 150, 20, 1000, "rad/s"}},
       .sets = {{"60°", {{"tilt", 60}, {"spin", 200}}}},
       .run = heavy_top,
       .without = {"gravity", "impulses"}},
      {.id = "V51",
       .title = "Gyroscope on a ball joint",
       .group = "Joints",
       .formula = "Ω = m g l/(I₃ ω), height and spin constant",
       .source = "steady precession with a level axle: exact",
       .parameters = {{"mass", 2, 0.1, 100, "kg"},
                      {"radius", 0.3, 0.05, 2, "m"},
                      {"arm", 0.25, 0.05, 2, "m"},
                      {"spin", 60, 10, 300, "rad/s"},
                      {"time", 10, 1, 100, "s"}},
       .sets = {{"slow", {{"spin", 40}}}},
       .run = gyroscope,
       .without = {"gravity", "impulses"},
       .others =
           "10 s: Box3D precession +0.5 %, drop 0.147 m, spin 49.4; MuJoCo −2.7 %, 0.206 m, 34.8; PhysX −12 %, Jolt "
           "−14 %, Rapier +26 %, PhysX TGS −45 %, Havok +73 %, Bullet +100 %"},
  };
}

}
