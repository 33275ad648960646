// At most four points that stand for a whole contact: those that carry it now, or would next.
//
// What a point forbids is that the bodies close its gap in one sub-step and more: a velocity along the normal below
// −gap/h. (What overlaps has no gap left.) Over the plane of contact the velocity that rigid bodies have along the
// normal is an affine function, so that a set of points also guards every other one that lies on or above the lower
// convex hull of their gaps, and which points matter is a question about that hull, whatever the margin is within which
// candidates were collected: a body smaller than the margin has all its vertices among them, and the outermost carry
// nothing.
//
// So the choice goes along the lower hull, as a gift is wrapped (R. Jarvis, 1973): the deepest point; the one that the
// bodies would touch first, or deepest, if they turned about it; and on either side of the edge between these two the
// one that they would touch first or deepest if they turned about the edge. They turn by 2.9° (flat.h), by
// as much as they may until they are looked at again, or as far as the first touch needs: of a round bottom the points a little away count, before those nearest that carry no moment,
// and of corners that lie level the farthest. The flatter of the two facets is what the bodies stand on, or fall on
// next. If it has more than three corners, four are kept that span it: the deepest, the farthest from it, and on either
// side of the line through these two the one that is farthest (the usual choice of game engines, e.g. E. Coumans'
// persistent manifolds); what falls squarely on a side is then not struck on one end of it only.
//
// A flat contact has many points of the same gap and many of the same distance, which rounding would order differently
// in every step; then points come and go, and the solver loses what it knew about them. So each choice has a
// tie-breaker that rounding cannot turn: heights that differ by less than a tie count as equal, among equals the
// farther one wins, a later candidate replaces an earlier one only if it is better by a thousandth, and among the
// deepest a fixed direction decides. The candidates should therefore come in a frame that moves with the shapes.
#pragma once

#include <span>

#include "collision/narrow/manifold.h"

namespace sudar::inline SUDAR_PRECISION {

// Writes points and count of `out`: up to four candidates as they are. `turn`: by
// which the bodies may turn against each other until they are looked at again, rad. `scale` is the smaller body's radius, m:
// candidates within a ten-thousandth of it are one point, and heights within two of these are equal.
void reduce(std::span<const ManifoldPoint> candidates, const Vec3& normal, Real turn, Real scale, Manifold& out);

}
