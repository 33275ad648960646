// The distance of two convex bodies by their support functions (E. Gilbert, D. Johnson, S. Keerthi 1988; G. van den
// Bergen 2004): walks over simplices of the Minkowski difference a − b towards its point nearest to the origin.
//
// In double whatever Real is, and nearly to the last digits: the error of the direction is the square root of that of the
// distance, and a normal that is off by 1e-4 bends the path of what rolls.
#pragma once

#include "geometry/convex.h"

namespace sudar::inline SUDAR_PRECISION {

// a and a shifted b
struct Gap {
  bool apart = false;   // else they overlap, or are nearer than the precision can tell
  double distance = 0;  // of the cores; with `beyond`, perhaps only a lower bound greater than that
  Vec3d normal;         // from b to a, of length 1
  Vec3d on_a, on_b;     // the nearest points
};

// Begins with `start` as a guess of the way from b to a, and gives up where the distance is certainly greater than
// `beyond`.
Gap gap(const Convex& a, const Convex& b, const Vec3d& shift_of_b, const Vec3d& start, double beyond);

}
