// Frames and inertia of rigid bodies in double, as files give them: rounded once, where they become a model.
#pragma once

#include <sudar/solids.h>

namespace sudar::inline SUDAR_PRECISION::io {

// Where something is and how it is turned, in something else's frame.
struct Frame {
  Vec3d p{};
  Quatd q{};
  Vec3d point(const Vec3d& local) const { return p + rotate(q, local); }
  Vec3d local(const Vec3d& outer) const { return rotate_back(q, outer - p); }
  friend Frame operator*(const Frame& a, const Frame& b) { return {a.point(b.p), normalize(a.q * b.q)}; }
  friend Frame inverse(const Frame& f) { return {-rotate_back(f.q, f.p), conjugate(f.q)}; }
};

// The shortest turn that takes the z axis to the direction v; about x where v points along −z.
Quatd turn_of_z(const Vec3d& v);
// Files have their cylinders and capsules along z, Sudar along y: the turn of y to z.
Quatd turn_of_y_to_z();
// Files of robots have z up, Sudar y: what turns the one world into the other.
Quatd z_up();

// Mass, centre and inertia about the centre, in the axes of a frame.
struct Inertial {
  double mass = 0;  // kg
  Vec3d center{};   // m
  Mat3d inertia{};  // kg m²
};
Inertial inertial_of(const MassProperties&, double mass);
Inertial moved(const Inertial&, const Frame&);        // from its frame to the one in which that lies
Inertial together(const Inertial&, const Inertial&);  // of both, in the same frame
Mat3d turned(const Mat3d& tensor, const Quatd&);

// No eigenvalue is below `least`, but for rounding.
bool at_least(const Mat3d& symmetric, double least);
// A body has it: no principal moment is greater than the sum of the others.
bool has_body(const Mat3d& inertia);

}
