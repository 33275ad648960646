// Surfaces of triangles as files have them, and what becomes of them: solids, hulls, obstacles.
#pragma once

#include <sudar/shape.h>

#include <optional>
#include <string>

namespace sudar::inline SUDAR_PRECISION::io {

struct Surface {
  std::vector<Vec3d> vertices;           // m
  std::vector<std::uint32_t> triangles;  // three vertices each, counter-clockwise seen from outside

  void add(const Surface&);
};

// A surface that can be worked with: vertices in one place are one, triangles without area are gone, and so are those
// that run along an edge in the sense of an earlier one, being there twice or inverted.
struct Cleaned {
  Surface surface;
  std::size_t flat = 0, doubled = 0;    // triangles that are gone
  std::optional<MassProperties> solid;  // of what it encloses; none: it is open
  bool inside_out = false;              // it was closed, and is turned
};
Cleaned cleaned(const Surface&);

// All vertices' hull. Throws Error where they lie in a plane.
Shape hull_of(const Surface&);
// An obstacle.
Shape mesh_of(const Surface&);

// "2 triangles without area and 1 that is there twice are left out"; empty where there are none.
std::string what_is_gone(const Cleaned&);
// By how much the hull's volume is greater than the solid's: "is 12 % larger"; empty where it is not.
std::string excess_of_hull(const Shape& hull, const MassProperties& solid);

}
