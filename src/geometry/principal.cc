#include "geometry/principal.h"

#include "math/eigen.h"

namespace sudar::inline SUDAR_PRECISION {

PrincipalFrame principal_frame(const MassProperties& mass) {
  // Vertices rounded to Real make products of inertia of about this size.
  const double rounding = max(1e-9, 8 * double(std::numeric_limits<Real>::epsilon()));
  const Eigen3 eigen = eigen_symmetric(mass.inertia, rounding);
  const Quatd turn = conjugate(quaternion(eigen.vectors));
  const Vec3d origin = -rotate(turn, mass.center);
  return {eigen.values,
          {{Real(origin.x), Real(origin.y), Real(origin.z)}, {Real(turn.x), Real(turn.y), Real(turn.z), Real(turn.w)}}};
}

}
