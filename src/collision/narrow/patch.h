// The part of a convex body that meets another one: a point, a segment, a polygon or a disc; and where two such parts
// lie over each other. A face within 2.9° of square to the contact's normal counts as lying in it, so that what rests a
// little tilted keeps the points that carry it. The lines along the sides of cylinders, cones and capsules may rise as
// they like: their lower ends touch, and their upper ends soon are beyond the margin.
//
// A disc touches in four points of its rim. Tilted ones are numbered from the lowest on, which is then an exact point
// of contact: a coin that wobbles rolls on a circle. Without a tilt to speak of the points keep their places on the
// body, where rounding cannot turn them.
#pragma once

#include "collision/narrow/manifold.h"
#include "collision/narrow/small_array.h"
#include "geometry/convex.h"

namespace sudar::inline SUDAR_PRECISION {

constexpr std::uint32_t lone_point = 20;  // the feature of a point that is no end of anything

struct Patch {
  enum Kind { point, segment, polygon, disc };
  Kind kind = point;
  Vec3d start, end;              // of the segment; in the plane of a polygon: start; the centre of a disc: start
  Vec3d normal;                  // outward, of a polygon or disc
  double radius = 0;             // of a disc
  Vec3d toward, across;          // of a disc: the unit vectors to its first and second rim point
  const Convex* body = nullptr;  // of a polygon
  const Polyhedron::Face* face = nullptr;
  std::uint32_t id[2] = {lone_point, lone_point};  // features of the ends; of a disc's first rim point

  bool flat() const { return kind == polygon || kind == disc; }
  Vec3d rim(int quarter) const;                                      // point 0…3 of a disc
  std::uint32_t feature_at(const Vec3d& place, double thick) const;  // of the end that is there, else lone_point
};

// The part of the body farthest along the unit vector `direction`.
Patch touching_part(const Convex& body, const Vec3d& direction);
// The outward normal of the face that lies within 2.9° of square to `direction`; 0 if there is none.
Vec3d face_across(const Convex& body, const Vec3d& direction);

struct Overlay {
  Vec3d normal;   // from b to a, of length 1
  double thick;   // distances that count as none
  double share;   // where the points go: 1 on a's surface, 0 on b's
  double margin;  // only points nearer than this
};
// Enough room for the points of two patches.
std::size_t most_points(const Patch& a, const Patch& b);
// Appends the corners of what the two have in common as seen along the normal. None where either is a point.
void overlay(const Patch& a, const Patch& b, const Overlay& how, SmallArray<ManifoldPoint, 64>& out);

}
