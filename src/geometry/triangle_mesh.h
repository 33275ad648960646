// Surfaces of triangles, each seen from the side from which its corners run counter-clockwise, for bodies that do not
// fall: walls, terrain, tracks. Behind its surface a mesh is nothing.
//
// A triangle collides as a convex body, the prism under it (`piece`): so a mesh meets every convex kind with what is
// there already. What would be felt of the prism but is not of the surface is filtered by normals (collision/narrow/
// mesh.h): at each edge a triangle knows how far a contact's normal may lean over it. Where the neighbour is in the same
// plane or rises, not at all; where it falls away, as far as the neighbour's normal; at a border, a quarter turn. That
// is the Gauss map of the surface, cut at its edges (Voronoi regions, as of C. Ericson, Real-Time Collision Detection,
// 2004, 5.1), and the reason why nothing that slides feels an inner edge.
#pragma once

#include <array>

#include "geometry/geometry.h"

namespace sudar::inline SUDAR_PRECISION {

struct TriangleMesh {
  struct Triangle {
    std::shared_ptr<const Geometry> piece;  // a hull; its face 0 is the triangle
    std::array<Vec3, 3> corners;
    Vec3 normal;
    std::array<Vec3, 3> across;  // unit vectors in the plane, out over the edge from corner i to the next
    std::array<Real, 3> lean;    // cosine of how far a contact's normal may lean over it

    // Whether a contact with this triangle may have the unit vector n, out of the surface, for its normal.
    bool allows(const Vec3& n) const;
    bool above(const Vec3& point, Real tolerance) const;  // whether the foot of the point is in the triangle
    Real size() const { return length(corners[1] - corners[0]) + length(corners[2] - corners[0]); }
  };
  std::vector<Triangle> triangles;
  Vec3 low, high;  // of all vertices

  // visit(triangle) for those whose boxes meet the box. In no particular order.
  template <class Visit>
  void search(const Vec3& from, const Vec3& to, Visit visit) const {
    walk([&](const Node& n) { return !(overlap(n, from, to)); }, visit);
  }
  // The first triangle that the ray enters from the front within `length`.
  bool ray_cast(const Vec3& from, const Vec3& direction, Real length, std::uint32_t& triangle, Real& distance) const;

  // A binary tree in the order of a walk: the first child follows its parent. Leaves hold triangles order[first…].
  struct Node {
    Vec3 low, high;
    std::uint32_t first = 0, count = 0;  // of a leaf
    std::uint32_t after = 0;             // where the walk goes on that leaves this node out
  };
  std::vector<Node> nodes;
  std::vector<std::uint32_t> order;

 private:
  static bool overlap(const Node& n, const Vec3& from, const Vec3& to) {
    return n.low.x <= to.x && from.x <= n.high.x && n.low.y <= to.y && from.y <= n.high.y && n.low.z <= to.z &&
           from.z <= n.high.z;
  }
  template <class Skip, class Visit>
  void walk(Skip skip, Visit visit) const {
    for (std::uint32_t k = 0; k < nodes.size();) {
      const Node& n = nodes[k];
      if (skip(n)) {
        k = n.after;
        continue;
      }
      for (std::uint32_t i = n.first; i < n.first + n.count; ++i) visit(order[i]);
      ++k;
    }
  }
};

// Throws Error naming the vertex or triangle: "vertices[3]" that is not finite, "triangles[5]" that names a vertex that
// is not there, has no area, or runs along an edge in the same sense as another one, so that one of the two is inverted
// or there twice. Vertices in one place are one vertex.
std::shared_ptr<const TriangleMesh> make_triangle_mesh(std::span<const Vec3> vertices,
                                                       std::span<const std::uint32_t> triangles);

}
