// Shapes: cheap values that share immutable geometry. A shape lives in its own frame; a body places it.
// Lengths in metres. A generator refuses bad input with an Error that names the argument.
#pragma once

#include <sudar/math.h>

#include <memory>
#include <span>
#include <vector>

namespace sudar::inline SUDAR_PRECISION {

struct Geometry;  // src/geometry/geometry.h

// Snapshots hold these numbers.
enum class ShapeKind : std::uint8_t {
  sphere, capsule, half_space, hull, cylinder, cone, ellipsoid, hollow_sphere, hollow_cylinder, mesh
};

// Half spaces and hollows have no mass: for fixed bodies only. Neither have meshes: for fixed and kinematic ones.
constexpr bool has_mass(ShapeKind k) { return k != ShapeKind::half_space && k < ShapeKind::hollow_sphere; }
// What a hollow has inside is felt by spheres only.
constexpr bool is_hollow(ShapeKind k) { return k == ShapeKind::hollow_sphere || k == ShapeKind::hollow_cylinder; }

// Volume [m³], centre of mass and the inertia tensor about it per unit density [m⁵], in the shape's frame.
struct MassProperties {
  double volume = 0;
  Vec3d center;
  Mat3d inertia;
};

class Shape {
 public:
  Shape() = default;  // no shape: refused wherever a shape is needed
  explicit Shape(std::shared_ptr<const Geometry> geometry) : geometry_(std::move(geometry)) {}

  explicit operator bool() const { return geometry_ != nullptr; }
  bool operator==(const Shape& other) const;  // by content
  ShapeKind kind() const;
  Real radius() const;       // 0 of a half space, a hull, an ellipsoid
  Real half_length() const;  // along y: half of a capsule's segment, half the height of a cylinder or cone; else 0
  Vec3 radii() const;        // of an ellipsoid; else 0
  MassProperties mass_properties() const;  // refused for a half space, a hollow or a mesh, which have none
  Real bounding_radius() const;            // about the shape's origin; infinite for a half space

  // The surface of a hull or mesh: vertices, and faces as loops of vertex numbers, counter-clockwise seen from outside.
  std::span<const Vec3> vertices() const;
  std::vector<std::vector<std::uint32_t>> faces() const;

  const Geometry& geometry() const { return *geometry_; }
  const std::shared_ptr<const Geometry>& shared() const { return geometry_; }

 private:
  std::shared_ptr<const Geometry> geometry_;
};

// Exact smooth shapes.
Shape sphere(Real radius);
Shape capsule(Real radius, Real length);  // `length` of the segment between the two centres, along y
Shape cylinder(Real radius, Real height); // axis y, centred
Shape cone(Real radius, Real height);     // axis y, apex up; the origin is the centre of mass, height/4 above the base
Shape ellipsoid(Vec3 radii);
Shape half_space();                       // everything below y = 0 of its frame: an infinite floor; fixed bodies only

// Walls seen from inside, exact, for fixed bodies only: a bowl, a pipe with open ends (axis y). Only spheres collide with
// them, and only while their centre is inside; a world refuses a body that would meet one and is no sphere.
Shape hollow_sphere(Real radius);
Shape hollow_cylinder(Real radius, Real height);

// A surface of triangles, three vertex numbers each, counter-clockwise seen from the side that is felt: from behind it is
// nothing. Open or closed; for fixed and kinematic bodies, which meet everything that is convex. No inner edge is felt but
// those that jut out. Throws Error naming what is wrong by its number: "vertices[3]" is not finite; "triangles[5]" names a
// vertex that is not there, has no area, or runs along an edge in the same sense as another triangle, so that one of the
// two is inverted or there twice. Vertices in one place are taken for one.
Shape mesh(std::span<const Vec3> vertices, std::span<const std::uint32_t> triangles);  // a surface of triangles, for fixed and kinematic bodies

// Convex polyhedra, centred on their centre of mass unless said otherwise. Axes and edges as named.
Shape box(Vec3 edges);                                                      // full edges
Shape prism(int sides, Real radius, Real height);                           // regular; axis y, a vertex at +x; circumradius
Shape prism(std::span<const Vec3> outline, Real height);                    // convex outline in the xy plane (z ignored), extruded along z; kept where it is in x and y
Shape pyramid(int sides, Real radius, Real height);                         // axis y, apex up, a base vertex at +x
Shape cylinder(Real radius, Real height, int sides);                        // a prism; axis y
Shape cone(Real radius, Real height, int sides);                            // a pyramid; axis y, apex up
Shape uv_sphere(Real radius, int slices = 24, int stacks = 12);
Shape tetrahedron(Real edge);
Shape octahedron(Real edge);
Shape dodecahedron(Real edge);
Shape icosahedron(Real edge);
Shape truncated_icosahedron(Real edge);                                     // the football
Shape wedge(Vec3 edges);                                                    // right triangle (0,0),(x,0),(0,y) extruded to z, centred on its centre of mass
Shape hull(std::span<const Vec3> points);                                   // their convex hull, where they are

// Mass properties of a closed surface of outward triangles, convex or not, wherever the origin is (thesis §A: signed
// tetrahedra). Throws Error("triangles", …) when the surface is not closed.
MassProperties mass_properties(std::span<const Vec3d> vertices, std::span<const std::uint32_t> triangles);

}
