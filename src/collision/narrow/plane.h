// Pairs with a half space: exact and simple, since the deepest points are ends or vertices.
#pragma once

#include "collision/narrow/round.h"

namespace sudar::inline SUDAR_PRECISION {

// normal · x ≤ offset
struct HalfSpace {
  Vec3 normal;
  Real offset;
};

// The normal written is that of the half space: from it to the other shape.
void collide_round_plane(const Round& a, const HalfSpace& plane, Real margin, Manifold& out);
void collide_hull_plane(const Polyhedron& hull, const HalfSpace& plane, Real radius, Reach, Manifold& out);

}
