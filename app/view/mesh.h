// The triangles of a shape, with what the shaders need to draw it well:
// - hulls are shaded flat, but each triangle knows how far it is from its face's edge and where the surface bends to
//   there, so that the shader can round the edges off and let them catch the light;
// - every face (every sector of a sphere) has one of two tones, so that a turning body is seen to turn.
// Neighbouring faces differ in tone where that is possible, and opposite ones always do.
#pragma once

#include <sudar/shape.h>

#include "view/linear.h"

namespace sudar::view {

struct MeshVertex {
  Vec3f position;
  Vec3f normal;
  Vec3f edge_normal;  // of the rounded edge that this triangle leads to
  float edge = 0;     // distance from that edge in units of the rounding's width: 0 on the edge, ≥ 1 on the flat
  float tone = 0;     // 0 or 1
};

struct Mesh {
  std::vector<MeshVertex> vertices;
  std::vector<std::uint32_t> indices;  // three for each triangle, counter-clockwise from outside
  bool lines = false;                  // two for each line instead
};

Mesh hull_mesh(const Shape&);
Mesh plain_hull_mesh(const Shape&);  // with sharp edges and half as many triangles
Mesh sphere_mesh(int fineness);      // radius 1; 1…6: a sector has so many slices
// A capsule, cylinder, cone or ellipsoid; a hollow, which is drawn from inside only, so that one can look into it.
Mesh smooth_mesh(const Shape&, int fineness);  // 3…6
Mesh stick_mesh();                             // for marks: a cylinder of radius 1 from y = 0 to 1
Mesh cube_outline();                           // its twelve edges as lines, 0…1
Mesh cone_mesh();                              // for marks: radius 1 at y = 0, its tip at y = 1

}
