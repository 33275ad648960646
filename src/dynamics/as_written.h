// Option friction_per_increment: thesis (3.16) … (3.18) nearly as written, each increment against its own cone. It
// serves to show what goes wrong: a train moves that static friction should hold.
#pragma once

#include "dynamics/contact_visit.h"

namespace sudar::inline SUDAR_PRECISION {

// One visit of point k; returns the normal impulse, N s.
inline Real increment_as_written(SolverBodies& on, const ManifoldRow& m, const ManifoldStart& start, std::size_t k,
                                 Real restitution) {
  const PointRow& p = m.points[k];
  const SolverBody &on_a = on[m.a], &on_b = on[m.b];
  const Vec3 u = vector(relative_velocity(motion_of(m, on_a.real, on_b.real), p));
  if (u.x >= start.points[k].free_speed) return 0;
  const Mat3 response = response_matrix(m, p);
  Vec3 impulse = inverse(response) * (Vec3{-restitution * u.x, 0, 0} - u);  // thesis (3.16)
  if (impulse.x < 0 || slide(impulse) > start.friction_static * impulse.x) {
    const Real fast = slide(u);
    const Real share = fast > 0 ? start.friction_dynamic / fast : Real(0);
    const Vec3 direction{1, -share * u.y, -share * u.z};
    const Real denominator = dot(response.c0, direction);
    if (denominator <= 0) return 0;                                  // jamming
    impulse = direction * (-(1 + restitution) * u.x / denominator);  // thesis (3.17), (3.18)
  }
  Moving a = on_a.real, b = on_b.real;
  apply(a, b, on_a, on_b, m, to_middle(p, impulse));
  put(on, m, a, b);
  return impulse.x;
}

}
