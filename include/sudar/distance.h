// How far apart two placed shapes are, whether or not they are in a world. Exact but for rounding: computed in double
// whatever Real is, good to about 1e-7 of the sizes in a float build (the digits of a pose's orientation).
#pragma once

#include <sudar/shape.h>

namespace sudar::inline SUDAR_PRECISION {

struct SignedDistance {
  double value = 0;  // m; negative where they overlap: the shortest way that one must be moved to part them
  Vec3 normal;       // of length 1, from b to a, along which they part soonest
  Pos on_a, on_b;    // the nearest points of the surfaces; where they overlap, the two ends of that shortest way
};

// Every shape but hollows, which are refused, as are two half spaces: Error("a" or "b", …).
SignedDistance distance(const Shape& a, const Pose& at_a, const Shape& b, const Pose& at_b);
// To a point, which is b. Negative inside.
SignedDistance distance(const Shape& a, const Pose& at_a, const Pos& point);

}
