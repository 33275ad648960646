#include "geometry/polyhedron.h"

#include "geometry/primitives.h"

#include <algorithm>

namespace sudar::inline SUDAR_PRECISION {

namespace {

Error bad_faces(const char* reason) { return Error("faces", reason); }

Polygon outline(const Polyhedron& p, const Polyhedron::Face& face) {
  std::vector<Vec3d> corners;
  corners.reserve(face.count);
  for (std::uint32_t i = 0; i < face.count; ++i)
    corners.push_back(convert<double>(p.vertices[p.loops[face.first + i]]));
  return Polygon(std::move(corners));
}

void check_loops(const Polyhedron& p) {
  std::uint64_t used = 0;
  for (const Polyhedron::Face& face : p.faces) {
    if (face.first != used || face.count < 3) throw bad_faces("must have three corners or more, one after the other");
    used += face.count;
  }
  if (used != p.loops.size() || p.faces.size() < 4) throw bad_faces("must be four or more and use every loop");
  for (const std::uint32_t vertex : p.loops) {
    if (vertex >= p.vertices.size()) throw bad_faces("name a vertex that does not exist");
  }
  for (const Vec3& v : p.vertices) {
    if (!is_finite(v)) throw Error("vertices", "must be finite");
  }
}

// Each edge from its lower to its higher vertex, in the order of these. Two half-edges, one each way, make an edge.
std::vector<Polyhedron::Edge> find_edges(const Polyhedron& p) {
  struct HalfEdge {
    std::uint32_t low, high;
    bool down;
    std::uint32_t face;
    auto operator<=>(const HalfEdge&) const = default;
  };
  std::vector<HalfEdge> halves;
  halves.reserve(p.loops.size());
  for (std::uint32_t f = 0; f < p.faces.size(); ++f) {
    const Polyhedron::Face& face = p.faces[f];
    for (std::uint32_t i = 0; i < face.count; ++i) {
      const std::uint32_t from = p.loops[face.first + i], to = p.loops[face.first + (i + 1) % face.count];
      halves.push_back({std::min(from, to), std::max(from, to), from > to, f});
    }
  }
  std::sort(halves.begin(), halves.end());
  if (halves.size() % 2 != 0) throw bad_faces("are not a closed surface");
  std::vector<Polyhedron::Edge> edges;
  edges.reserve(halves.size() / 2);
  for (std::size_t i = 0; i < halves.size(); i += 2) {
    const HalfEdge &up = halves[i], &down = halves[i + 1];
    const bool pair = up.low == down.low && up.high == down.high && up.low != up.high && !up.down && down.down;
    if (!pair || up.face == down.face) throw bad_faces("are not a closed surface in which an edge has two faces");
    if (!edges.empty() && edges.back().from == up.low && edges.back().to == up.high) {
      throw bad_faces("are not a closed surface in which an edge has two faces");
    }
    edges.push_back({up.low, up.high, up.face, down.face});
  }
  return edges;
}

// Every vertex used and V − E + F = 2: one surface without holes.
void check_euler(const Polyhedron& p) {
  std::vector<bool> used(p.vertices.size(), false);
  for (const std::uint32_t vertex : p.loops) used[vertex] = true;
  if (std::find(used.begin(), used.end(), false) != used.end()) throw bad_faces("leave a vertex unused");
  if (p.vertices.size() + p.faces.size() != p.edges.size() + 2) throw bad_faces("break Euler's formula V − E + F = 2");
}

// Along a convex outline the way turns back twice in all: seen in one direction it goes out once and comes home once.
// One that goes round several times turns back more often. Ways within `tolerance` have no direction.
bool winds_once(const Polygon& outline, double tolerance) {
  const std::vector<Vec3d>& v = outline.vertices();
  const Vec3d direction = normalize(v[1] - v[0]);
  int turns = 0;
  bool ahead = true;
  for (std::size_t i = 1; i <= v.size(); ++i) {
    const double way = dot(v[(i + 1) % v.size()] - v[i % v.size()], direction);
    if (abs(way) > tolerance && (way > 0) != ahead) {
      ahead = !ahead;
      ++turns;
    }
  }
  return turns <= 2;
}

// A closed surface without holes that is flat or convex at every edge is convex as a whole (Tietze and Nakajima 1928).
void check_convex(const Polyhedron& p, const std::vector<Polygon>& outlines) {
  // Twice: a face is within the tolerance of one of its triangles, not of its mean plane.
  const double tolerance = 2 * flatness_tolerance(p.vertices);
  std::vector<Vec3d> centers;
  std::vector<Plane3> planes;
  for (const Polygon& outline : outlines) {
    planes.push_back(outline.plane());
    centers.push_back(outline.centroid());
    if (length_squared(planes.back().normal) < 0.5) throw bad_faces("must have an area");
    if (!winds_once(outline, tolerance)) throw bad_faces("must be convex polygons");
    for (const Vec3d& corner : outline.vertices()) {
      if (abs(planes.back().distance(corner)) > tolerance) throw bad_faces("must be flat");
    }
  }
  for (const Polyhedron::Edge& edge : p.edges) {
    if (planes[edge.left].distance(centers[edge.right]) > tolerance) throw bad_faces("must form a convex body");
  }
}

MassProperties measure(const Polyhedron& p) {
  std::vector<Vec3d> vertices;
  vertices.reserve(p.vertices.size());
  for (const Vec3& v : p.vertices) vertices.push_back(convert<double>(v));
  std::vector<std::uint32_t> triangles;
  for (const Polyhedron::Face& face : p.faces) {
    for (std::uint32_t i = 2; i < face.count; ++i) {
      triangles.insert(triangles.end(), {p.loops[face.first], p.loops[face.first + i - 1], p.loops[face.first + i]});
    }
  }
  return mass_properties(vertices, triangles);
}

}

double flatness_tolerance(std::span<const Vec3> vertices) {
  Real largest = 0;
  for (const Vec3& v : vertices) largest = max(largest, max_component(abs(v)));
  const double rounding =
      max(8 * double(std::numeric_limits<Real>::epsilon()), 64 * std::numeric_limits<double>::epsilon());
  return rounding * double(largest);
}

MassProperties complete(Polyhedron& p) {
  check_loops(p);
  p.edges = find_edges(p);
  check_euler(p);
  std::vector<Polygon> outlines;
  for (const Polyhedron::Face& face : p.faces) outlines.push_back(outline(p, face));
  check_convex(p, outlines);
  for (std::size_t f = 0; f < p.faces.size(); ++f) {
    p.faces[f].normal = convert<Real>(outlines[f].normal());
    p.faces[f].offset = Real(dot(convert<double>(p.faces[f].normal), outlines[f].centroid()));
  }
  const MassProperties mass = measure(p);
  p.interior = convert<Real>(mass.center);
  return mass;
}

Polyhedron make_polyhedron(std::vector<Vec3> vertices, const std::vector<std::vector<std::uint32_t>>& faces) {
  Polyhedron p;
  p.vertices = std::move(vertices);
  for (const std::vector<std::uint32_t>& loop : faces) {
    p.faces.push_back({{}, 0, std::uint32_t(p.loops.size()), std::uint32_t(loop.size())});
    p.loops.insert(p.loops.end(), loop.begin(), loop.end());
  }
  complete(p);
  return p;
}

}
