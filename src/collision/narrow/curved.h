// Pairs with a cylinder, a cone or an ellipsoid, and spheres inside hollows.
//
// The axis is the exact direction of the distance or depth (separation.h), or the normal of a face that is as good but
// for rounding (the tolerance of sat.h), so that what lies flat has one normal in every step. The points are where the
// parts that meet lie over each other (patch.h), or the nearest points where nothing lies on anything.
#pragma once

#include "collision/narrow/collide.h"
#include "geometry/convex.h"

namespace sudar::inline SUDAR_PRECISION {

// Each writes points within reach and the normal from its second argument to its first.
// Either convex, one of them curved.
void collide_curved(const Placed& a, const Placed& b, Reach, Manifold& out);
void collide_curved_plane(const Placed& a, const Placed& plane, Reach, Manifold& out);
void collide_sphere_hollow(const Placed& sphere, const Placed& hollow, Real margin, Manifold& out);

}
