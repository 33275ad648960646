// The mass properties of a closed surface, by signed tetrahedra (volume a·(b×c)/6, covariance by Blow and Binstock
// 2004). Everything is summed about a point near the surface, so that a distant origin costs no digits.
#include <sudar/shape.h>

#include <algorithm>
#include <cstdint>

namespace sudar::inline SUDAR_PRECISION {

namespace {

// Closed: each edge is run through as often one way as the other.
void check_closed(std::size_t vertices, std::span<const std::uint32_t> triangles) {
  if (triangles.empty() || triangles.size() % 3 != 0)
    throw Error("triangles", "must be a list of vertex numbers by threes");
  struct HalfEdge {
    std::uint32_t low, high;
    bool up;
    auto operator<=>(const HalfEdge&) const = default;
  };
  std::vector<HalfEdge> edges;
  edges.reserve(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const std::uint32_t from = triangles[i], to = triangles[i % 3 == 2 ? i - 2 : i + 1];
    if (from >= vertices) throw Error("triangles", "name a vertex that does not exist");
    edges.push_back({std::min(from, to), std::max(from, to), from < to});
  }
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 0; i < edges.size();) {
    int balance = 0;
    const HalfEdge first = edges[i];
    for (; i < edges.size() && edges[i].low == first.low && edges[i].high == first.high; ++i)
      balance += edges[i].up ? 1 : -1;
    if (balance != 0) throw Error("triangles", "are not a closed surface: an edge has a triangle on one side only");
  }
}

}

MassProperties mass_properties(std::span<const Vec3d> vertices, std::span<const std::uint32_t> triangles) {
  check_closed(vertices.size(), triangles);
  const auto over_tetrahedra = [&](const Vec3d& apex, auto&& visit) {
    for (std::size_t i = 0; i < triangles.size(); i += 3) {
      const Vec3d a = vertices[triangles[i]] - apex, b = vertices[triangles[i + 1]] - apex,
                  c = vertices[triangles[i + 2]] - apex;
      visit(a, b, c, dot(a, cross(b, c)));
    }
  };

  MassProperties result;
  Vec3d moment;
  const Vec3d near = vertices[triangles[0]];
  over_tetrahedra(near, [&](const Vec3d& a, const Vec3d& b, const Vec3d& c, double determinant) {
    result.volume += determinant / 6;            // thesis (A.1), (A.3), which divides by 4
    moment += (a + b + c) * (determinant / 24);  // thesis (A.2), (A.4): the centroid is (a + b + c + 0)/4
  });
  if (!(result.volume > 0))
    throw Error("triangles", "enclose no volume; seen from outside they must run counter-clockwise");
  result.center = near + moment / result.volume;

  // thesis (A.5): ∫ x xᵀ dV over the tetrahedron (0, a, b, c) = det/120 (aaᵀ + bbᵀ + ccᵀ + ssᵀ) with s = a + b + c: A C₀ Aᵀ with
  // C₀ = 1/60 on the diagonal and 1/120 off it.
  Mat3d covariance;
  over_tetrahedra(result.center, [&](const Vec3d& a, const Vec3d& b, const Vec3d& c, double determinant) {
    const Vec3d s = a + b + c;
    covariance = covariance + (Mat3d::outer(a, a) + Mat3d::outer(b, b) + Mat3d::outer(c, c) + Mat3d::outer(s, s)) *
                                  (determinant / 120);
  });
  result.inertia = Mat3d::identity() * trace(covariance) - covariance;
  return result;
}

}
