// The convex hull of points as a polyhedron with flat polygons for faces.
#pragma once

#include "geometry/polyhedron.h"

namespace sudar::inline SUDAR_PRECISION {

// Every vertex is one of the points, as given. What is flat but for rounding (flatness_tolerance) becomes one face;
// points within a face or an edge are left out; so the result may miss a point by that much. Independent of the points'
// order but for the numbering. Throws Error("points", …) for points that are not finite or have no volume: fewer than
// four, all in one place, on one line or in one plane.
Polyhedron convex_hull(std::span<const Vec3> points);

}
