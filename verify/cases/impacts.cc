// Impacts: rows of balls, mass ratios, oblique and frictional impacts, bounces.
#include <algorithm>
#include <cmath>

#include "verify/cases/cases.h"
#include "verify/numerics.h"
#include "verify/scene.h"

namespace sudar::verify {

namespace {

constexpr double ball_radius = 0.1;

Body add_ball(World& w, double x, double velocity, const Material& m, double mass = 1) {
  return w.add({.shape = sphere(Real(ball_radius)),
                .at = {x, 0, 0},
                .velocity = {Real(velocity), 0, 0},
                .mass = Real(mass),
                .material = m});
}

// A ball runs into a row of balls; gaps are a share of the diameter.
std::vector<Body> row_of_balls(World& w, int n, double gap, double v, const Material& m) {
  std::vector<Body> balls;
  for (int i = 0; i < n; ++i) balls.push_back(add_ball(w, i * 2 * ball_radius * (1 + gap), i == 0 ? v : 0, m));
  return balls;
}

// V10. Newton's cradle: one in, one out. V10b. The same touching: sequential impacts, the rule here, give the same; one
// simultaneous impact by Newton's law would give v (2 − n, 2, …, 2)/n.
void cradle(Run& run) {
  const int n = int(run["balls"]);
  const double v = run["speed"], e = run.with("restitution", 1);
  World w(run.config());
  const std::vector<Body> balls = row_of_balls(w, n, run["gap"], v, material(0, e));
  run.until(w, 1);
  double energy = 0;
  for (int i = 0; i < n; ++i) {
    const double got = double(w[balls[std::size_t(i)]].velocity().x);
    energy += got * got / (v * v);
    run.check("velocity of ball " + std::to_string(i + 1), "m/s", i == n - 1 ? v : 0, got, 1e-3 * v);
  }
  run.check("energy after / before", "1", 1, energy, 1e-3);
}

// V11. Head-on elastic impact.
void head_on(Run& run) {
  const double m1 = run["mass 1"], m2 = run["mass 2"], v = run["speed"];
  World w(run.config());
  const Material m = material(0, run.with("restitution", 1));
  const Body a = add_ball(w, -0.3, v, m, m1), b = add_ball(w, 0, 0, m, m2);
  run.until(w, 0.5 + 0.5 / v);
  const double first = (m1 - m2) * v / (m1 + m2);
  run.check("velocity of the first", "m/s", first, double(w[a].velocity().x),
            1e-5 * (first != 0 ? std::fabs(first) : v));
  run.relative("velocity of the second", "m/s", 2 * m1 * v / (m1 + m2), double(w[b].velocity().x), 1e-5);
}

// V12. Oblique elastic impact of equal smooth balls: they part at a right angle.
void oblique(Run& run) {
  const double b = run["offset"], v = run["speed"], across = std::sqrt(1 - b * b);
  World w(run.config());
  const Material m = material(0, run.with("restitution", 1));
  const Body first = w.add(
      {.shape = sphere(Real(ball_radius)), .at = {-0.5, 0, 0}, .velocity = {Real(v), 0, 0}, .mass = 1, .material = m});
  const Body second =
      w.add({.shape = sphere(Real(ball_radius)), .at = {0, 2 * ball_radius * b, 0}, .mass = 1, .material = m});
  run.until(w, 1);
  const Vec3d a = convert<double>(w[first].velocity()), c = convert<double>(w[second].velocity());
  run.check("first, along", "m/s", v * b * b, a.x, 1e-4);
  run.check("first, across", "m/s", -v * b * across, a.y, 1e-4);
  run.check("second, along", "m/s", v * (1 - b * b), c.x, 1e-4);
  run.check("second, across", "m/s", v * b * across, c.y, 1e-4);
  run.check("angle between them", "°", 90, std::atan2(length(cross(a, c)), dot(a, c)) * 180 / pi, 0.05);
}

// V13. A bouncing ball: apexes e²ⁿ h.
void bounces(Run& run) {
  const double e = run["restitution"], h = run["height"], g = standard_gravity;
  World w(run.fine_config());
  add_gravity(w, run.with("gravity", g));
  add_ground(w, material(0.5, e));
  const Body ball =
      w.add({.shape = sphere(Real(ball_radius)), .at = {0, h + ball_radius, 0}, .material = material(0.5, e)});
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
  add_gravity(w, g);
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

// V14. A ball meets the floor aslant: it grips when μ > (2/7) u/((1+e) vₙ), else friction takes μ (1+e) vₙ.
void aslant(Run& run) {
  const double r = ball_radius, vx = run["along"], vn = run["down"], e = run["restitution"], mu = run["friction"];
  World w(run.config());
  const Material m = material(run.with("friction", mu), e);
  add_ground(w, m);
  const Body ball = w.add(
      {.shape = sphere(Real(r)), .at = {0, r, 0}, .velocity = {Real(vx), Real(-vn), 0}, .mass = 1, .material = m});
  w.step();
  const bool grips = mu > 2.0 / 7 * vx / ((1 + e) * vn);
  const double taken = grips ? 2.0 / 7 * vx : mu * (1 + e) * vn;
  run.relative("velocity along the floor", "m/s", vx - taken, double(w[ball].velocity().x), 1e-3);
  run.relative("velocity upwards", "m/s", e * vn, double(w[ball].velocity().y), 1e-3);
  run.relative("spin", "rad/s", 2.5 * taken / r, -double(w[ball].spin().z), 1e-3);
}

// V59. A free rod struck by a ball; a hanging rod that swallows a bullet.
void struck_rod(Run& run) {
  const double l = run["length"], m = run["mass"], mb = run["ball"], v = run["speed"], d = run["arm"];
  const double thickness = 0.02, inertia = m * l * l / 12, impulse = 2 * v / (1 / mb + 1 / m + d * d / inertia);
  World w(run.config());
  const Material elastic = material(0, run.with("restitution", 1));
  BodyDef def = thin_rod(l, m, thickness);
  def.material = elastic;
  const Body rod = w.add(def);
  const Body ball = w.add({.shape = sphere(0.05),
                           .at = {d, 0.05 + thickness / 2, 0},
                           .velocity = {0, Real(-v), 0},
                           .mass = Real(mb),
                           .material = elastic});
  w.step();
  run.relative("velocity of the ball", "m/s", impulse / mb - v, double(w[ball].velocity().y), 1e-3);
  run.relative("velocity of the rod", "m/s", impulse / m, -double(w[rod].velocity().y), 1e-3);
  run.relative("spin of the rod", "rad/s", impulse * d / inertia, -double(w[rod].spin().z), 1e-3);

  const double big = run["pendulum"], long_ = run["pendulum length"], mv = run["bullet"], fast = run["bullet speed"],
               g = standard_gravity;
  World p(run.fine_config());
  add_gravity(p, g);
  BodyDef hanging = thin_rod(long_, big);
  hanging.at = {0, -long_ / 2, 0}, hanging.turn = axis_angle(Vec3{0, 0, 1}, Real(-pi / 2));
  const Body target = p.add(hanging);
  const Body bullet =
      p.add({.shape = sphere(0.005), .at = {0, -long_, 0}, .velocity = {Real(fast), 0, 0}, .mass = Real(mv)});
  p.join(Hinge{.b = target});
  p.join(Fixed{.a = target, .b = bullet, .at = {0, -long_, 0}});
  const double whole = (big / 3 + mv) * long_ * long_, omega = mv * fast * long_ / whole;
  p.step();
  run.relative("ballistic: spin", "rad/s", omega, double(p[target].spin().z), 1e-3);
  double swing = 0;
  run.until(p, 3, [&] {
    const Vec3 along = rotate(p[target].pose().q, Vec3{1, 0, 0});
    swing = std::max(swing, std::atan2(double(along.x), double(-along.y)) * 180 / pi);
  });
  const double rise = whole * omega * omega / 2 / ((big / 2 + mv) * g * long_);
  run.relative("ballistic: swing", "°", std::acos(1 - rise) * 180 / pi, swing, 1e-3);
}

// V69. A ball on a vibrating plate bounces once a period exactly when A ω²/g ≥ π (1−e)/(1+e).
bool bounces_once_a_period(Run& run, double strength) {
  const double e = run["restitution"], period = 1 / run["frequency"], omega = 2 * pi / period, g = standard_gravity;
  const double amplitude = strength * pi * (1 - e) / (1 + e) * g / square(omega), r = ball_radius;
  const double phase = std::acos(std::min(1.0, 1 / strength));  // of the impacts, where they exist
  World w(run.fine_config());
  add_gravity(w, run.with("gravity", g));
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
  double before = double(w[ball].velocity().y);
  const double end = 60 * period, dt = w.config().dt;
  while (w.time() < end) {
    w.set_velocity(plate, {0, Real((plate_at(w.time() + dt) - plate_at(w.time())) / dt), 0}, {});
    w.step();
    const double now = double(w[ball].velocity().y);
    if (now > before && w.time() > end / 2) impacts.push_back(w.time());
    before = now;
  }
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

std::vector<Case> impacts() {
  const std::vector<Parameter> row = {
      {"balls", 5, 2, 20, "1"}, {"gap", 0.001, 0, 0.1, "diameters"}, {"speed", 1, 0.1, 10, "m/s"}};
  std::vector<Parameter> touching = row;
  touching[1].value = 0;
  return {
      {.id = "V10",
       .title = "Newton's cradle with gaps",
       .group = "Impacts",
       .formula = "(v, 0, 0, 0, 0) → (0, 0, 0, 0, v)",
       .source = "a chain of elastic impacts of two",
       .parameters = row,
       .sets = {{"three, fast", {{"balls", 3}, {"speed", 3}}}},
       .run = cradle,
       .without = "restitution",
       .others = "Bullet exact; Box3D leaves 0.0189 v; the others merge the impacts"},
      {.id = "V10b",
       .title = "Newton's cradle, touching",
       .group = "Impacts",
       .formula = "sequential impacts, the rule of this engine: (0, 0, 0, 0, v); one simultaneous impact after Newton: "
                  "v (2−n, 2 … 2)/n",
       .source = "sequential: a chain of elastic impacts; energy constant under either rule",
       .parameters = touching,
       .sets = {{"three, fast", {{"balls", 3}, {"speed", 3}}}},
       .run = cradle,
       .without = "restitution",
       .others = "Jolt, Havok, Bullet (−0.59, 0.38, 0.39, 0.40, 0.40) v; Box3D loses 42 % of the energy"},
      {.id = "V11",
       .title = "Head-on elastic impact",
       .group = "Impacts",
       .formula = "v₁' = (m₁ − m₂) v/(m₁ + m₂), v₂' = 2 m₁ v/(m₁ + m₂)",
       .source = "momentum and energy",
       .parameters = {{"mass 1", 1, 1e-3, 1e6, "kg"}, {"mass 2", 1, 1e-3, 1e6, "kg"}, {"speed", 1, 0.1, 10, "m/s"}},
       .sets = {{"1 : 10³", {{"mass 2", 1e3}}}, {"1 : 10⁶", {{"mass 2", 1e6}}}},
       .run = head_on,
       .without = "restitution",
       .others = "Jolt 1e-5"},
      {.id = "V12",
       .title = "Oblique elastic impact",
       .group = "Impacts",
       .formula = "v₁' = v (b², −b √(1−b²)), v₂' = v (1 − b², b √(1−b²)), at right angles",
       .source = "the normal at the moment of impact",
       .parameters = {{"offset", 0.6, 0, 0.95, "diameters"}, {"speed", 2, 0.5, 20, "m/s"}},
       .sets = {{"nearly central", {{"offset", 0.2}, {"speed", 1}}}},
       .run = oblique,
       .without = "restitution"},
      {.id = "V13",
       .title = "Bouncing ball",
       .group = "Impacts",
       .formula = "hₙ = e²ⁿ h",
       .source = "definition of restitution",
       .parameters = {{"height", 2, 0.2, 20, "m"}, {"restitution", 0.8, 0.7, 0.95, "1"}},
       .sets = {{"e = 0.9", {{"restitution", 0.9}}}},
       .run = bounces,
       .without = "gravity",
       .others = "first apex: Jolt +0.13 %, Box3D, Rapier −2.4 %, PhysX +5.5 %, Havok −1.9 %"},
      {.id = "V13b",
       .title = "SimBenchmark: bouncing",
       .group = "Impacts",
       .formula = "⟨(E − E₀)²⟩ = (N ½ m g h)² ⟨v²⟩, ⟨v²⟩ = ⅔ g H",
       .source = "symplectic Euler in free flight; leggedrobotics/SimBenchmark",
       .parameters = {{"sub-step", 1.0 / 240, 1e-5, 0.02, "s"}},
       .sets = {{"1 ms", {{"sub-step", 1e-3}}}},
       .run = elastic_balls,
       .without = "restitution",
       .effort = Effort::normal,
       .others = "1 ms (floor 185): Jolt 184.5, PhysX TGS 184.8, ODE 185.0; PhysX PGS 75 260, Bullet 75 245, Rapier 66 "
                 "120, Box3D "
                 "296 518 (19 131 with 4 sub-steps), Havok 3.2e6"},
      {.id = "V14",
       .title = "Friction in an impact",
       .group = "Impacts",
       .formula = "grip: v' = ⁵⁄₇ v, R ω = ⁵⁄₇ v; slip: Δv = μ (1+e) vₙ; limit μ = ²⁄₇ v/((1+e) vₙ)",
       .source = "impulse and its moment on a solid ball",
       .parameters = {{"along", 3, 0.1, 20, "m/s"},
                      {"down", 4, 0.1, 20, "m/s"},
                      {"restitution", 0.5, 0, 1, "1"},
                      {"friction", 1, 0.01, 10, "1"}},
       .sets = {{"slip", {{"friction", 0.1}}}},
       .run = aslant,
       .without = "friction",
       .others = "PhysX, Jolt, Bullet 2e-4; Box3D and Rapier give 2.6 m/s and 10 rad/s in slip"},
      {.id = "V42",
       .title = "Fast bodies: time of impact",
       .group = "Impacts",
       .formula = "t = (d − r − ½ w)/v; a bullet of 10 mm at 10⁴ m/s stops at a wall of 1 mm",
       .source = "motion along a line",
       .others = "Rapier, Bullet, Jolt stop 10⁴ m/s at 1 mm; Havok up to 10³; Box3D up to its cap of 400 m/s",
       .needs = "time of impact (continuous collision detection)"},
      {.id = "V59",
       .title = "Struck rod, ballistic pendulum",
       .group = "Impacts",
       .formula = "J = 2 v/(1/m_b + 1/m + d²/I); ω = m_b v L/((M/3 + m_b) L²)",
       .source = "momentum, angular momentum, energy",
       .parameters = {{"length", 1, 0.1, 10, "m"},
                      {"mass", 1, 0.1, 10, "kg"},
                      {"ball", 0.2, 0.01, 10, "kg"},
                      {"speed", 10, 1, 30, "m/s"},
                      {"arm", 0.5, 0.05, 0.5, "m"},
                      {"pendulum", 1.5, 0.1, 10, "kg"},
                      {"pendulum length", 1.2, 0.1, 10, "m"},
                      {"bullet", 0.01, 0.001, 1, "kg"},
                      {"bullet speed", 400, 10, 1000, "m/s"}},
       .sets = {{"nearer", {{"arm", 0.25}, {"ball", 1}, {"bullet speed", 300}}}},
       .run = struck_rod,
       .without = "restitution"},
      {.id = "V69",
       .title = "Ball on a vibrating plate",
       .group = "Impacts",
       .formula = "one bounce a period exists exactly when A ω²/g ≥ π (1−e)/(1+e)",
       .source = "Holmes, J. Sound Vib. 84 (1982) 173",
       .parameters = {{"restitution", 0.5, 0.2, 0.9, "1"}, {"frequency", 5, 1, 20, "Hz"}},
       .sets = {{"e = 0.8", {{"restitution", 0.8}}}},
       .run = vibrating_plate,
       .without = "gravity"},
  };
}

}
