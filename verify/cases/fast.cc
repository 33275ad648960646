// Bodies that move farther in a step than they are large: none may pass through what is in its way.
#include <cmath>

#include "verify/cases/cases.h"
#include "verify/numerics.h"
#include "verify/scene.h"

namespace sudar::verify {

namespace {

// One that flies straight, hits something once and flies straight again. When it did so is where the two lines meet;
// NaN where nothing turned it.
class Flight {
 public:
  Flight(const World& w, Body b) : world_(w), body_(b), from_(place()), velocity_(convert<double>(w[b].velocity())) {}
  double turned_at() const {
    const Vec3d now = convert<double>(world_[body_].velocity()), change = velocity_ - now;
    return dot(place() - from_ - now * world_.time(), change) / dot(change, change);
  }

 private:
  Vec3d place() const {
    const Pos p = world_[body_].center();
    return {p.x, p.y, p.z};
  }
  const World& world_;
  Body body_;
  Vec3d from_, velocity_;
};

// The first moment at which the gap, positive at first, has closed.
double closes(const std::function<double(double)>& gap, double latest) {
  double t = 0;
  while (gap(t) > 0) {
    if (t > latest) throw Error("closes", "the gap stays open");
    t += latest / 1e5;
  }
  return root(gap, t - latest / 1e5, t);
}

World empty_world(const Run& run) {
  Config c = run.config();
  c.impulse_2007.slop = Real(1e-5);
  return World(c);
}

constexpr double wall_thickness = 0.001;
void add_wall(World& w, double x, const Material& m) {
  w.add({.shape = box({Real(wall_thickness), 4, 4}), .at = {x, 0, 0}, .material = m, .motion = Motion::fixed});
}

// A moment of impact: a share of the step, 10⁻⁴, is allowed.
void check_moment(Run& run, const std::string& what, double exact, double got) {
  run.check(what + ": time of impact", "s", exact, got, 1e-4 * run.config().dt);
}

// V42. A bullet at a thin wall: t = (d − r − w/2)/v; it stops there, or flies back.
void bullet(Run& run) {
  const double v = run["speed"], d = run["distance"], r = 0.01, stops = d - r - wall_thickness / 2, moment = stops / v;
  for (const double e : {0.0, 1.0}) {
    World w = empty_world(run);
    const Material m = material(0, e);
    add_wall(w, d, m);
    const Body b = w.add({.shape = sphere(Real(r)), .velocity = {Real(v), 0, 0}, .material = m});
    const Flight flight(w, b);
    if (e > 0) {
      run.until(w, 2 * moment);
      check_moment(run, "bullet", moment, flight.turned_at());
      continue;
    }
    Plot& plot = run.plot("Bullet", "t [s]", "x [m]");
    plot.theory = {{0, 0}, {moment, stops}, {moment + 0.5, stops}};
    run.until(w, moment + 0.5, [&] { plot.simulation.emplace_back(w.time(), w[b].center().x); });
    run.check("bullet: where it stops", "m", stops, w[b].center().x, wall_thickness / 2);
  }
}

// A capsule that turns as it flies at the wall, and a cube that does so as it flies at the floor. Neither is slowed in
// its turning by the impact: their inertia is large.
void spinning(Run& run) {
  const double v = run["speed"] / 100, turns = run["turns"] * v, length = 1, r = 0.05, d = 1.5;
  const Material elastic = material(0, 1);
  const Mat3 stubborn = Mat3::diagonal({1e3, 1e3, 1e3});
  World w = empty_world(run);
  add_wall(w, d, elastic);
  const Body capsule_ = w.add({.shape = capsule(Real(r), Real(length)),
                               .velocity = {Real(v), 0, 0},
                               .spin = {0, 0, Real(turns)},
                               .mass = 1,
                               .inertia = stubborn,
                               .material = elastic});
  const Flight flight(w, capsule_);
  const double moment =
      closes([&](double t) { return d - wall_thickness / 2 - r - v * t - length / 2 * std::fabs(std::sin(turns * t)); },
             d / v);
  run.until(w, 1.5 * moment);
  check_moment(run, "spinning capsule", moment, flight.turned_at());

  World c = empty_world(run);
  add_ground(c, elastic, {0, -d, 0});
  const Body cube = c.add({.shape = box({1, 1, 1}),
                           .velocity = {0, Real(-v), 0},
                           .spin = {0, 0, Real(turns)},
                           .mass = 1,
                           .inertia = stubborn,
                           .material = elastic});
  const Flight fall(c, cube);
  const double lands = closes(
      [&](double t) { return d - v * t - (std::fabs(std::sin(turns * t)) + std::fabs(std::cos(turns * t))) / 2; },
      d / v);
  run.until(c, 1.5 * lands);
  check_moment(run, "spinning cube", lands, fall.turned_at());
}

// Two balls whose ways cross: |p + u t| = 2 r, then smooth and elastic.
void crossing(Run& run) {
  const double v = run["speed"], d = run["distance"], r = 0.1;
  World w = empty_world(run);
  const Material elastic = material(0, 1);
  const auto add = [&](const Vec3d& at, const Vec3d& velocity) {
    return w.add({.shape = sphere(Real(r)),
                  .at = Pos{} + at,
                  .velocity = convert<Real>(velocity),
                  .mass = 1,
                  .material = elastic});
  };
  const Vec3d first{-d, 0, 0}, second{0.6 * r, -d, 0}, along{v, 0, 0}, up{0, v, 0}, p = second - first, u = up - along;
  const Body a = add(first, along), b = add(second, up);
  const Flight flight(w, a);
  const double pu = dot(p, u), uu = dot(u, u), moment = (-pu - std::sqrt(pu * pu - uu * (dot(p, p) - 4 * r * r))) / uu;
  const Vec3d n = (p + u * moment) * (1 / (2 * r)), exact = along + n * dot(u, n);
  run.until(w, 2 * moment);
  check_moment(run, "crossing balls", moment, flight.turned_at());
  run.check("crossing balls: first, along", "m/s", exact.x, double(w[a].velocity().x), 1e-4 * v);
  run.check("crossing balls: first, across", "m/s", exact.y, double(w[a].velocity().y), 1e-4 * v);
  run.check("crossing balls: second, along", "m/s", v - exact.x, double(w[b].velocity().x), 1e-4 * v);
}

void fast_bodies(Run& run) {
  bullet(run);
  spinning(run);
  crossing(run);
}

}

std::vector<Case> fast() {
  return {{.id = "V42",
           .title = "Fast bodies: time of impact",
           .group = "Impacts",
           .formula = "d − ½ w − r = v t; d − ½ w − r = v t + ½ L |sin ω t|; |p + u t| = 2 r",
           .source = "motion along a line; root of the gap",
           .parameters = {{"speed", 1e4, 0.01, 1e5, "m/s"},
                          {"distance", 50, 1, 1000, "m"},
                          {"turns", 1, 0.1, 10, "rad a metre"}},
           .sets = {{"100 m/s", {{"speed", 100}, {"distance", 2}}}},
           .run = fast_bodies,
           .without = {"impulses"},
           .bite = {.values = {{"speed", 1}, {"distance", 1}}},
           .others = "Rapier, Bullet, Jolt stop 10⁴ m/s at 1 mm; Havok up to 10³; Box3D up to its cap of 400 m/s"}};
}

}
