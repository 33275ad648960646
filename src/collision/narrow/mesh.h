// A triangle of a mesh (geometry/triangle_mesh.h) against a convex body.
#pragma once

#include "collision/narrow/collide.h"
#include "geometry/triangle_mesh.h"

namespace sudar::inline SUDAR_PRECISION {

// As collide(): points within reach, at most four, and the normal from b to a, which is the mesh. Only bodies whose
// centre is in front of the triangle meet it. Contacts that are the neighbours' business are none: those whose normal leans
// over an edge farther than the surface turns there. What then lies deeper in the plane than beside it still meets the plane.
Real collide_triangle(const Placed& mesh, std::uint32_t triangle, const Placed& b, Reach, AxisCache& cache,
                      Manifold& out);

}
