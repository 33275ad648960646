// A convex polyhedron with the adjacency that separating axes and clipping need.
#pragma once

#include <sudar/shape.h>

#include <cstdint>
#include <vector>

namespace sudar::inline SUDAR_PRECISION {

struct Polyhedron {
  struct Face {
    Vec3 normal;                 // outward, length 1
    Real offset;                 // normal · x = offset on the face
    std::uint32_t first, count;  // its loop in `loops`, counter-clockwise from outside
  };
  struct Edge {                 // each edge once
    std::uint32_t from, to;     // vertices, in the order in which face `left` runs through them
    std::uint32_t left, right;  // the two faces
  };
  std::vector<Vec3> vertices;
  std::vector<Face> faces;           // coplanar triangles are merged into one face
  std::vector<std::uint32_t> loops;  // vertex numbers, face after face
  std::vector<Edge> edges;
  Vec3 interior;  // a point well inside: the centre of mass
};

// Lengths that rounding may have made: what deviates from a plane by no more counts as flat. A vertex computed in
// double and rounded to Real is off by one rounding of the largest coordinate at most; this is 8, and 64 of double.
double flatness_tolerance(std::span<const Vec3> vertices);

// Fills all that follows from `vertices`, `loops` and the faces' `first` and `count`. Throws Error("faces", …) unless
// they are a closed convex surface that obeys Euler's formula. Returns the mass properties.
MassProperties complete(Polyhedron&);

// The polyhedron with these faces, as loops of vertex numbers, counter-clockwise from outside; checked as by
// complete().
Polyhedron make_polyhedron(std::vector<Vec3> vertices, const std::vector<std::vector<std::uint32_t>>& faces);

}
