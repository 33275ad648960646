// What a Shape shares: immutable once made. World stores each once by its content hash.
#pragma once

#include <sudar/shape.h>

#include "geometry/polyhedron.h"

namespace sudar::inline SUDAR_PRECISION {

struct TriangleMesh;  // triangle_mesh.h

struct Geometry {
  ShapeKind kind = ShapeKind::sphere;
  Real radius = 0;           // sphere, capsule, cylinder, cone, hollows
  Real half_length = 0;      // capsule, cylinder, cone, hollow cylinder: the base of a cone is at −half_length/2
  Vec3 radii;                // ellipsoid
  Polyhedron hull;           // hull; of a mesh its vertices and faces, each a triangle
  std::shared_ptr<const TriangleMesh> mesh;
  MassProperties mass;       // per unit density, in the shape's frame
  Real bounding_radius = 0;  // about the origin
  std::uint64_t hash = 0;    // of kind, sizes, vertices and loops: equal content, equal hash
};

// The one way to a Geometry, for generators and for loading: from its plain data (kind, sizes, the hull's
// vertices and loops) fills the rest. Throws Error naming the field if the data is no body.
std::shared_ptr<const Geometry> make_geometry(Geometry&& plain);

// Of a ball about the centre of mass of the geometry, wholly inside; 0 where it has none. Not for what is hollow.
Real inner_radius(const Geometry&);
// How far a point of the surface moves at most, per radian, when the geometry turns about its origin: of a ball not at all.
Real swing_radius(const Geometry&);

// The smallest box around the geometry at `pose`, widened by `margin`. Infinite for a half space.
Box bounds(const Geometry&, const Pose& pose, Real margin);

}
