// Where the touching parts of two bodies lie over each other: the corners of what they have in common.
#pragma once

#include "collision/narrow/manifold.h"
#include "collision/narrow/patch.h"
#include "collision/narrow/small_array.h"

namespace sudar::inline SUDAR_PRECISION {

struct Overlay {
  Vec3d normal;   // from b to a, of length 1
  double thick;   // distances that count as none
  double share;   // where the points go: 1 on a's surface, 0 on b's
  double margin;  // only points nearer than this
};
// Enough room for the points of two patches.
std::size_t most_points(const Patch& a, const Patch& b);
// Appends the corners of what the two have in common as seen along the normal. None where either is a point.
void overlay(const Patch& a, const Patch& b, const Overlay& how, SmallArray<ManifoldPoint, 64>& out);

}
