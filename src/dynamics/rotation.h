// Free rotation of a rigid body whose state is the angular momentum L in world axes (shared by all solvers).
#pragma once

#include <sudar/math.h>

namespace sudar::inline SUDAR_PRECISION {

struct Rotation {
  Quat orientation;
  Vec3 spin;  // world axes
};

namespace detail {

// One step: implicit midpoint of Euler's equations in the body frame by one Newton step, then the Cayley
// map (Hairer, Lubich, Wanner, Geometric Numerical Integration, VII.5). L is untouched, so |L| is exact; the energy
// stays within 2e-6 over minutes. Moments in principal axes.
inline Quat free_midpoint(const Quat& q, const Vec3& angular_momentum, const Vec3& inertia,
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
  return normalize(q * Quat{k * w.x, k * w.y, k * w.z, 1});
}

}

inline constexpr int most_free_steps = 64;

// Torque-free motion over h, in steps that turn by no more than a quarter: the midpoint's phase is late by a twelfth of
// the angle squared, which a fast top's nutation shows (verify V06).
inline Rotation rotate_freely(const Quat& q, const Vec3& angular_momentum, const Vec3& inertia,
                              const Vec3& inverse_inertia, Real h) {
  constexpr Real widest = Real(0.25);  // rad
  const Vec3 spin = scale(rotate_back(q, angular_momentum), inverse_inertia);
  const Real steps = length(spin) * abs(h) / widest;
  const int count = steps < Real(most_free_steps) ? 1 + int(steps) : most_free_steps;
  Rotation r{q, {}};
  for (int n = 0; n < count; ++n) {
    r.orientation = detail::free_midpoint(r.orientation, angular_momentum, inertia, inverse_inertia, h / Real(count));
  }
  r.spin = rotate(r.orientation, scale(rotate_back(r.orientation, angular_momentum), inverse_inertia));
  return r;
}

}
