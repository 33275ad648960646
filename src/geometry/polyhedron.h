// A convex polyhedron with the adjacency that separating axes and clipping need.
#pragma once

#include <sudar/math.h>

#include <cstdint>
#include <vector>

namespace sudar::inline SUDAR_PRECISION {

struct Polyhedron {
  struct Face {
    Vec3 normal;                    // outward, length 1
    Real offset;                    // normal · x = offset on the face
    std::uint32_t first, count;     // its loop in `loops`, counter-clockwise from outside
  };
  struct Edge {                     // each edge once
    std::uint32_t from, to;         // vertices, in the order in which face `left` runs through them
    std::uint32_t left, right;      // the two faces
  };
  std::vector<Vec3> vertices;
  std::vector<Face> faces;          // coplanar triangles are merged into one face
  std::vector<std::uint32_t> loops; // vertex numbers, face after face
  std::vector<Edge> edges;
  Vec3 interior;                    // a point well inside
};

}
