// A placed convex body by its support function, in double: what the distance of two bodies needs to know of them.
#pragma once

#include "geometry/geometry.h"

namespace sudar::inline SUDAR_PRECISION {

// The points within `round` of the core: the centre of a sphere, the segment of a capsule, else the shape itself.
struct Convex {
  const Geometry* geometry;
  Mat3d turn;  // of the shape's frame in the common one
  Vec3d at;
  double round;

  Convex(const Geometry&, const Mat3d& turn, const Vec3d& at);
  Convex(const Geometry&, const Quat& turn, const Vec3d& at);
  Convex(const Geometry& g, const Transform& pose) : Convex(g, pose.q, convert<double>(pose.p)) {}
  bool thin() const { return round > 0 || geometry->kind == ShapeKind::sphere; }  // the core is a point or a segment
  Vec3d axis() const { return turn.c1; }
  Vec3d point(const Vec3d& local) const { return at + turn * local; }
  // A point of the core farthest along `direction`, which may have any length.
  Vec3d support(const Vec3d& direction) const;
  Vec3d center() const;  // inside the core
  double radius() const { return double(geometry->bounding_radius); }
};

}
