// The part of a convex body that meets another one: a point, a segment, a polygon or a disc. A face within 2.9° of
// square to the contact's normal counts as lying in it, so that what rests a little tilted keeps the points that carry
// it. The lines along the sides of cylinders, cones and capsules may rise as they like: their lower ends touch, and
// their upper ends soon are beyond the margin.
//
// A disc touches in four points of its rim. Tilted ones are numbered from the lowest on, which is then an exact point
// of contact: a coin that wobbles rolls on a circle. Without a tilt to speak of the points keep their places on the
// body, where rounding cannot turn them.
#pragma once

#include "geometry/convex.h"

namespace sudar::inline SUDAR_PRECISION {

// The numbers by which a manifold's points are known again in the next step.
namespace feature {
constexpr std::uint32_t cap_rim[2] = {0, 8};  // of the lower and the upper cap: four points that keep their places …
constexpr std::uint32_t tilted = 4;           // … and, so much on, four from the lowest on
constexpr std::uint32_t apex = 16, lone = 20, capsule_end = 24, hull_vertex = 32;
constexpr std::uint32_t of_other = 64;        // of two discs: added for the second
constexpr std::uint32_t crossing = 1u << 30;  // of two edges, or an edge and a circle
}

struct Patch {
  enum Kind { point, segment, polygon, disc };
  Kind kind = point;
  Vec3d start, end;              // of the segment; in the plane of a polygon: start; the centre of a disc: start
  Vec3d normal;                  // outward, of a polygon or disc
  double radius = 0;             // of a disc
  Vec3d toward, across;          // of a disc: the unit vectors to its first and second rim point
  const Convex* body = nullptr;  // of a polygon
  const Polyhedron::Face* face = nullptr;
  std::uint32_t id[2] = {feature::lone, feature::lone};  // features of the ends; of a disc's first rim point

  bool flat() const { return kind == polygon || kind == disc; }
  Vec3d rim(int quarter) const;                                      // point 0…3 of a disc
  std::uint32_t feature_at(const Vec3d& place, double thick) const;  // of the end that is there, else feature::lone
};

// The part of the body farthest along the unit vector `direction`.
Patch touching_part(const Convex& body, const Vec3d& direction);
// The outward normal of the face that lies within 2.9° of square to `direction`; 0 if there is none.
Vec3d face_across(const Convex& body, const Vec3d& direction);

}
