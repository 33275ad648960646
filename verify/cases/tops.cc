// Tops on a floor.
#include <algorithm>
#include <cmath>

#include "verify/cases/cases.h"
#include "verify/numerics.h"
#include "verify/scene.h"

namespace sudar::verify {

namespace {

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
    return {change.x, change.y, change.z, spin_up.x, spin_up.y, spin_up.z, normal * push.x / mass, normal * push.z / mass};
  }
};

void tippe_top(Run& run) {
  const double r = run["radius"], m = 0.1, c = 0.4 * m * r * r, tilt = 0.1, spin = run["spin"], end = 4;
  const TippeTop law{r, run["offset"], c, run["A / C"] * c, m, run["friction"]};
  const double degree = pi / 180;
  Config config = run.fine_config();
  config.impulse_2007.slop = Real(r / 1000);
  World w(config);
  add_gravity(w, standard_gravity);
  const Material rubber = material(run.with("friction", law.friction));
  add_ground(w, rubber);
  const Quat turn = axis_angle(Vec3{0, 0, 1}, Real(tilt));
  const Vec3 axis = rotate(turn, Vec3{0, 1, 0});
  const Body top = w.add({.shape = sphere(Real(r)), .at = {0, r, 0}, .turn = turn, .spin = {0, Real(spin), 0}, .mass = Real(m), .center = Vec3{0, Real(-law.a), 0},
                          .inertia = Mat3::diagonal({Real(law.A), Real(law.C), Real(law.A)}), .material = rubber});
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
  run.deviation(drift);
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
       .needs = "an exact cylinder"},
      {.id = "V32",
       .title = "Rattleback",
       .group = "Rolling",
       .formula = "spin one way reverses, the other way persists",
       .source = "Garcia & Hubbard 1988; independent solution without slip",
       .needs = "an ellipsoid"},
      {.id = "V33",
       .title = "Tippe top",
       .group = "Rolling",
       .formula = "L · (R ŷ − a e) constant whatever the friction; fast spin lifts it, slow spin does not",
       .source = "Jellett 1872; independent solution with sliding friction, Dormand & Prince 5(4)",
       .parameters = {{"radius", 0.02, 0.005, 1, "m"}, {"offset", 0.003, 1e-4, 0.1, "m"}, {"A / C", 0.975, 0.5, 2, "1"}, {"friction", 0.3, 0.01, 1, "1"}, {"spin", 300, 10, 1000, "rad/s"}},
       .sets = {{"slow", {{"spin", 150}}}},
       .run = tippe_top,
       .without = "friction",
       .sweep = "the drift of Jellett's constant",
       .order = 1,
       .sweep_from = 8},
  };
}

}
