#include "geometry/principal.h"

#include "math/eigen.h"

namespace sudar::inline SUDAR_PRECISION {

PrincipalFrame principal_frame(const MassProperties& mass) {
  // Vertices rounded to Real make products of inertia of about this size.
  const double rounding = max(1e-9, 8 * double(std::numeric_limits<Real>::epsilon()));
  const Eigen3 eigen = eigen_symmetric(mass.inertia, rounding);
  const Quatd turn = conjugate(quaternion(eigen.vectors));
  return {eigen.values, {convert<Real>(-rotate(turn, mass.center)), convert<Real>(turn)}};
}

}
