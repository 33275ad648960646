// Tops on a floor.
#include <algorithm>
#include <cmath>

#include "verify/cases/cases.h"
#include "verify/numerics.h"
#include "verify/scene.h"

namespace sudar::verify {

namespace {

// V31. A disc that rolls on its rim while its centre of mass stands still: inclined by α it goes round with
// Ω² sin α = 4 g/R, turning with Ω sin α about the diameter through the lowest point.
void euler_disc(Run& run) {
  const double r = run["radius"], alpha = run["tilt"] * pi / 180, thick = r / 500, m = 1;
  const double round = std::sqrt(4 * standard_gravity / (r * std::sin(alpha)));
  Config c = run.config();
  c.impulse_2007.slop = Real(thick / 10);
  World w(c);
  add_gravity(run, w);
  const Material rough = material(10);
  add_ground(w, rough);
  const Vec3d diameter{std::cos(alpha), std::sin(alpha), 0};
  const Body disc = w.add({.shape = cylinder(Real(r), Real(thick)),
                           .at = {0, r * std::sin(alpha) + thick / 2 * std::cos(alpha), 0},
                           .turn = axis_angle(Vec3{0, 0, 1}, Real(alpha)),
                           .spin = convert<Real>(diameter * (round * std::sin(alpha))),
                           .mass = Real(m),
                           .inertia = Mat3::diagonal({Real(m * r * r / 4), Real(m * r * r / 2), Real(m * r * r / 4)}),
                           .material = rough});
  double worst = 0, turned = 0, before = 0;
  Plot& plot = run.plot("Inclination", "t [s]", "α [°]");
  run.until(w, 1, [&] {
    const Vec3 axis = rotate(w[disc].pose().q, Vec3{0, 1, 0});
    const double tilt = std::acos(std::clamp(double(axis.y), -1.0, 1.0)) * 180 / pi,
                 azimuth = std::atan2(double(axis.z), double(axis.x));
    worst = std::max(worst, std::fabs(tilt - run["tilt"]));
    turned +=
        std::remainder(before - azimuth + (w.steps() == 1 ? pi : 0), 2 * pi);  // the axis leans towards −x at first
    before = azimuth;
    plot.theory.emplace_back(w.time(), run["tilt"]);
    plot.simulation.emplace_back(w.time(), tilt);
  });
  run.below("largest change of the inclination in 1 s", "°", worst, 0.5);
  run.deviation(worst);
  run.relative("rate of going round, mean", "rad/s", round, turned, 0.01);
}

// V32. A rattleback: an ellipsoid on whose axes its inertia is not aligned. Rolling without slip, in body axes: u
// points down, r from the centre of mass to the contact; the contact stays where it is, so v = r × ω.
struct Rattleback {
  Vec3d radii;
  double below;  // the centre of mass lies so far below the middle
  Mat3d inertia;
  double g = standard_gravity;  // mass 1
  Vec3d squared(const Vec3d& x) const { return {square(radii.x) * x.x, square(radii.y) * x.y, square(radii.z) * x.z}; }
  Vec3d arm(const Vec3d& u) const { return squared(u) * (1 / std::sqrt(dot(u, squared(u)))) + Vec3d{0, below, 0}; }
  Vector rate(const Vector& y) const {
    const Vec3d omega{y[0], y[1], y[2]}, u{y[3], y[4], y[5]}, du = cross(u, omega);
    const double s = std::sqrt(dot(u, squared(u)));
    const Vec3d r = arm(u), dr = squared(du) * (1 / s) - squared(u) * (dot(u, squared(du)) / (s * s * s));
    const Vec3d v = cross(r, omega),
                known = cross(r, cross(dr, omega) + cross(omega, v) - u * g) - cross(omega, inertia * omega);
    const Mat3d about = inertia + Mat3d::diagonal({dot(r, r), dot(r, r), dot(r, r)}) - Mat3d::outer(r, r);
    const Vec3d faster = inverse(about) * known;
    return {faster.x, faster.y, faster.z, du.x, du.y, du.z};
  }
};

void rattleback(Run& run) {
  const Rattleback law{
      {run["a"], run["c"], run["b"]}, run["below"], Mat3d{{2e-4, 0, 2e-5}, {0, 1.7e-3, 0}, {2e-5, 0, 1.6e-3}}};
  const double tilt = run["tilt"] * pi / 180, end = run["time"];
  for (const double spin : {-run["spin"], run["spin"]}) {
    const Quat turn = axis_angle(Vec3{0, 0, 1}, Real(tilt));
    Config c = run.fine_config();
    c.impulse_2007.slop = Real(1e-5);
    World w(c);
    add_gravity(run, w);
    const Material rough = material(10);
    add_ground(w, rough);
    const Vec3d u = rotate_back(convert<double>(turn), Vec3d{0, -1, 0}), omega = u * -spin;
    const Vec3d arm = rotate(convert<double>(turn), law.arm(u));
    const double height = -arm.y + law.below * std::cos(tilt);  // of the middle
    const Body stone = w.add(
        {.shape = ellipsoid(convert<Real>(law.radii)),
         .at = {0, height, 0},
         .turn = turn,
         .velocity = convert<Real>(cross(arm, Vec3d{0, spin, 0})),
         .spin = {0, Real(spin), 0},
         .mass = 1,
         .center = Vec3{0, Real(-law.below), 0},
         .inertia = Mat3{convert<Real>(law.inertia.c0), convert<Real>(law.inertia.c1), convert<Real>(law.inertia.c2)},
         .material = rough});
    Vector y{omega.x, omega.y, omega.z, u.x, u.y, u.z};
    double reversed = 0, exact_reversed = 0, fastest = 0;
    Plot& plot =
        run.plot(spin < 0 ? "Rate, turning the wrong way" : "Rate, turning the right way", "t [s]", "ω [rad/s]");
    run.until(w, end, [&] {
      y = solve_ode([&](double, const Vector& x) { return law.rate(x); }, 0, y, w.config().dt);
      const double exact = -(y[0] * y[3] + y[1] * y[4] + y[2] * y[5]), got = double(w[stone].spin().y);
      if (exact_reversed == 0 && exact * spin < 0) exact_reversed = w.time();
      if (reversed == 0 && got * spin < 0) reversed = w.time();
      if (reversed > 0) fastest = std::max(fastest, std::fabs(got));
      if (w.steps() % 4 != 0) return;
      plot.theory.emplace_back(w.time(), exact);
      plot.simulation.emplace_back(w.time(), got);
    });
    const std::string way = spin < 0 ? "wrong way: reverses (1: yes)" : "right way: reverses (1: yes)";
    run.check(way, "", exact_reversed > 0, reversed > 0, 0);
  }
}

// V33. A tippe top: a ball of radius R whose centre of mass lies the distance a below its middle, on the axis e of its
// inertia (A, A, C). Friction of the sliding contact lifts it; whatever the friction, L · (R ŷ − a e) is constant
// (Jellett 1872), for the contact's force has no moment about the line from the contact point to the centre of mass.
struct TippeTop {
  double R, a, C, A, mass, friction, g = standard_gravity;
  Vec3d arm(const Vec3d& e) const { return e * a - Vec3d{0, R, 0}; }  // from the centre of mass to the contact
  Vec3d over_inertia(const Vec3d& x, const Vec3d& e) const { return (x + e * ((A / C - 1) * dot(x, e))) * (1 / A); }
  // y = axis e, angular velocity, velocity of the centre of mass in x and z.
  Vector rate(const Vector& y) const {
    const Vec3d e{y[0], y[1], y[2]}, omega{y[3], y[4], y[5]}, momentum = omega * A + e * ((C - A) * dot(omega, e));
    const Vec3d slip = Vec3d{y[6], 0, y[7]} + cross(omega, arm(e));
    const double speed = std::sqrt(slip.x * slip.x + slip.z * slip.z + 1e-8);
    const Vec3d push{-friction * slip.x / speed, 1, -friction * slip.z / speed};  // of a unit of normal force
    // The height R − a e_y ties the centre's acceleration to ω', which is linear in the normal force.
    const Vec3d turn = over_inertia(cross(momentum, omega), e), by_force = over_inertia(cross(arm(e), push), e);
    const double free_lift = -a * (cross(turn, e) + cross(omega, cross(omega, e))).y, lift = -a * cross(by_force, e).y;
    const double normal = (g + free_lift) / (1 / mass - lift);
    const Vec3d change = cross(omega, e), spin_up = turn + by_force * normal;
    return {
        change.x, change.y, change.z, spin_up.x, spin_up.y, spin_up.z, normal * push.x / mass, normal * push.z / mass};
  }
};

void tippe_top(Run& run) {
  const double r = run["radius"], m = 0.1, c = 0.4 * m * r * r, tilt = 0.1, spin = run["spin"], end = 4;
  const TippeTop law{r, run["offset"], c, run["A / C"] * c, m, run["friction"]};
  const double degree = pi / 180;
  Config config = run.fine_config();
  config.impulse_2007.slop = Real(r / 1000);
  World w(config);
  add_gravity(run, w);
  const Material rubber = material(run.with("friction", law.friction));
  add_ground(w, rubber);
  const Quat turn = axis_angle(Vec3{0, 0, 1}, Real(tilt));
  const Vec3 axis = rotate(turn, Vec3{0, 1, 0});
  const Body top = w.add({.shape = sphere(Real(r)),
                          .at = {0, r, 0},
                          .turn = turn,
                          .spin = {0, Real(spin), 0},
                          .mass = Real(m),
                          .center = Vec3{0, Real(-law.a), 0},
                          .inertia = Mat3::diagonal({Real(law.A), Real(law.C), Real(law.A)}),
                          .material = rubber});
  Vector y{double(axis.x), double(axis.y), 0, 0, spin, 0, 0, 0};
  const auto jellett = [&] {
    const Vec3d e = convert<double>(rotate(w[top].pose().q, Vec3{0, 1, 0}));
    return -dot(convert<double>(w[top].angular_momentum()), law.arm(e));
  };
  const double at_start = jellett();
  double by_one = 0, exact_by_one = 0, most = 0, exact_most = 0, drift = 0;
  Plot& plot = run.plot("Tilt", "t [s]", "θ [°]");
  run.until(w, end, [&] {
    const double got = std::acos(std::clamp(double(rotate(w[top].pose().q, Vec3{0, 1, 0}).y), -1.0, 1.0)) / degree;
    y = solve_ode([&](double, const Vector& x) { return law.rate(x); }, 0, y, w.config().dt);
    const double exact = std::acos(std::clamp(y[1], -1.0, 1.0)) / degree;
    if (w.time() <= 1) by_one = std::max(by_one, got), exact_by_one = std::max(exact_by_one, exact);
    most = std::max(most, got), exact_most = std::max(exact_most, exact);
    drift = std::max(drift, std::fabs(jellett() / at_start - 1) / std::max(1.0, w.time()));
    if (w.steps() % 4 != 0) return;
    plot.theory.emplace_back(w.time(), exact);
    plot.simulation.emplace_back(w.time(), got);
  });
  run.below("drift of Jellett's constant, in a second", "%", 100 * drift, 1);
  run.check("passes 60° within 1 s (1: yes)", "", exact_by_one > 60, by_one > 60, 0);
  run.check("stays below 10° for 4 s (1: yes)", "", exact_most < 10, most < 10, 0);
}

}

std::vector<Case> tops() {
  return {
      {.id = "V31",
       .title = "Euler's disc",
       .group = "Rolling",
       .formula = "Ω² sin α = 4 g/R with the centre of mass at rest",
       .source = "Moffatt, Nature 404 (2000) 833",
       .parameters = {{"radius", 0.0376, 0.01, 10, "m"}, {"tilt", 20, 2, 60, "°"}},
       .sets = {{"steeper", {{"tilt", 35}, {"radius", 0.1}}}},
       .run = euler_disc,
       .without = {"gravity", "impulses"},
       .bite = {.substeps = 512},
       .sweep = "the change of the inclination",
       .order = 1,
       .sweep_from = 8},
      {.id = "V32",
       .title = "Rattleback",
       .group = "Rolling",
       .formula = "rolls without slip: turned one way it rattles and reverses, turned the other way it goes on",
       .source = "Kane & Levinson 1982; independent solution without slip, Dormand & Prince 5(4)",
       .parameters = {{"a", 0.2, 0.05, 1, "m"},
                      {"b", 0.03, 0.01, 0.2, "m"},
                      {"c", 0.02, 0.005, 0.1, "m"},
                      {"below", 0.01, 0, 0.05, "m"},
                      {"spin", 5, 1, 20, "rad/s"},
                      {"tilt", 0.5, 0, 5, "°"},
                      {"time", 6, 1, 30, "s"}},
       .sets = {{"slower", {{"spin", 4}}}},
       .run = rattleback,
       .without = {"gravity", "impulses"},
       .bite = {.substeps = 64}},
      {.id = "V33",
       .title = "Tippe top",
       .group = "Rolling",
       .formula = "L · (R ŷ − a e) constant whatever the friction; fast spin lifts it, slow spin does not",
       .source = "Jellett 1872; independent solution with sliding friction, Dormand & Prince 5(4)",
       .parameters = {{"radius", 0.02, 0.005, 1, "m"},
                      {"offset", 0.003, 1e-4, 0.1, "m"},
                      {"A / C", 0.975, 0.5, 2, "1"},
                      {"friction", 0.3, 0.01, 1, "1"},
                      {"spin", 300, 10, 1000, "rad/s"}},
       .sets = {{"slow", {{"spin", 150}}}},
       .run = tippe_top,
       .without = {"friction", "gravity"},
       .bite = {.substeps = 8}},
  };
}

}
