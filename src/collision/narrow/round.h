// Pairs with a sphere or a capsule, in closed form. A sphere is a capsule of length zero wherever that costs nothing.
//
// A capsule that lies along something touches it in two points, one at each end of the stretch: a single one would let
// it rock. Such a stretch is looked for where the capsule's axis is within 2.9° of the surface. The feature number of a
// point is the end of the (first) capsule that it is nearer to: 0, 1, or 2 for a lone point somewhere between.
#pragma once

#include "collision/narrow/closest.h"
#include "collision/narrow/manifold.h"

namespace sudar::inline SUDAR_PRECISION {

struct Round {
  Segment axis;
  Real radius;
};

// Each writes points nearer than `margin` and the normal from its second argument to its first.
void collide_rounds(const Round& a, const Round& b, Real margin, Manifold& out);
void collide_sphere_hull(const Vec3& center, Real radius, const Polyhedron& hull, Real margin, Manifold& out);
void collide_capsule_hull(const Round& capsule, const Polyhedron& hull, Real margin, Manifold& out);

}
