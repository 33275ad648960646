// Single impacts: rows of balls, mass ratios, oblique and frictional impacts, a struck rod.
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
  Plot& plot = run.plot("Velocities afterwards", "ball", "v [m/s]");
  for (int i = 0; i < n; ++i) {
    const double got = double(w[balls[std::size_t(i)]].velocity().x);
    plot.theory.emplace_back(i + 1, i == n - 1 ? v : 0);
    plot.simulation.emplace_back(i + 1, got);
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
  const double first = (m1 - m2) * v / (m1 + m2), meet = 0.1 / v, end = 0.5 + 0.5 / v;
  Plot& plot = run.plot("Way of the first", "t [s]", "x [m]");
  plot.theory = {{0, -0.3}, {meet, -0.2}, {end, -0.2 + first * (end - meet)}};
  run.until(w, end, [&] { plot.simulation.emplace_back(w.time(), w[a].center().x); });
  run.check("velocity of the first", "m/s", first, double(w[a].velocity().x),
            1e-5 * (first != 0 ? std::fabs(first) : v));
  run.relative("velocity of the second", "m/s", 2 * m1 * v / (m1 + m2), double(w[b].velocity().x), 1e-5);
}

// V12. Oblique elastic impact of equal smooth balls: they part at a right angle. Gives both velocities after it, when
// the first ball comes from x.
std::pair<Vec3d, Vec3d> oblique_from(
    Run& run, double x, const std::function<void(const Pos&)>& visit = [](const Pos&) {}) {
  World w(run.config());
  const Material m = material(0, run.with("restitution", 1));
  const Body first = add_ball(w, x, run["speed"], m);
  const Body second = w.add(
      {.shape = sphere(Real(ball_radius)), .at = {0, 2 * ball_radius * run["offset"], 0}, .mass = 1, .material = m});
  run.until(w, 1, [&] { visit(w[first].center()); });
  return {convert<double>(w[first].velocity()), convert<double>(w[second].velocity())};
}

void oblique(Run& run) {
  const double b = run["offset"], v = run["speed"], across = std::sqrt(1 - b * b);
  Plot& plot = run.plot("Path of the first", "x [m]", "y [m]");
  const double meet = -2 * ball_radius * across;  // there its centre turns, at y = 0
  plot.theory = {{-0.5, 0}, {meet, 0}, {meet + 0.7 * v * b * b, -0.7 * v * b * across}};
  const auto [a, c] = oblique_from(run, -0.5, [&](const Pos& p) { plot.simulation.emplace_back(p.x, p.y); });
  run.check("first, along", "m/s", v * b * b, a.x, 1e-4);
  run.check("first, across", "m/s", -v * b * across, a.y, 1e-4);
  run.check("second, along", "m/s", v * (1 - b * b), c.x, 1e-4);
  run.check("second, across", "m/s", v * b * across, c.y, 1e-4);
  run.check("angle between them", "°", 90, std::atan2(length(cross(a, c)), dot(a, c)) * 180 / pi, 0.05);
  // The error depends on where in a sub-step they meet: the mean over several starts.
  constexpr int starts = 16;
  double off = 0;
  for (int i = 0; i < starts; ++i) {
    const Vec3d got = oblique_from(run, -0.5 - v * run.h() * i / starts).first;
    off += std::hypot(got.x - v * b * b, got.y + v * b * across) / starts;
  }
  run.deviation(off);
}

// V14. A ball meets the floor aslant: it grips when μ > (2/7) u/((1+e) vₙ), else friction takes μ (1+e) vₙ.
void aslant(Run& run) {
  const double r = ball_radius, vx = run["along"], vn = run["down"], e = run["restitution"], mu = run["friction"];
  const auto bounced = [&](double friction) {  // velocity and spin afterwards
    World w(run.config());
    const Material m = material(run.with("friction", friction), e);
    add_ground(w, m);
    const Body ball = w.add(
        {.shape = sphere(Real(r)), .at = {0, r, 0}, .velocity = {Real(vx), Real(-vn), 0}, .mass = 1, .material = m});
    run.draw(w);
    w.step();
    run.draw(w);
    return std::pair{w[ball].velocity(), w[ball].spin()};
  };
  const auto taken = [&](double friction) { return std::min(2.0 / 7 * vx, friction * (1 + e) * vn); };
  const auto [v, spin] = bounced(mu);
  run.relative("velocity along the floor", "m/s", vx - taken(mu), double(v.x), 1e-3);
  run.relative("velocity upwards", "m/s", e * vn, double(v.y), 1e-3);
  run.relative("spin", "rad/s", 2.5 * taken(mu) / r, -double(spin.z), 1e-3);
  Plot& plot = run.plot("Velocity along the floor afterwards", "μ", "v [m/s]");
  const double grips = 2.0 / 7 * vx / ((1 + e) * vn);
  for (int i = 0; i <= 20; ++i) {
    const double friction = grips * i / 10;
    plot.theory.emplace_back(friction, vx - taken(friction));
    plot.simulation.emplace_back(friction, double(bounced(friction).first.x));
  }
}

// V59. A free rod struck by a ball; a hanging rod that swallows a bullet.
void struck_rod(Run& run) {
  const double l = run["length"], m = run["mass"], mb = run["ball"], v = run["speed"], d = run["arm"];
  const double thickness = 0.02, inertia = m * l * l / 12, impulse = 2 * v / (1 / mb + 1 / m + d * d / inertia);
  if (d > l / 2) throw Error("arm", "is longer than half the rod");
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
  add_gravity(run, p);
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
  Plot& plot = run.plot("Swing of the ballistic pendulum", "t [s]", "°");
  const double weighs = (big / 2 + mv) * g * long_;
  Vector exact{0, omega};
  run.until(p, 3, [&] {
    const Vec3 along = rotate(p[target].pose().q, Vec3{1, 0, 0});
    const double angle = std::atan2(double(along.x), double(-along.y)) * 180 / pi;
    swing = std::max(swing, angle);
    exact = solve_ode(
        [&](double, const Vector& y) {
          return Vector{y[1], -weighs / whole * std::sin(y[0])};
        },
        0, exact, p.config().dt);
    if (p.time() > 1) return;
    plot.theory.emplace_back(p.time(), exact[0] * 180 / pi);
    plot.simulation.emplace_back(p.time(), angle);
  });
  const double rise = whole * omega * omega / 2 / weighs;
  if (rise > 2) throw Error("bullet speed", "the pendulum goes over the top");
  run.relative("ballistic: swing", "°", std::acos(1 - rise) * 180 / pi, swing, 1e-3);
}

}

std::vector<Case> impacts() {
  const std::vector<Parameter> row = {
      {"balls", 5, 2, 20, whole_number}, {"gap", 0.001, 0, 0.1, "diameters"}, {"speed", 1, 0.1, 10, "m/s"}};
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
       .without = {"restitution", "impulses"},
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
       .without = {"restitution", "impulses"},
       .others = "Jolt, Havok, Bullet (−0.59, 0.38, 0.39, 0.40, 0.40) v; Box3D loses 42 % of the energy"},
      {.id = "V11",
       .title = "Head-on elastic impact",
       .group = "Impacts",
       .formula = "v₁' = (m₁ − m₂) v/(m₁ + m₂), v₂' = 2 m₁ v/(m₁ + m₂)",
       .source = "momentum and energy",
       .parameters = {{"mass 1", 1, 1e-3, 1e6, "kg"}, {"mass 2", 1, 1e-3, 1e6, "kg"}, {"speed", 1, 0.1, 10, "m/s"}},
       .sets = {{"1 : 10³", {{"mass 2", 1e3}}}, {"1 : 10⁶", {{"mass 2", 1e6}}}},
       .run = head_on,
       .without = {"restitution", "impulses"},
       .others = "Jolt 1e-5"},
      {.id = "V12",
       .title = "Oblique elastic impact",
       .group = "Impacts",
       .formula = "v₁' = v (b², −b √(1−b²)), v₂' = v (1 − b², b √(1−b²)), at right angles",
       .source = "the normal at the moment of impact",
       .parameters = {{"offset", 0.6, 0, 0.95, "diameters"}, {"speed", 2, 0.5, 20, "m/s"}},
       .sets = {{"nearly central", {{"offset", 0.2}, {"speed", 1}}}},
       .run = oblique,
       .without = {"restitution", "impulses"},
       .bite = {.substeps = 2048},
       .sweep = "the velocity after the impact, mean of 16 starts",
       .order = 1,
       .sweep_from = 8},
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
       .without = {"friction", "impulses"},
       .others = "PhysX, Jolt, Bullet 2e-4; Box3D and Rapier give 2.6 m/s and 10 rad/s in slip"},
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
       .without = {"restitution", "impulses"}},
  };
}

}
