// The mistakes of the thesis (docs/thesis.md): what the formula as printed gives, beside what is right and what the
// engine gives.
#include <algorithm>
#include <cmath>

#include "verify/cases/cases.h"
#include "verify/numerics.h"
#include "verify/scene.h"

namespace sudar::verify {

namespace {

Config thesis_steps(const Run& run) {
  Config c = run.config();
  c.dt = 0.01, c.substeps = 1;
  return c;
}

// E1. A tetrahedron's volume is a sixth of a · (b × c); a quarter is printed.
void volume(Run& run) {
  const double a = run["a"], b = run["b"], c = run["c"], exact = a * b * c / 6;
  const Real height = Real(run.without("the right height") ? 2 * c : c);
  const std::vector<Vec3> corners{{}, {Real(a), 0, 0}, {1, Real(b), 0}, {1, 1, height}};
  run.relative("volume of a tetrahedron", "m³", exact, hull(corners).mass_properties().volume, 1e-6);
  run.refutes("with a quarter", "m³", exact, 6.0 / 4 * exact, 0.01 * exact);
}

// E2. Drag acts against the motion; −B v², as printed, drives a body that flies backwards ever faster.
void drag(Run& run) {
  const double v = -run["speed"], b = run["drag"], t = run["time"], exact = v / (1 + b * std::fabs(v) * t);
  World w(thesis_steps(run));
  if (!run.without("drag")) w.add(Drag{.quadratic = Real(b)});
  const Body ball = w.add({.shape = sphere(1), .velocity = {Real(v), 0, 0}});
  run.until(w, t);
  run.relative("velocity of a body that flies backwards", "m/s", exact, double(w[ball].velocity().x), 0.02);
  run.refutes("with −B v²", "m/s", exact, v / (1 + b * v * t), 0.1 * std::fabs(exact));
}

// E3. The sliding impulse follows from the speed of approach u_n; printed is the change sought, Δu_n = −(1+e) u_n.
void sliding(Run& run) {
  const double along = run["along"], down = run["down"], e = run["restitution"], mu = run["friction"], r = 0.1;
  World w(thesis_steps(run));
  const Material m = material(run.with("friction", mu), e);
  add_ground(w, m);
  const Body ball = w.add(
      {.shape = sphere(Real(r)), .at = {0, r, 0}, .velocity = {Real(along), Real(-down), 0}, .mass = 1, .material = m});
  w.step();
  run.relative("velocity along the floor", "m/s", along - mu * (1 + e) * down, double(w[ball].velocity().x), 1e-3);
  run.relative("velocity upwards", "m/s", e * down, double(w[ball].velocity().y), 1e-3);
  const double printed = -(1 + e) * (1 + e) * down;  // of pₙ/m
  run.refutes("with Δu_n: along", "m/s", along - mu * (1 + e) * down, along - mu * printed, 0.01);
  run.refutes("with Δu_n: upwards", "m/s", e * down, -down + printed, 0.01);
}

// E4. A bar pushes along itself. K⁻¹(−u_n n), as printed, does not, and makes energy in some states.
struct Bodies {  // two bodies of a bar along n, in double
  Mat3d inverse_inertia[2];
  double inverse_mass[2];
  Vec3d arm[2], velocity[2], spin[2], n;
  Vec3d relative() const { return velocity[0] + cross(spin[0], arm[0]) - velocity[1] - cross(spin[1], arm[1]); }
  Mat3d k() const {
    Mat3d sum = Mat3d::diagonal({0, 0, 0});
    for (int i : {0, 1}) {
      const Mat3d s = Mat3d::skew(arm[i]);
      sum = sum + Mat3d::diagonal({inverse_mass[i], inverse_mass[i], inverse_mass[i]}) - s * inverse_inertia[i] * s;
    }
    return sum;
  }
  // What the impulse p on the first and −p on the second does to the energy: p · (u + u')/2.
  double gain(const Vec3d& p) const { return dot(p, relative() * 2 + k() * p) / 2; }
};

void bar(Run& run) {
  Random random{std::uint32_t(run["seed"])};
  const auto vector = [&](double size) {
    return Vec3d{random.between(-size, size), random.between(-size, size), random.between(-size, size)};
  };
  const int states = int(run["states"]);
  int printed = 0, right = 0, engine = 0;
  for (int i = 0; i < states; ++i) {
    World w(thesis_steps(run));
    Bodies s;
    Body b[2];
    Pos ends[2];
    for (int k : {0, 1}) {
      BodyDef def{.shape = k == 0 ? box({4, 1, 1}) : box({1, 2, 3}),
                  .at = Pos{6.0 * k, double(k), 0},
                  .turn = rotation(convert<Real>(vector(2))),
                  .velocity = convert<Real>(vector(3)),
                  .spin = convert<Real>(vector(3)),
                  .density = Real(1 + k)};
      b[k] = w.add(def);
      s.arm[k] = vector(2), ends[k] = def.at + s.arm[k];
      const Mat3 inertia = w[b[k]].inertia();
      s.inverse_inertia[k] =
          inverse(Mat3d{convert<double>(inertia.c0), convert<double>(inertia.c1), convert<double>(inertia.c2)});
      s.inverse_mass[k] = 1 / double(w[b[k]].mass()), s.velocity[k] = convert<double>(def.velocity),
      s.spin[k] = convert<double>(def.spin);
    }
    s.n = normalize(Vec3d{ends[1].x - ends[0].x, ends[1].y - ends[0].y, ends[1].z - ends[0].z});
    const double un = dot(s.relative(), s.n);
    printed += s.gain(inverse(s.k()) * (s.n * -un)) > 0;
    right += s.gain(s.n * (-un / dot(s.n, s.k() * s.n))) > 0;
    const double before = w.energy().kinetic;
    if (run.without("impulses along the bar")) {
      const Vec3d p = inverse(s.k()) * (s.n * -un);
      for (int k : {0, 1}) {
        const Vec3d push = k == 0 ? p : p * -1.0;
        w.set_velocity(b[k], convert<Real>(s.velocity[k] + push * s.inverse_mass[k]),
                       convert<Real>(s.spin[k] + s.inverse_inertia[k] * cross(s.arm[k], push)));
      }
    } else {
      w.join(Bar{.a = b[0], .b = b[1], .at_a = ends[0], .at_b = ends[1]});
    }
    w.step(1e-5);
    engine += w.energy().kinetic > before * (1 + 1e-5);
  }
  run.check("states that gain energy, −(u_n/nᵀKn) n", "%", 0, 100.0 * right / states, 0);
  run.check("states that gain energy, the engine", "%", 0, 100.0 * engine / states, 0);
  run.refutes("states that gain energy, K⁻¹(−u_n n)", "%", 0, 100.0 * printed / states, 1);
}

// E5. The correction of overlaps is a velocity: bodies of every mass leave by the same way, b (δ − δ_max).
void correction(Run& run) {
  const double m = run["mass"], depth = run["overlap"];
  World w(thesis_steps(run));
  add_ground(w, material(0.5));
  const Body cube =
      w.add({.shape = box({1, 1, 1}), .at = {0, 0.5 - depth, 0}, .mass = Real(m), .material = material(0.5)});
  if (!run.without("impulses")) w.step();
  const Impulse2007& s = w.config().impulse_2007;
  const double exact = double(s.correction) * (depth - double(s.slop));
  run.check("way out of the overlap in a step", "m", exact, w[cube].center().y - 0.5 + depth, 1e-4);
  run.refutes("with Δu_e as an impulse", "m", exact, exact / m, 1e-4);
}

// E6. n sub-steps cost n times as much; that the world ran n times as fast is printed.
void cost(Run& run) {
  const int n = int(run["sub-steps"]);
  Config c = thesis_steps(run);
  c.substeps = n;
  World w(c);
  add_gravity(run, w);
  const Body ball = w.add({.shape = sphere(1)});
  for (int i = 0; i < (run.without("sub-steps") ? n : 1); ++i) w.step();
  run.check("simulated time of a step", "s", c.dt, w.time(), 1e-12);
  run.relative("speed of fall after it", "m/s", standard_gravity * c.dt, -double(w[ball].velocity().y), 1e-5);
  run.refutes("simulated time as printed", "s", c.dt, n * c.dt, 1e-12);
}

// E7. Friction is limited by the accumulated impulse. A train pulled with less than it holds must not move; with the
// cone tested for each increment, as printed and in the prototype, it does.
double train_moves(Run& run, bool per_increment) {
  Config c = thesis_steps(run);
  c.friction_mix = Mix::min;
  c.impulse_2007.friction_per_increment = per_increment;
  World w(c);
  add_gravity(run, w, 5);
  add_ground(w, material(100), {0, -1.5, 0});
  const double mu = run.with("friction", 0.15), holds = 0.15 * 10 * 90 * 5;
  Body last, first;
  for (int i = 0; i < 10; ++i) {
    const Body wagon =
        w.add({.shape = box({10, 3, 3}),
               .at = {11.0 * i, 0, 0},
               .density = 1,
               .material = {.friction_static = Real(mu), .friction_dynamic = Real(mu * 2 / 3), .restitution = 0}});
    if (i == 0) first = wagon;
    for (const double y : {-1.0, 1.0}) {
      if (i > 0) w.join(Ball{.a = last, .b = wagon, .at = {11 * i - 5.5, y, 0}});
    }
    last = wagon;
  }
  w.add(Thruster{.body = first, .force = {Real(-run["pull"] * holds), 0, 0}});
  run.until(w, 2);
  return -w[first].center().x;
}

void cone_test(Run& run) {
  run.check("way of a train that friction holds, in 2 s", "m", 0, train_moves(run, false), 1e-5);
  run.refutes("with the cone tested per increment", "m", 0, train_moves(run, true), 1e-5);
}

// E8. A contact reduced to one point carries no tilting moment: a slightly crooked tower falls.
double tower_leans(Run& run, bool one_point) {
  Config c = thesis_steps(run);
  c.impulse_2007.one_point_contact = one_point;
  World w(c);
  add_gravity(run, w, 5);
  const Material m = material(0.5);
  add_ground(w, m);
  std::vector<std::pair<Body, Vec3d>> cubes;
  for (int i = 0; i < int(run["cubes"]); ++i) {
    const Vec3d at{i % 2 == 0 ? 0.1 : -0.1, 2.1 + 4.1 * i, 0};
    cubes.emplace_back(w.add({.shape = box({4, 4, 4}), .at = Pos{} + at, .density = 1, .material = m}), at);
  }
  run.until(w, 10);
  double worst = 0;
  for (const auto& [cube, at] : cubes)
    worst = std::max(worst, std::hypot(w[cube].center().x - at.x, w[cube].center().z - at.z));
  return worst;
}

void one_point(Run& run) {
  run.check("largest way sideways of a cube in 10 s", "m", 0, tower_leans(run, run.without("four points")), 0.02);
  run.refutes("with one point", "m", 0, tower_leans(run, true), 0.02);
}

// E9. q += ½ Δt ω q, normalised, turns by 2 atan(ω Δt/2) instead of ω Δt.
void turning(Run& run) {
  const double omega = run["spin"], dt = 1.0 / 60;
  Config c = run.config();
  c.substeps = 1;
  World w(c);
  const Body ball = w.add({.shape = sphere(1), .spin = {0, Real(run.with("spin", omega)), 0}});
  w.step();
  const Vec3 x = rotate(w[ball].pose().q, Vec3{1, 0, 0});
  run.relative("angle of a step", "rad", omega * dt, std::atan2(-double(x.z), double(x.x)), 5e-3);
  run.refutes("by q += ½ Δt ω q", "rad", omega * dt, 2 * std::atan(omega * dt / 2), 5e-3 * omega * dt);
}

}

std::vector<Case> errata() {
  constexpr const char* group = "The thesis's errata";
  constexpr const char* source = "docs/thesis.md";
  return {
      {.id = "E1",
       .title = "Volume of a tetrahedron",
       .group = group,
       .formula = "V = a·(b × c)/6, not /4",
       .source = source,
       .parameters = {{"a", 2, 0.1, 100, "m"}, {"b", 3, 0.1, 100, "m"}, {"c", 4, 0.1, 100, "m"}},
       .sets = {{"cube", {{"b", 2}, {"c", 2}}}},
       .run = volume,
       .without = {"the right height"},
       .uses_solver = false},
      {.id = "E2",
       .title = "Drag has a direction",
       .group = group,
       .formula = "F = −B |v| v, not −B v²",
       .source = source,
       .parameters = {{"speed", 10, 0.1, 100, "m/s"}, {"drag", 0.5, 0.001, 1, "1/m"}, {"time", 0.1, 0.01, 1, "s"}},
       .sets = {{"thin air", {{"drag", 0.1}, {"time", 0.5}}}},
       .run = drag,
       .without = {"drag"}},
      {.id = "E3",
       .title = "Sliding impulse",
       .group = group,
       .formula = "pₙ = −(1+e) uₙ/(nᵀK(n − μ t)), not of Δuₙ",
       .source = source,
       .parameters = {{"along", 3, 2, 20, "m/s"},
                      {"down", 4, 0.1, 20, "m/s"},
                      {"restitution", 0.5, 0, 0.9, "1"},
                      {"friction", 0.1, 0.01, 0.15, "1"}},
       .sets = {{"e = 0", {{"restitution", 0}, {"down", 2}}}},
       .run = sliding,
       .without = {"friction", "impulses"}},
      {.id = "E4",
       .title = "Impulse of a bar",
       .group = group,
       .formula = "p = −(uₙ/nᵀKn) n, not K⁻¹(−uₙ n)",
       .source = source,
       .parameters = {{"states", 300, 10, 1e5, whole_number}, {"seed", 1, 0, 1e9, whole_number}},
       .sets = {{"other states", {{"seed", 2}}}},
       .run = bar,
       .without = {"impulses along the bar"}},
      {.id = "E5",
       .title = "Correction of overlaps",
       .group = group,
       .formula = "Δu_e = b (δ − δ_max)/Δt is a velocity, not an impulse",
       .source = source,
       .parameters = {{"mass", 1000, 2, 1e6, "kg"}, {"overlap", 0.11, 0.02, 0.3, "m"}},
       .sets = {{"10 kg", {{"mass", 10}, {"overlap", 0.06}}}},
       .run = correction,
       .without = {"impulses"},
       .only = Solver::impulse_2007},
      {.id = "E6",
       .title = "What sub-steps cost",
       .group = group,
       .formula = "n sub-steps cost n times as much; time does not pass faster",
       .source = source,
       .parameters = {{"sub-steps", 4, 2, 100, whole_number}},
       .sets = {{"ten", {{"sub-steps", 10}}}},
       .run = cost,
       .without = {"gravity", "sub-steps"}},
      {.id = "E7",
       .title = "Friction cone",
       .group = group,
       .formula = "|Σ p_t| ≤ μ Σ pₙ, not for each increment",
       .source = source,
       .parameters = {{"pull", 0.97, 0.5, 0.99, "of what holds"}},
       .sets = {{"0.9", {{"pull", 0.9}}}},
       .run = cone_test,
       .without = {"friction"}},
      {.id = "E8",
       .title = "Contacts of one point",
       .group = group,
       .formula = "a face carries a moment, a point does not",
       .source = source,
       .parameters = {{"cubes", 10, 2, 15, whole_number}},
       .sets = {{"six", {{"cubes", 6}}}},
       .run = one_point,
       .without = {"four points"},
       .only = Solver::impulse_2007},
      {.id = "E9",
       .title = "Turning in a step",
       .group = group,
       .formula = "q ← exp(½ Δt ω) q, not q + ½ Δt ω q",
       .source = source,
       .parameters = {{"spin", 60, 10, 150, "rad/s"}},
       .sets = {{"30 rad/s", {{"spin", 30}}}},
       .run = turning,
       .without = {"spin"}},
  };
}

}
