// Questions about points that get the right answer whatever the rounding: what combinatorial algorithms rest on.
#pragma once

#include <sudar/math.h>

namespace sudar::inline SUDAR_PRECISION {

// 1, −1 or 0: d lies on the side of the plane a, b, c from which they run counter-clockwise, on the other side, or in
// the plane. Exact as long as no product of three coordinate differences over- or underflows.
int orientation(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d);

}
