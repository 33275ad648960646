// Sliding and sticking: blocks on inclines, stopping distances, blocks that slide and spin, belts.
#include <algorithm>
#include <cmath>

#include "verify/cases/cases.h"
#include "verify/numerics.h"
#include "verify/scene.h"

namespace sudar::verify {

namespace {

// An incline through the origin that falls towards +x, and what lies on it.
struct Incline {
  World world;
  Quat turn;
  Incline(const Run& run, double angle, const Material& m)
      : world(run.config()), turn(axis_angle(Vec3{0, 0, -1}, Real(angle))) {
    add_gravity(run, world);
    add_ground(world, m, {}, turn);
  }
  // x down the incline, y away from it, z level.
  Body add(BodyDef def, const Vec3d& at, const Vec3d& velocity = {}) {
    const Quatd q = convert<double>(turn);
    def.at = Pos{} + rotate(q, at);
    def.turn = turn;
    def.velocity = convert<Real>(rotate(q, velocity));
    return world.add(def);
  }
  Vec3d position(Body b) const {
    const Pos p = world[b].center();
    return rotate_back(convert<double>(turn), Vec3d{p.x, p.y, p.z});
  }
  Vec3d velocity(Body b) const { return rotate_back(convert<double>(turn), convert<double>(world[b].velocity())); }
};

BodyDef flat_block(const Material& m) { return {.shape = box({1, 0.2, 1}), .mass = 1, .material = m}; }

// V15. A block holds while tan θ < μ; then it slides with g (sin θ − μ cos θ).
void incline(Run& run) {
  const double g = standard_gravity, mu = run["friction"], t = 5;
  const double broken = run.with("friction", mu);
  for (const double share : {0.98, 0.995, 1.005, 1.02}) {
    const double angle = std::atan(share * mu);
    Incline i(run, angle, material(broken));
    const Body block = i.add(flat_block(material(broken)), {0, 0.1, 0});
    run.until(i.world, t);
    const double way = i.position(block).x, slide = g * (std::sin(angle) - mu * std::cos(angle)) * t * t / 2;
    char name[64];
    std::snprintf(name, sizeof name, "tan θ = %.3f μ: way in 5 s", share);
    if (share < 1)
      run.check(name, "m", 0, way, 1e-5);
    else
      run.relative(name, "m", slide, way, 0.01);
  }
  const double angle = run["slope"] * pi / 180, slippery = run["slippery"], s = 1.5;
  const double low = run.with("friction", slippery);
  Incline i(run, angle, material(low));
  const Body block = i.add(flat_block(material(low)), {0, 0.1, 0});
  const double a = g * (std::sin(angle) - slippery * std::cos(angle)), h = run.h();
  Plot& plot = run.plot("Way down a steep incline", "t [s]", "s [m]");
  run.until(i.world, s, [&] {
    plot.theory.emplace_back(i.world.time(), a * square(i.world.time()) / 2);
    plot.simulation.emplace_back(i.world.time(), i.position(block).x);
  });
  const double n = std::round(s / h);
  run.relative("steep incline: way in 1.5 s, discrete law", "m", a * h * h * n * (n + 1) / 2, i.position(block).x,
               0.005);
  run.deviation(std::fabs(i.position(block).x - a * s * s / 2));
}

// V16. A block stops after v²/2μg, whatever the direction; in steps after h (N v − ½ μ g h N (N+1)).
void stopping(Run& run) {
  const double g = standard_gravity, mu = run["friction"], v = run["speed"], h = run.h();
  const double n = std::floor(v / (mu * g * h)), exact = h * (n * v - mu * g * h * n * (n + 1) / 2);
  double least = 1e300, most = 0, turned = 0;
  for (const double degrees : {0.0, 30.0, 45.0}) {
    const double angle = degrees * pi / 180;
    World w(run.config());
    add_gravity(run, w);
    const Material m = material(run.with("friction", mu));
    add_ground(w, m);
    BodyDef def = flat_block(m);
    def.at = {0, 0.1, 0}, def.velocity = {Real(v * std::cos(angle)), 0, Real(v * std::sin(angle))};
    const Body block = w.add(def);
    run.until(w, 1.2 * v / (mu * g));
    const Pos p = w[block].center();
    const double way = std::hypot(p.x, p.z);
    least = std::min(least, way), most = std::max(most, way);
    turned = std::max(turned, std::fabs(std::atan2(p.z, p.x) - angle));
    run.relative("way at " + std::to_string(int(degrees)) + "°, discrete law", "m", exact, way, 1e-4);
    if (degrees == 0) run.deviation(std::fabs(way - v * v / (2 * mu * g)));
  }
  run.below("spread over the directions", "1", (most - least) / exact, 1e-4);
  run.below("turn of the path", "rad", turned, 1e-4);
}

// V30. A thin square plate that slides and spins, its weight on four corners: friction of each corner against its own
// velocity, so that spinning makes it slide farther. Its centre of mass lies at its lower side, so that friction has no
// arm to shift the weight to the corners in front.
void spinning_plate(Run& run) {
  const double g = standard_gravity, mu = run["friction"], v = run["speed"], omega = run["spin"], a = run["edge"];
  const double thickness = 0.02 * a;
  const auto law = [&](double, const Vector& y) {  // x, z, turn, vx, vz, ω
    double fx = 0, fz = 0, torque = 0;
    for (int k = 0; k < 4; ++k) {
      const double angle = y[2] + pi / 4 + k * pi / 2, x = a / std::sqrt(2) * std::cos(angle),
                   z = a / std::sqrt(2) * std::sin(angle);
      const double ux = y[3] - y[5] * z, uz = y[4] + y[5] * x, u = std::max(1e-9, std::hypot(ux, uz));
      fx -= ux / u, fz -= uz / u, torque -= (x * uz - z * ux) / u;
    }
    return Vector{y[3], y[4], y[5], mu * g * fx / 4, mu * g * fz / 4, mu * g * torque / 4 / (a * a / 6)};
  };
  // Until it nearly rests: the end of the slide is its singular point.
  const Moment stop = solve_until(law, 0, {0, 0, 0, v, 0, omega}, 100, [&](double, const Vector& y) {
    return 0.001 - std::hypot(y[3], y[4]) - a * std::fabs(y[5]) / 2;
  });
  World w(run.fine_config());
  add_gravity(run, w);
  const Material m = material(run.with("friction", mu));
  add_ground(w, m);
  const Body plate = w.add({.shape = box({Real(a), Real(thickness), Real(a)}),
                            .at = {0, thickness / 2, 0},
                            .velocity = {Real(v), 0, 0},
                            .spin = {0, Real(-omega), 0},
                            .mass = 1,
                            .center = Vec3{0, Real(-thickness / 2), 0},
                            .inertia = Mat3::diagonal({Real(a * a / 12), Real(a * a / 6), Real(a * a / 12)}),
                            .material = m});
  double turn = 0, rest = std::nan("");
  Plot& plot = run.plot("Path", "x [m]", "z [m]");
  run.until(w, 1.3 * stop.t, [&] {
    turn -= double(w[plate].spin().y) * w.config().dt;
    plot.simulation.emplace_back(w[plate].center().x, w[plate].center().z);
    if (std::isnan(rest) && double(length(w[plate].velocity()) + length(w[plate].spin()) * Real(a) / 2) < 0.01)
      rest = w.time();
  });
  Vector y{0, 0, 0, v, 0, omega};
  for (int k = 1; k <= 100; ++k) {
    y = solve_ode(law, stop.t * (k - 1) / 100, y, stop.t * k / 100);
    plot.theory.emplace_back(y[0], y[1]);
  }
  run.relative("time to rest", "s", stop.t, rest, 0.05);
  run.relative("way along", "m", stop.y[0], w[plate].center().x, 0.05);
  run.relative("turn", "rad", stop.y[2], turn, 0.05);
  run.deviation(std::hypot(stop.y[0] - w[plate].center().x, stop.y[1] - w[plate].center().z));
  run.relative("way across", "m", stop.y[1], w[plate].center().z, 0.05);
}

// V35. A block thrown sideways on an incline: friction against its velocity, an ordinary differential equation.
void sideways(Run& run) {
  const double g = standard_gravity, mu = run["friction"], angle = run["slope"] * pi / 180, v = run["speed"],
               t = run["time"];
  const auto law = [&](double, const Vector& y) {
    const double u = std::hypot(y[2], y[3]), brake = mu * g * std::cos(angle) / std::max(u, 1e-12);
    return Vector{y[2], y[3], -brake * y[2], g * std::sin(angle) - brake * y[3]};
  };
  Incline i(run, angle, material(run.with("friction", mu)));
  const Body block = i.add(flat_block(material(run.with("friction", mu))), {0, 0.1, 0}, {0, 0, v});
  Plot& plot = run.plot("Path", "across [m]", "down [m]");
  Vector y{0, 0, v, 0};
  double before = 0;
  run.until(i.world, t, [&] {
    y = solve_ode(law, before, y, i.world.time());
    before = i.world.time();
    plot.theory.emplace_back(y[0], y[1]);
    plot.simulation.emplace_back(i.position(block).z, i.position(block).x);
  });
  run.relative("way across", "m", y[0], i.position(block).z, 0.01);
  run.relative("way down", "m", y[1], i.position(block).x, 0.01);
  run.relative("velocity across", "m/s", y[2], i.velocity(block).z, 0.01);
  run.relative("velocity down", "m/s", y[3], i.velocity(block).x, 0.01);
  run.deviation(std::hypot(y[0] - i.position(block).z, y[1] - i.position(block).x));
}

// V63. A block laid on a moving belt: it slips for v/μg, and v²/2μg on the belt. The belt is a body that moves, or a
// surface that moves on a body that stands.
void conveyor(Run& run) {
  const double g = standard_gravity, mu = run["friction"], v = run["speed"];
  World w(run.fine_config());
  add_gravity(run, w);
  const Material m = material(run.with("friction", mu));
  BodyDef belt{.shape = box({40, 1, 4}), .at = {0, -0.5, 0}, .material = m, .motion = Motion::fixed};
  if (run["surface"] > 0)
    belt.surface_velocity = {Real(v), 0, 0};
  else
    belt.velocity = {Real(v), 0, 0}, belt.motion = Motion::kinematic;
  w.add(belt);
  BodyDef def = flat_block(m);
  def.at = {0, 0.1, 0};
  const Body block = w.add(def);
  double slipped = 0, until = std::nan("");
  Plot& plot = run.plot("Velocity of the block", "t [s]", "v [m/s]");
  run.until(w, 2 * v / (mu * g), [&] {
    const double slip = v - double(w[block].velocity().x);
    slipped += slip * w.config().dt;
    if (std::isnan(until) && slip < 1e-3 * v) until = w.time();
    plot.theory.emplace_back(w.time(), std::min(v, mu * g * w.time()));
    plot.simulation.emplace_back(w.time(), double(w[block].velocity().x));
  });
  run.relative("time of slipping", "s", v / (mu * g), until, 0.01);
  run.relative("way slipped", "m", v * v / (2 * mu * g), slipped, 0.01);
  run.deviation(std::fabs(slipped - v * v / (2 * mu * g)));
}

}

std::vector<Case> friction() {
  return {
      {.id = "V15",
       .title = "Block on an incline",
       .group = "Friction",
       .formula = "holds while tan θ < μ; s = ½ g (sin θ − μ cos θ) t²",
       .source = "Coulomb's law",
       .parameters = {{"friction", 0.5, 0.1, 1.5, "1"}, {"slope", 30, 5, 60, "°"}, {"slippery", 0.4, 0, 0.5, "1"}},
       .sets = {{"μ = 0.3", {{"friction", 0.3}, {"slippery", 0.2}}}},
       .run = incline,
       .without = {"friction", "gravity"},
       .others = "Jolt creeps 5e-8 m, onset within 0.5 %; Box3D creeps 2.9e-4 … 8e-4 m; Havok sticks at 1.02; PhysX "
                 "creeps 0.065 m",
       .sweep = "the way down the steep incline",
       .order = 1},
      {.id = "V16",
       .title = "Stopping distance",
       .group = "Friction",
       .formula = "v²/2μg; in steps h (N v − ½ μ g h N (N+1))",
       .source = "sum of the discrete law",
       .parameters = {{"friction", 0.3, 0.05, 1, "1"}, {"speed", 5, 0.5, 20, "m/s"}},
       .sets = {{"faster", {{"friction", 0.5}, {"speed", 8}}}},
       .run = stopping,
       .without = {"friction", "gravity"},
       .others = "Box3D 4.236951 m in all directions, Jolt 4.20574, PhysX turns by 0.27°",
       .sweep = "the distance from v²/2μg",
       .order = 1},
      {.id = "V30",
       .title = "Sliding and spinning plate",
       .group = "Friction",
       .formula = "each corner bears m g/4 and rubs against its own velocity",
       .source = "Contensou 1963; independent solution, Dormand & Prince 5(4)",
       .parameters = {{"friction", 0.3, 0.05, 1, "1"},
                      {"speed", 1.5, 0.1, 10, "m/s"},
                      {"spin", 12, 0, 60, "rad/s"},
                      {"edge", 1, 0.1, 5, "m"}},
       .sets = {{"slower spin", {{"spin", 4}}}},
       .run = spinning_plate,
       .without = {"friction", "gravity"},
       .others = "way (1.383 m): Bullet 1.395, MuJoCo 1.349, PhysX 1.161, Havok 1.619; Box3D, Rapier, Jolt 0.37 … 0.38",
       .sweep = "the place at rest",
       .order = 1},
      {.id = "V35",
       .title = "Sideways on an incline",
       .group = "Friction",
       .formula = "v̇ = g sin α ŝ − μ g cos α v̂",
       .source = "Coulomb's cone; independent solution, Dormand & Prince 5(4)",
       .parameters = {{"friction", 0.5, 0.05, 1, "1"},
                      {"slope", 20, 1, 45, "°"},
                      {"speed", 2, 0.1, 10, "m/s"},
                      {"time", 0.5, 0.1, 1, "s"}},
       .sets = {{"steeper", {{"slope", 30}, {"friction", 0.4}}}},
       .run = sideways,
       .without = {"friction", "gravity"},
       .others = "way across (0.48273 m): Box3D, Rapier 0.47941, Havok 0.47857, Jolt 0.46937; a pyramid 0.42385",
       .sweep = "the place at the end",
       .order = 1},
      {.id = "V63",
       .title = "Block on a belt",
       .group = "Friction",
       .formula = "slips for v/μg, v²/2μg far",
       .source = "Coulomb's law",
       .parameters = {{"friction", 0.4, 0.05, 1, "1"}, {"speed", 2, 0.1, 5, "m/s"}, {"surface", 0, 0, 1, whole_number}},
       .sets = {{"slow", {{"speed", 1}, {"friction", 0.2}}}, {"moving surface", {{"surface", 1}}}},
       .run = conveyor,
       .without = {"friction", "gravity"},
       .sweep = "the way slipped",
       .order = 1},
  };
}

}
