#include "geometry/triangulated_hull.h"

#include "geometry/predicates.h"

#include <utility>

namespace sudar::inline SUDAR_PRECISION {

namespace {

struct Facet {
  HullTriangle triangle;
  bool alive = true;
  std::uint32_t visible_from = 0xffffffffu;  // the last point found to see this facet
  std::vector<std::uint32_t> outside;        // points that see this facet and no earlier one
};

struct Edge {
  std::uint32_t from, to, beyond;  // `beyond`: the facet behind the horizon
};

class Builder {
 public:
  Builder(std::span<const Vec3d> points, std::array<std::uint32_t, 4> simplex)
      : points_(points), facet_from_(points.size()) {
    if (orientation(points[simplex[0]], points[simplex[1]], points[simplex[2]], points[simplex[3]]) > 0) {
      std::swap(simplex[0], simplex[1]);  // now the last lies below the first three
    }
    const auto [a, b, c, d] = simplex;
    facets_ = {{{{a, b, c}, {2, 3, 1}}, true, 0xffffffffu, {}},
               {{{a, c, d}, {0, 3, 2}}, true, 0xffffffffu, {}},
               {{{a, d, b}, {1, 3, 0}}, true, 0xffffffffu, {}},
               {{{b, d, c}, {2, 1, 0}}, true, 0xffffffffu, {}}};
    std::vector<std::uint32_t> all;
    for (std::uint32_t p = 0; p < points.size(); ++p) all.push_back(p);
    assign(all, 0);
  }

  std::vector<HullTriangle> build() {
    for (std::size_t f = 0; f < facets_.size(); ++f) {  // grows
      if (facets_[f].alive && !facets_[f].outside.empty()) add_point(farthest(facets_[f]), std::uint32_t(f));
    }
    return alive_triangles();
  }

 private:
  bool sees(std::uint32_t p, const Facet& f) const {
    const auto& [a, b, c] = f.triangle.corners;
    return orientation(points_[a], points_[b], points_[c], points_[p]) > 0;
  }

  // Each point to the first facet, from number `first` on, that it sees. One that sees none is inside.
  void assign(const std::vector<std::uint32_t>& candidates, std::size_t first) {
    for (const std::uint32_t p : candidates) {
      for (std::size_t f = first; f < facets_.size(); ++f) {
        if (sees(p, facets_[f])) {
          facets_[f].outside.push_back(p);
          break;
        }
      }
    }
  }

  std::uint32_t farthest(const Facet& facet) const {
    const auto& [a, b, c] = facet.triangle.corners;
    const Vec3d normal = cross(points_[b] - points_[a], points_[c] - points_[a]);
    std::uint32_t best = facet.outside[0];
    double best_distance = -1;
    for (const std::uint32_t p : facet.outside) {
      const double distance = dot(normal, points_[p] - points_[a]);
      if (distance > best_distance) {
        best_distance = distance;
        best = p;
      }
    }
    return best;
  }

  // The edges around all facets that p sees, `first` among them; these are dead then. In a convex surface they form a
  // disc, so each corner of the horizon starts one edge.
  std::vector<Edge> take_visible(std::uint32_t p, std::uint32_t first, std::vector<std::uint32_t>& orphans) {
    std::vector<Edge> horizon;
    std::vector<std::uint32_t> stack{first};
    facets_[first].visible_from = p;
    while (!stack.empty()) {
      Facet& facet = facets_[stack.back()];
      stack.pop_back();
      facet.alive = false;
      orphans.insert(orphans.end(), facet.outside.begin(), facet.outside.end());
      facet.outside = {};
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t n = facet.triangle.neighbors[i];
        if (facets_[n].visible_from == p) continue;
        if (sees(p, facets_[n])) {
          facets_[n].visible_from = p;
          stack.push_back(n);
        } else {
          horizon.push_back({facet.triangle.corners[i], facet.triangle.corners[(i + 1) % 3], n});
        }
      }
    }
    return horizon;
  }

  // Replaces what p sees by the cone from p over the horizon.
  void add_point(std::uint32_t p, std::uint32_t seen) {
    std::vector<std::uint32_t> orphans;
    const std::vector<Edge> horizon = take_visible(p, seen, orphans);
    const std::size_t first = facets_.size();
    for (const Edge& edge : horizon) {
      const std::uint32_t number = std::uint32_t(facets_.size());
      facet_from_[edge.from] = number;
      facets_.push_back({{{edge.from, edge.to, p}, {edge.beyond, 0, 0}}, true, 0xffffffffu, {}});
      HullTriangle& beyond = facets_[edge.beyond].triangle;
      for (std::size_t i = 0; i < 3; ++i) {
        if (beyond.corners[i] == edge.to) beyond.neighbors[i] = number;
      }
    }
    for (std::size_t f = first; f < facets_.size(); ++f) {
      const std::uint32_t next = facet_from_[facets_[f].triangle.corners[1]];
      facets_[f].triangle.neighbors[1] = next;
      facets_[next].triangle.neighbors[2] = std::uint32_t(f);
    }
    assign(orphans, first);
  }

  std::vector<HullTriangle> alive_triangles() const {
    std::vector<std::uint32_t> number(facets_.size());
    std::vector<HullTriangle> triangles;
    for (std::size_t f = 0; f < facets_.size(); ++f) {
      number[f] = std::uint32_t(triangles.size());
      if (facets_[f].alive) triangles.push_back(facets_[f].triangle);
    }
    for (HullTriangle& t : triangles) {
      for (std::uint32_t& n : t.neighbors) n = number[n];
    }
    return triangles;
  }

  std::span<const Vec3d> points_;
  std::vector<Facet> facets_;
  std::vector<std::uint32_t> facet_from_;  // by corner: the new facet whose horizon edge starts there
};

}

std::vector<HullTriangle> triangulated_hull(std::span<const Vec3d> points, std::array<std::uint32_t, 4> simplex) {
  return Builder(points, simplex).build();
}

}
