// The polyhedra of shape.h. Corners are computed in double and rounded once.
#include <sudar/shape.h>

#include "geometry/geometry.h"
#include "geometry/hull.h"

#include <algorithm>

namespace sudar::inline SUDAR_PRECISION {

namespace {

using Loops = std::vector<std::vector<std::uint32_t>>;

// Sizes whose squares and cubes neither overflow nor vanish in float.
double checked(const char* argument, Real size) {
  if (!(size > Real(1e-9) && size < Real(1e12))) throw Error(argument, "must be a length between 1e-9 and 1e12 m");
  return double(size);
}

Vec3d checked(const char* argument, const Vec3& sizes) {
  return {checked(argument, sizes.x), checked(argument, sizes.y), checked(argument, sizes.z)};
}

std::uint32_t checked_count(const char* argument, int count, int low) {
  if (count < low || count > 10000) throw Error(argument, "must lie between " + std::to_string(low) + " and 10000");
  return std::uint32_t(count);
}

std::vector<Vec3> rounded(const std::vector<Vec3d>& corners) {
  std::vector<Vec3> result;
  for (const Vec3d& corner : corners) result.push_back(convert<Real>(corner));
  return result;
}

Shape shape_of(Polyhedron&& polyhedron) {
  Geometry g;
  g.kind = ShapeKind::hull;
  g.hull = std::move(polyhedron);
  return Shape(make_geometry(std::move(g)));
}

Shape from_faces(const std::vector<Vec3d>& corners, const Loops& faces) {
  return shape_of(make_polyhedron(rounded(corners), faces));
}

// The hull of the corners, grown or shrunk so that its edges have the length `edge`; `unit` is the length they have.
Shape regular(Real edge, double unit, std::vector<Vec3d> corners) {
  const double factor = checked("edge", edge) / unit;
  for (Vec3d& corner : corners) corner *= factor;
  return shape_of(convex_hull(rounded(corners)));
}

// The points (±v.x, ±v.y, ±v.z) and their cyclic permutations, each once.
void add_permutations(std::vector<Vec3d>& points, const Vec3d& v) {
  for (int signs = 0; signs < 8; ++signs) {
    const Vec3d s = scale(v, {signs & 1 ? -1.0 : 1.0, signs & 2 ? -1.0 : 1.0, signs & 4 ? -1.0 : 1.0});
    for (const Vec3d& p : {s, Vec3d{s.y, s.z, s.x}, Vec3d{s.z, s.x, s.y}}) {
      if (std::find(points.begin(), points.end(), p) == points.end()) points.push_back(p);
    }
  }
}

// A regular polygon at height y, counter-clockwise as seen from below (from −y), the first corner at +x.
void add_ring(std::vector<Vec3d>& points, std::uint32_t sides, double radius, double y) {
  for (std::uint32_t i = 0; i < sides; ++i) {
    const double angle = 2 * pi * i / sides;
    points.push_back({radius * cos(angle), y, radius * sin(angle)});
  }
}

// The numbers first … first + count − 1 in a ring, forwards or backwards.
std::vector<std::uint32_t> ring(std::uint32_t first, std::uint32_t count, bool forwards) {
  std::vector<std::uint32_t> loop;
  for (std::uint32_t i = 0; i < count; ++i) loop.push_back(first + (forwards ? i : count - 1 - i));
  return loop;
}

// Corners 0 … n − 1 around one end, n … 2n − 1 around the other, counter-clockwise as seen from the second.
Loops prism_faces(std::uint32_t n) {
  Loops faces{ring(0, n, false), ring(n, n, true)};
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    faces.push_back({i, j, n + j, n + i});
  }
  return faces;
}

constexpr double golden_ratio = 1.61803398874989484820;

}

Shape box(Vec3 edges) {
  const Vec3d half = checked("edges", edges) * 0.5;
  std::vector<Vec3d> corners;
  for (int i = 0; i < 8; ++i)
    corners.push_back(scale(half, {i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0}));
  return from_faces(corners, {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}});
}

Shape prism(int sides, Real radius, Real height) {
  const std::uint32_t n = checked_count("sides", sides, 3);
  const double r = checked("radius", radius), half = checked("height", height) / 2;
  std::vector<Vec3d> corners;
  add_ring(corners, n, r, half);
  add_ring(corners, n, r, -half);
  return from_faces(corners, prism_faces(n));
}

Shape prism(std::span<const Vec3> outline, Real height) {
  const Real half = Real(checked("height", height) / 2);
  if (outline.size() < 3) throw Error("outline", "must have three corners or more");
  std::vector<Vec3> corners;
  for (const Vec3& v : outline) corners.push_back({v.x, v.y, -half});
  for (const Vec3& v : outline) corners.push_back({v.x, v.y, half});
  const std::uint32_t n = std::uint32_t(outline.size());
  double area = 0;  // twice, positive if the outline runs counter-clockwise as seen from +z
  for (std::uint32_t i = 2; i < n; ++i) {
    area += convert<double>(cross(corners[i - 1] - corners[0], corners[i] - corners[0])).z;
  }
  if (area < 0) {
    std::reverse(corners.begin(), corners.begin() + n);
    std::reverse(corners.begin() + n, corners.end());
  }
  try {
    return shape_of(make_polyhedron(std::move(corners), prism_faces(n)));
  } catch (const Error&) { throw Error("outline", "must be a convex polygon without repeated corners"); }
}

Shape pyramid(int sides, Real radius, Real height) {
  const std::uint32_t n = checked_count("sides", sides, 3);
  const double r = checked("radius", radius), h = checked("height", height);
  std::vector<Vec3d> corners;
  add_ring(corners, n, r, -h / 4);  // the centre of mass of a pyramid is a quarter of the way up
  corners.push_back({0, 0.75 * h, 0});
  Loops faces{ring(0, n, true)};
  for (std::uint32_t i = 0; i < n; ++i) faces.push_back({i, n, (i + 1) % n});
  return from_faces(corners, faces);
}

Shape cylinder(Real radius, Real height, int sides) { return prism(sides, radius, height); }
Shape cone(Real radius, Real height, int sides) { return pyramid(sides, radius, height); }

Shape uv_sphere(Real radius, int slices, int stacks) {
  const double r = checked("radius", radius);
  const std::uint32_t n = checked_count("slices", slices, 3), rings = checked_count("stacks", stacks, 2) - 1;
  std::vector<Vec3d> corners;
  for (std::uint32_t k = 1; k <= rings; ++k) {  // from the south pole up
    const double angle = pi * k / (rings + 1);
    add_ring(corners, n, r * sin(angle), -r * cos(angle));
  }
  const std::uint32_t south = n * rings, north = south + 1;
  corners.push_back({0, -r, 0});
  corners.push_back({0, r, 0});
  Loops faces;
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n, top = n * (rings - 1);
    faces.push_back({south, i, j});
    for (std::uint32_t k = 0; k < top; k += n) faces.push_back({k + i, k + n + i, k + n + j, k + j});
    faces.push_back({top + i, north, top + j});
  }
  return from_faces(corners, faces);
}

Shape tetrahedron(Real edge) {
  return regular(edge, 2 * sqrt(2.0), {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}});
}

Shape octahedron(Real edge) {
  std::vector<Vec3d> corners;
  add_permutations(corners, {1, 0, 0});
  return regular(edge, sqrt(2.0), corners);
}

Shape dodecahedron(Real edge) {
  std::vector<Vec3d> corners;
  add_permutations(corners, {1, 1, 1});
  add_permutations(corners, {0, 1 / golden_ratio, golden_ratio});
  return regular(edge, 2 / golden_ratio, corners);
}

Shape icosahedron(Real edge) {
  std::vector<Vec3d> corners;
  add_permutations(corners, {0, 1, golden_ratio});
  return regular(edge, 2, corners);
}

Shape truncated_icosahedron(Real edge) {
  std::vector<Vec3d> corners;
  add_permutations(corners, {0, 1, 3 * golden_ratio});
  add_permutations(corners, {1, 2 + golden_ratio, 2 * golden_ratio});
  add_permutations(corners, {golden_ratio, 2, 2 * golden_ratio + 1});
  return regular(edge, 2, corners);
}

Shape wedge(Vec3 edges) {
  const Vec3d e = checked("edges", edges);
  // The right angle at (−1/3, −1/3) of the legs puts the triangle's centroid at the origin.
  const Vec3d low = scale(e, {-1.0 / 3, -1.0 / 3, -0.5}), high = low + e;
  const std::vector<Vec3d> corners{low,
                                   {high.x, low.y, low.z},
                                   {low.x, high.y, low.z},
                                   {low.x, low.y, high.z},
                                   {high.x, low.y, high.z},
                                   {low.x, high.y, high.z}};
  return from_faces(corners, {{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}});
}

Shape hull(std::span<const Vec3> points) { return shape_of(convex_hull(points)); }

}
