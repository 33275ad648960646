#include "io/rigid.h"

namespace sudar::inline SUDAR_PRECISION::io {

Quatd turn_of_z(const Vec3d& v) {
  const Vec3d across{-v.y, v.x, 0};  // z × v
  const double sine = length(across);
  if (sine < 1e-10 * length(v)) return v.z < 0 ? Quatd{1, 0, 0, 0} : Quatd{};
  return axis_angle(across / sine, atan2(sine, v.z));
}

Quatd turn_of_y_to_z() { return {sqrt(0.5), 0, 0, sqrt(0.5)}; }
Quatd z_up() { return {-sqrt(0.5), 0, 0, sqrt(0.5)}; }

Mat3d turned(const Mat3d& tensor, const Quatd& q) {
  const Mat3d r = matrix(q);
  return r * tensor * transpose(r);
}

Inertial inertial_of(const MassProperties& unit, double mass) {
  return {mass, unit.center, unit.inertia * (mass / unit.volume)};
}

Inertial moved(const Inertial& i, const Frame& f) { return {i.mass, f.point(i.center), turned(i.inertia, f.q)}; }

Inertial together(const Inertial& a, const Inertial& b) {
  const double mass = a.mass + b.mass;
  if (!(mass > 0)) return a;
  const Vec3d apart = b.center - a.center;
  const double reduced = a.mass * b.mass / mass;  // parallel axes, of both at once
  const Mat3d steiner = (Mat3d::identity() * dot(apart, apart) - Mat3d::outer(apart, apart)) * reduced;
  return {mass, a.center + apart * (b.mass / mass), a.inertia + b.inertia + steiner};
}

bool at_least(const Mat3d& m, double least) {
  const double scale = abs(trace(m)), rounding = 1e-12 * scale;
  const Mat3d s = m - Mat3d::identity() * (least - rounding);
  // All principal minors, for a matrix that may be singular.
  const auto minor = [&](int i, int k) { return s[i][i] * s[k][k] - s[i][k] * s[k][i] >= -rounding * scale; };
  return s.c0.x >= 0 && s.c1.y >= 0 && s.c2.z >= 0 && minor(0, 1) && minor(1, 2) && minor(0, 2) &&
         determinant(s) >= -rounding * scale * scale;
}

bool has_body(const Mat3d& inertia) {  // its second moments, ∫ r rᵀ dm, are not negative
  const Mat3d second = Mat3d::identity() * (0.5 * trace(inertia)) - inertia;
  return at_least(second, -1e-4 * trace(inertia));
}

}
