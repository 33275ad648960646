// What the scenes of the thesis share: its settings, its floor, its drag. Positions are those of its prototype, whose
// unit of length is about a decimetre to a metre; y is up.
#pragma once

#include <sudar/scenario.h>

namespace sudar::inline SUDAR_PRECISION {

// 100 steps a second, one sub-step, pairs take the larger restitution and the smaller friction.
inline Config thesis_config(int collision_passes = 40, int contact_passes = 80) {
  Config c;
  c.dt = 0.01;
  c.substeps = 1;
  c.friction_mix = Mix::min;
  c.restitution_mix = Mix::max;
  c.impulse_2007.collision_passes = collision_passes;
  c.impulse_2007.contact_passes = contact_passes;
  return c;
}

// A box of density 1, as nearly every body of the thesis.
inline Body add_box(World& w, const Vec3& edges, const Pos& at, const Material& material, const Quat& turn = {}) {
  return w.add({.shape = box(edges), .at = at, .turn = turn, .density = 1, .material = material});
}

// So rough and dead that in a pair the other body decides.
inline constexpr Material ground{.friction_static = 100, .friction_dynamic = 100, .restitution = 0};

// A plane through `at` whose free side is where `turn` takes +y.
inline Body add_plane(World& w, const Pos& at, const Quat& turn = {}, std::string name = "") {
  return w.add({.shape = half_space(),
                .at = at,
                .turn = turn,
                .material = ground,
                .motion = Motion::fixed,
                .name = std::move(name)});
}

// The floor at height y, and gravity.
inline Body add_floor(World& w, double y, Real gravity) {
  w.add(Gravity{{0, -gravity, 0}});
  return add_plane(w, {0, y, 0}, {}, "floor");
}

// The prototype's resistance of air: 0.30 /s, and 0.30 /s · (bounding radius / 10) for rotation.
inline void add_drag(World& w) { w.add(Drag{.linear = Real(0.3), .angular_per_radius = Real(0.03)}); }

// A rotation by degrees about a unit vector, rounded once.
inline Quat turned(const Vec3d& axis, double degrees) {
  const Quatd q = axis_angle(axis, degrees * pi / 180);
  return {Real(q.x), Real(q.y), Real(q.z), Real(q.w)};
}

// How far a body is from a place, in the horizontal plane [m].
inline double horizontal_distance(const Pos& a, const Pos& b) { return sqrt(square(a.x - b.x) + square(a.z - b.z)); }

}
