#include "geometry/triangle_mesh.h"

#include <algorithm>
#include <numeric>

#include "base/text.h"

namespace sudar::inline SUDAR_PRECISION {

bool TriangleMesh::Triangle::allows(const Vec3& n) const {
  constexpr Real rounding = Real(1e-3);  // rad
  const Real up = dot(n, normal);
  for (std::size_t e = 0; e < 3; ++e) {
    const Real over = dot(n, across[e]);
    if (over <= 0) continue;
    const Real whole = sqrt(square(up) + square(over));
    const Real slack = rounding * sqrt(max(Real(0), 1 - square(lean[e]))) + square(rounding);
    if (up < (lean[e] - slack) * whole) return false;
  }
  return up >= 0;
}

bool TriangleMesh::Triangle::above(const Vec3& point, Real tolerance) const {
  for (std::size_t e = 0; e < 3; ++e) {
    if (dot(across[e], point - corners[e]) > tolerance) return false;
  }
  return true;
}

bool TriangleMesh::ray_cast(const Vec3& from, const Vec3& direction, Real length, std::uint32_t& triangle,
                            Real& distance) const {
  bool hit = false;
  distance = length;
  const auto misses = [&](const Node& n) {
    Real enter = 0, leave = distance;
    for (int k = 0; k < 3; ++k) {
      if (direction[k] == 0) {
        if (from[k] < n.low[k] || from[k] > n.high[k]) return true;
        continue;
      }
      const Real a = (n.low[k] - from[k]) / direction[k], b = (n.high[k] - from[k]) / direction[k];
      enter = max(enter, min(a, b)), leave = min(leave, max(a, b));
    }
    const Real slack = Real(1e-5) * (abs(enter) + abs(leave));  // a ray within a box's side is not lost by rounding
    return enter > leave + slack;
  };
  // T. Möller, B. Trumbore 1997. In double: rays along a common edge must not slip through between two triangles.
  const Vec3d o = convert<double>(from), d = convert<double>(direction);
  walk(misses, [&](std::uint32_t k) {
    const Vec3d a = convert<double>(triangles[k].corners[0]), u = convert<double>(triangles[k].corners[1]) - a,
                v = convert<double>(triangles[k].corners[2]) - a;
    const Vec3d p = cross(d, v);
    const double determinant = dot(u, p);
    if (!(determinant > 0)) return;  // from behind
    const Vec3d t = o - a, q = cross(t, u);
    const double x = dot(t, p), y = dot(d, q), edge = 1e-12 * determinant;
    if (x < -edge || y < -edge || x + y > determinant + edge) return;
    const Real way = Real(dot(v, q) / determinant);
    if (way < 0 || way > distance || (hit && way == distance && k > triangle)) return;
    hit = true, distance = way, triangle = k;
  });
  return hit;
}

namespace {

std::string named(const char* list, std::size_t k) {
  return std::string(list).append("[").append(std::to_string(k)).append("]");
}

// For each vertex the first of those in its place.
std::vector<std::uint32_t> weld(std::span<const Vec3> vertices) {
  std::vector<std::uint32_t> order(vertices.size()), first(vertices.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto place = [&](std::uint32_t i) { return std::array{vertices[i].x, vertices[i].y, vertices[i].z}; };
  std::ranges::stable_sort(order, {}, place);
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool same = k > 0 && place(order[k]) == place(order[k - 1]);
    first[order[k]] = same ? first[order[k - 1]] : order[k];
  }
  return first;
}

// The prism under a triangle, a quarter of its longest edge deep.
std::shared_ptr<const Geometry> prism_under(const TriangleMesh::Triangle& t) {
  Real longest = 0;
  for (std::size_t e = 0; e < 3; ++e) longest = max(longest, length(t.corners[(e + 1) % 3] - t.corners[e]));
  std::vector<Vec3> vertices(t.corners.begin(), t.corners.end());
  for (const Vec3& corner : t.corners) vertices.push_back(corner - t.normal * (longest / 4));
  Geometry g;
  g.kind = ShapeKind::hull;
  g.hull = make_polyhedron(std::move(vertices), {{0, 1, 2}, {3, 5, 4}, {1, 0, 3, 4}, {2, 1, 4, 5}, {0, 2, 5, 3}});
  return make_geometry(std::move(g));
}

struct HalfEdge {
  std::uint32_t low, high;  // vertices
  bool up;                  // runs from low to high
  std::uint32_t triangle, edge;
  auto operator<=>(const HalfEdge&) const = default;
  bool along(const HalfEdge& e) const { return low == e.low && high == e.high; }
};

// Two triangles run along their common edge in opposite senses. Blames the one that does not with most of its neighbours.
void check_senses(std::span<const HalfEdge> edges, std::size_t triangles) {
  std::vector<std::uint32_t> faults(triangles, 0);
  const auto each_fault = [&](auto visit) {
    for (std::size_t i = 1; i < edges.size(); ++i) {
      if (edges[i].along(edges[i - 1]) && edges[i].up == edges[i - 1].up) visit(edges[i - 1].triangle, edges[i].triangle);
    }
  };
  each_fault([&](std::uint32_t t, std::uint32_t u) { ++faults[t], ++faults[u]; });
  const auto worst = std::uint32_t(std::ranges::max_element(faults) - faults.begin());
  each_fault([&](std::uint32_t t, std::uint32_t u) {
    if (t != worst && u != worst) return;
    throw Error(named("triangles", worst), "runs along an edge in the same sense as " + named("triangles", t == worst ? u : t) +
                                               ": it is inverted, or there twice");
  });
}

// How far normals may lean over the edges that triangles share.
void join_edges(TriangleMesh& mesh, std::span<const std::uint32_t> corners, std::span<const std::uint32_t> welded) {
  std::vector<HalfEdge> edges;
  edges.reserve(corners.size());
  for (std::uint32_t k = 0; k < corners.size(); ++k) {
    const std::uint32_t from = welded[corners[k]], to = welded[corners[k % 3 == 2 ? k - 2 : k + 1]];
    edges.push_back({std::min(from, to), std::max(from, to), from < to, k / 3, k % 3});
  }
  std::ranges::sort(edges);
  check_senses(edges, mesh.triangles.size());
  for (std::size_t i = 1; i < edges.size(); ++i) {
    const HalfEdge &one = edges[i - 1], &other = edges[i];
    if (!one.along(other)) continue;
    TriangleMesh::Triangle &t = mesh.triangles[one.triangle], &u = mesh.triangles[other.triangle];
    const Vec3 far_of_u = u.corners[(other.edge + 2) % 3] - t.corners[one.edge];
    const bool falls = dot(t.normal, far_of_u) < Real(-1e-4) * length(far_of_u);
    t.lean[one.edge] = u.lean[other.edge] = falls ? dot(t.normal, u.normal) : Real(1);
  }
}

void grow_tree(TriangleMesh& mesh, std::uint32_t first, std::uint32_t end) {
  constexpr std::uint32_t leaf = 4;
  const auto at = mesh.nodes.size();
  TriangleMesh::Node node{.low = mesh.triangles[mesh.order[first]].corners[0], .high = mesh.triangles[mesh.order[first]].corners[0]};
  for (std::uint32_t i = first; i < end; ++i) {
    for (const Vec3& corner : mesh.triangles[mesh.order[i]].corners) {
      node.low = min(node.low, corner), node.high = max(node.high, corner);
    }
  }
  const bool is_leaf = end - first <= leaf;
  if (is_leaf) node.first = first, node.count = end - first;
  mesh.nodes.push_back(node);
  if (!is_leaf) {
    const Vec3 extent = node.high - node.low;
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    const auto middle = [&](std::uint32_t k) {
      const auto& c = mesh.triangles[k].corners;
      return std::pair(c[0][axis] + c[1][axis] + c[2][axis], k);
    };
    std::ranges::sort(mesh.order.begin() + first, mesh.order.begin() + end, {}, middle);
    const std::uint32_t half = first + (end - first) / 2;
    grow_tree(mesh, first, half);
    grow_tree(mesh, half, end);
  }
  mesh.nodes[at].after = std::uint32_t(mesh.nodes.size());
}

}

std::shared_ptr<const TriangleMesh> make_triangle_mesh(std::span<const Vec3> vertices,
                                                       std::span<const std::uint32_t> corners) {
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    if (!is_finite(vertices[k])) throw Error(named("vertices", k), "is not finite");
  }
  if (corners.empty() || corners.size() % 3 != 0) throw Error("triangles", "must be a list of vertex numbers by threes");
  TriangleMesh mesh;
  mesh.triangles.resize(corners.size() / 3);
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    TriangleMesh::Triangle& t = mesh.triangles[k];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t v = corners[3 * k + i];
      if (v >= vertices.size()) {
        throw Error(named("triangles", k), "names vertex " + std::to_string(v) + ", there are " + std::to_string(vertices.size()));
      }
      t.corners[i] = vertices[v];
    }
    const Vec3d a = convert<double>(t.corners[0]), u = convert<double>(t.corners[1]) - a, v = convert<double>(t.corners[2]) - a;
    const Vec3d across = cross(u, v);
    const double longest = max(max(length(u), length(v)), length(v - u));
    if (!(length(across) > 1e-6 * square(longest))) throw Error(named("triangles", k), "has no area");
    t.normal = convert<Real>(normalize(across));
    t.lean = {0, 0, 0};
    for (std::size_t e = 0; e < 3; ++e) t.across[e] = normalize(cross(t.corners[(e + 1) % 3] - t.corners[e], t.normal));
    try {
      t.piece = prism_under(t);
    } catch (const Error&) {
      throw Error(named("triangles", k), "is too thin or too small for its distance from the origin");
    }
  }
  join_edges(mesh, corners, weld(vertices));
  mesh.order.resize(mesh.triangles.size());
  std::iota(mesh.order.begin(), mesh.order.end(), 0u);
  grow_tree(mesh, 0, std::uint32_t(mesh.order.size()));
  mesh.low = mesh.nodes[0].low, mesh.high = mesh.nodes[0].high;
  return std::make_shared<const TriangleMesh>(std::move(mesh));
}

}
