// The signed distance of two convex bodies: positive if they are apart, else minus the depth, which is the length of
// the shortest way out. Exact but for rounding, also for smooth bodies. How:
// - Points and segments: in closed form. Cores that are apart: gap(). Less the roundings.
// - Cores that overlap: the shortest way out is the point of the Minkowski difference's surface nearest to the origin.
//   A polytope inside the difference is grown, always at its face nearest to the origin (S. Cameron 1997; G. van den
//   Bergen 2001), until its nearest face and the best support plane seen bracket the depth to `bracket` of it. On
//   smooth bodies the last digits would take very many faces. Therefore the direction is then polished: the bodies are
//   moved apart along it by a little more than the depth, and the direction of the gap that opens is the next one.
//   Where the difference has the radius of curvature R this shrinks the direction's error by (depth + gap)/(R + gap)
//   each time.
#pragma once

#include "geometry/convex.h"

namespace sudar::inline SUDAR_PRECISION {

struct Separation {
  double distance;   // greater than `reach`: only a lower bound, and the points are not the nearest ones
  Vec3d normal;      // from b to a, of length 1
  Vec3d on_a, on_b;  // the nearest or the deepest points: on_a − on_b = distance · normal, but for rounding
};

Separation separation(const Convex& a, const Convex& b, double reach);

// How far a and b are apart along `normal` (of length 1, from b to a), negative where they overlap.
double separation_along(const Convex& a, const Convex& b, const Vec3d& normal);

}
