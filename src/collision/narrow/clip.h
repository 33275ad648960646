// The contact region of two convex polyhedra along a known axis: a point, a segment or a polygon.
//
// Where faces meet, the incident face is clipped by the side planes of the reference face (I. Sutherland, G. Hodgman,
// 1974) and each corner of what is left gets its separation along the axis. Three decisions keep the region coherent
// from step to step:
// - Two faces that are both nearly square to the axis (a flat contact) meet as faces even where a pair of edges decided
//   the axis: resting planks are always a little tilted, and then the true axis of least depth is often that of two
//   edges, which would leave a single point. Separations are measured along the axis that decided, so none is deeper
//   than the hulls overlap along it.
// - In a flat contact a's face is always the reference face, whichever decided.
// - Side planes are thick: a corner within a ten-thousandth of the smaller hull's radius of one counts as inside, so
// that
//   equal faces lying on each other keep their own corners. Corners are numbered by what made them: a vertex of a, a
//   vertex of b, or a crossing of two edges.
#pragma once

#include "collision/narrow/sat.h"

namespace sudar::inline SUDAR_PRECISION {

// Points within reach; positions, normal (from b to a) in the frame of the two views.
void contact_region(const HullView& a, const HullView& b, const Axis& axis, Reach reach, Manifold& out);

}
