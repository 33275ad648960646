// At most four points that stand for a whole contact: those that carry it now, or would next.
//
// What a point forbids is that the bodies close its gap in one sub-step and more: a velocity along the normal below
// −gap/h. (What overlaps has no gap left.) Over the plane of contact the velocity that rigid bodies have along the normal
// is an affine function, so that a set of points also guards every other one that lies on or above the lower convex hull
// of their gaps, and which points matter is a question about that hull, whatever the margin is within which candidates
// were collected: a body smaller than the margin has all its vertices among them, and the outermost carry nothing.
//
// So the choice wraps the lower hull (R. Jarvis' gift wrapping, 1973): the deepest point; the one to which the
// line rises least; on either side of this edge the one to which the plane rises least. The flatter of these two facets
// is what the bodies stand on, or fall on next. Of a facet with more than three corners four are kept that span it: the
// deepest, the farthest from it, and on either side of the line through these two the one that is farthest (the usual
// choice of game engines, e.g. E. Coumans' persistent manifolds). A triangle leaves room for the point of the other
// facet.
//
// A flat contact has many points of the same gap and many of the same distance, which rounding would order differently
// in every step; then points come and go, and the solver loses what it knew about them. So each choice has a tie-breaker
// that rounding cannot turn: heights that differ by less than a tie count as equal, among equals the farther one wins, a
// later candidate replaces an earlier one only if it is better by a thousandth, and among the deepest a fixed direction
// decides. The candidates should therefore come in a frame that moves with the shapes.
#pragma once

#include <span>

#include "collision/narrow/manifold.h"

namespace sudar::inline SUDAR_PRECISION {

// Writes points and count of `out`. `scale` is the smaller body's radius, m: candidates whose distance along the surface
// is within a ten-thousandth of it are one point, and heights within two of these are equal.
void reduce(std::span<const ManifoldPoint> candidates, const Vec3& normal, Real scale, Manifold& out);

}
