// Two convex polyhedra are apart if and only if some face normal of either, or some cross product of an edge of one
// with an edge of the other, separates them (thesis (3.29), fig. 4; S. Gottschalk 1996 for boxes). The axis of the largest
// separation is that of the contact.
//
// What makes it fast and quiet:
// - Everything happens in the frame of hull a; hull b is brought there once (HullView).
// - An edge pair matters only if the arcs of the two edges on the Gauss map cross, that is if the two edges make a face
//   of the Minkowski difference (D. Gregorius, GDC 2013). Then the two edges are the supports and no vertex is visited.
// - A bound skips most axes: along a normal of a face, or of an edge on its arc, that face or edge is the part of its
//   hull farthest out, and the other hull reaches back from its centre by at least the radius of a ball inside it. An
//   axis that cannot beat the best one found so far is not looked at. The cached axis is measured first, and gives that
//   bound its start.
// - Nearly equal axes must not take turns, or the contact points would change in every step: a face of a is preferred
// to
//   a face of b, and a face to a pair of edges, unless the other is better by `tolerance`: 1e-4 of the depth, so that
//   it cannot be swamped by rounding of deep contacts, and 2e-5 of the smaller hull's radius, so that it still works at
//   depth 0. That is about a hundred times the rounding error, and too little to make a contact visibly deeper.
//
// The cache changes no result: a cached axis that separates by more than the margin is one that the full search would
// have found too (its number is computed by the same function), and a bound skips only axes that lose by more than all
// tolerances.
#pragma once

#include <span>

#include "collision/narrow/manifold.h"
#include "collision/narrow/small_array.h"
#include "geometry/polyhedron.h"

namespace sudar::inline SUDAR_PRECISION {

// A polyhedron in the frame of the computation. Topology is the shape's own.
struct HullView {
  std::span<const Vec3> vertices;
  std::span<const Polyhedron::Face> faces;
  const Polyhedron* shape;
  Vec3 center;        // inside
  Real inner_radius;  // of a ball about it inside the hull
  Real radius;        // of a ball about it around the hull

  explicit HullView(const Polyhedron& hull);
  Vec3 vertex(std::uint32_t face, std::uint32_t corner) const {
    return vertices[shape->loops[faces[face].first + corner]];
  }
  Vec3 along(const Polyhedron::Edge& e) const { return vertices[e.to] - vertices[e.from]; }

 protected:
  HullView() = default;
  void measure();
};

// The same, moved into another frame.
class MovedHull : public HullView {
 public:
  MovedHull(const Polyhedron& hull, const Mat3& turn, const Vec3& shift);

 private:
  SmallArray<Vec3, 64> moved_vertices_;
  SmallArray<Polyhedron::Face, 64> moved_faces_;
};

struct Axis {
  enum Kind : std::uint32_t { none, face_a, face_b, edges };
  Kind kind = none;
  std::uint32_t a = 0, b = 0;  // the face, or the two edges
  Real separation = 0;
  Vec3 normal;  // of length 1, from a to b
};

// The vertex farthest along `direction`.
std::uint32_t support(std::span<const Vec3> vertices, const Vec3& direction);

// The axis of the largest separation, or none if some axis separates the hulls by more than `margin`; its `separation` is
// then by how much at least.
Axis find_axis(const HullView& a, const HullView& b, Real margin, AxisCache& cache);

}
