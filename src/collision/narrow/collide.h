// The one door of the narrow phase: two placed shapes → a manifold, which is the point, segment or polygon of contact
// (thesis (3.30)) by at most four points.
#pragma once

#include "collision/narrow/manifold.h"
#include "geometry/geometry.h"

namespace sudar::inline SUDAR_PRECISION {

// A geometry in a frame that both shapes share (world axes, origin near them).
struct Placed {
  const Geometry* geometry = nullptr;
  Transform pose;
};

// Points of a and b within reach of each other (overlap is negative), at most four. Never two half spaces. Where
// there are none, returns a distance that a and b are apart at least, else 0. No meshes: mesh.h.
Real collide(const Placed& a, const Placed& b, Reach, AxisCache& cache, Manifold& out);

// The distance along the ray at which it enters the geometry, and the surface normal there; both in the geometry's
// frame. A ray that starts inside does not hit.
struct RayOnGeometry {
  Real distance;
  Vec3 normal;
};
bool ray_cast(const Geometry&, const Vec3& from, const Vec3& direction, Real length, RayOnGeometry& out);
// Whether a point, in the geometry's frame, is in it; the inside of a hollow is air, and a mesh has none.
bool contains(const Geometry&, const Vec3& point);

}
