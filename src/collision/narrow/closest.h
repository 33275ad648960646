// Closest points of segments, and of a point to a polyhedron.
#pragma once

#include "geometry/polyhedron.h"

namespace sudar::inline SUDAR_PRECISION {

// start + t·along, t = 0…1; a point if `along` is zero.
struct Segment {
  Vec3 start, along;
  Vec3 at(Real t) const { return start + along * t; }
};

struct SegmentPoints {
  Real s, t;  // along a, along b
  Vec3 on_a, on_b;
};

Real closest(const Segment& a, const Vec3& point);  // the parameter
SegmentPoints closest(const Segment& a, const Segment& b);

// A stretch of a segment.
template <class T>
struct Interval {
  T low = 0, high = 1;
  // Cuts off where base + slope·t > 0.
  void clip(T base, T slope) {
    if (slope > 0) high = min(high, -base / slope);
    if (slope < 0) low = max(low, -base / slope);
    if (slope == 0 && base > 0) high = -1;
  }
  bool empty() const { return !(low < high); }
};

// How far a point is from a convex polyhedron; negative inside, then to the nearest face.
struct HullDistance {
  Real distance;
  Vec3 normal;  // of length 1, towards the point
};
// Nothing beyond `reach` is looked for: then `distance` is infinite.
HullDistance distance(const Polyhedron& hull, const Vec3& point, Real reach);

}
