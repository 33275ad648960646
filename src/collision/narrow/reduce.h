// At most four points that stand for a whole contact polygon: the deepest, the farthest from it, and on either side of
// the line through these two the one that spans the largest area. (The usual choice of game engines, e.g. E. Coumans'
// persistent manifolds.)
//
// A flat contact has many points of the same depth and many of the same area, which rounding would order differently in
// every step; then points come and go, and the solver loses what it knew about them. So each choice has a tie-breaker
// that rounding cannot turn: depths within `tie` of the deepest count as equal and a fixed direction decides between
// them, and a later candidate replaces an earlier one only if it is better by a thousandth. The candidates should
// therefore come in a frame that moves with the shapes.
#pragma once

#include <span>

#include "collision/narrow/manifold.h"

namespace sudar::inline SUDAR_PRECISION {

// Writes points and count of `out`. Candidates nearer to each other than `merge` are one point.
void reduce(std::span<const ManifoldPoint> candidates, const Vec3& normal, Real tie, Real merge, Manifold& out);

}
