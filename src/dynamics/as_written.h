// Option friction_per_increment: thesis (3.16) … (3.18) nearly as written, each increment against its own cone. It
// serves to show what goes wrong: a train moves that static friction should hold.
#pragma once

#include "dynamics/contact_visit.h"

namespace sudar::inline SUDAR_PRECISION {

// One visit of a point; returns the normal impulse, N s.
inline Real increment_as_written(SolverBodies& on, const ManifoldRow& m, const PointRow& p, Real restitution) {
  Moving a = on[m.a].real, b = on[m.b].real;
  const Vec3 u = vector(relative_velocity(a, b, m, p));
  if (u.x >= p.free_speed) return 0;
  const Mat3 k = matrix(m.to_frame) * (matrix(m.mass_a) + matrix(m.mass_b)) + matrix(p.arm_a) * matrix(p.turn_a) +
                 matrix(p.arm_b) * matrix(p.turn_b);
  Vec3 impulse = inverse(k) * (Vec3{-restitution * u.x, 0, 0} - u);  // thesis (3.16)
  if (impulse.x < 0 || slide(impulse) > m.material.friction_static * impulse.x) {
    const Real fast = slide(u);
    const Real share = fast > 0 ? m.material.friction_dynamic / fast : Real(0);
    const Vec3 direction{1, -share * u.y, -share * u.z};
    const Real denominator = dot(k.c0, direction);
    if (denominator <= 0) return 0;                                  // jamming
    impulse = direction * (-(1 + restitution) * u.x / denominator);  // thesis (3.17), (3.18)
  }
  apply(a, b, m, p, impulse);
  put(on, m, a, b);
  return impulse.x;
}

}
