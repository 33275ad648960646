// What many cases are built from.
#pragma once

#include "verify/case.h"

namespace sudar::verify {

inline constexpr double standard_gravity = 9.81;  // m/s², of all cases

inline Material material(double friction, double restitution = 0) {
  return {.friction_static = Real(friction), .friction_dynamic = Real(friction), .restitution = Real(restitution)};
}

// Everything below y = 0, or below a plane through `at` whose normal is y turned by `turn`.
inline Body add_ground(World& w, const Material& m, const Pos& at = {}, const Quat& turn = {}) {
  return w.add({.shape = half_space(), .at = at, .turn = turn, .material = m, .motion = Motion::fixed});
}

inline void add_gravity(const Run& run, World& w, double g = standard_gravity) {
  w.add(Gravity{{0, Real(-run.with("gravity", g)), 0}});
}

// Structures whose equilibrium allows less play than the default overlap of 10 mm.
inline Config with_small_slop(Config c) {
  c.impulse_2007.slop = Real(0.0005);
  return c;
}

// A picture of what only has a shape.
inline void show(Run& run, const std::vector<BodyDef>& bodies) {
  World w;
  for (const BodyDef& def : bodies) w.add(def);
  run.draw(w);
}

// The tolerance in single or in double precision.
inline constexpr double by_precision(double single, double twice) { return sizeof(Real) == 4 ? single : twice; }

// A thin rod of the length along x, centred, with a rod's inertia; about its own axis it has next to none.
inline BodyDef thin_rod(double length, double mass, double thickness = 0.01) {
  const Real across = Real(mass * length * length / 12);
  return {.shape = box({Real(length), Real(thickness), Real(thickness)}),
          .mass = Real(mass),
          .inertia = Mat3::diagonal({across / 1000, across, across})};
}

// A body of unit mass whose moment of inertia is k m R²: ²⁄₅ solid, ½ as a cylinder, ⅔ a shell, 1 a hoop.
inline BodyDef round_body(double radius, double k, const Material& m) {
  const Real moment = Real(k * radius * radius);
  return {.shape = sphere(Real(radius)), .mass = 1, .inertia = Mat3::diagonal({moment, moment, moment}), .material = m};
}

}
