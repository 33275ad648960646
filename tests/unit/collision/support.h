// What the tests of the narrow phase share: random shapes and poses that are the same everywhere, and separating axes
// by brute force in double as the oracle.
#pragma once

#include "collision/narrow/closest.h"
#include "collision/narrow/collide.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace sudar::test {

// SplitMix64 (S. Vigna).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t bits() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  int below(int n) { return int(bits() % std::uint64_t(n)); }
  double uniform(double low = 0, double high = 1) { return low + (high - low) * double(bits() >> 11) * 0x1p-53; }
  Vec3 in_box(double half) {
    return {Real(uniform(-half, half)), Real(uniform(-half, half)), Real(uniform(-half, half))};
  }
  Vec3 direction() {
    for (;;) {
      const Vec3 v = in_box(1);
      const Real l = length(v);
      if (l > 0.1 && l <= 1) return v / l;
    }
  }
  Quat turn() {
    for (;;) {
      const Quat q{Real(uniform(-1, 1)), Real(uniform(-1, 1)), Real(uniform(-1, 1)), Real(uniform(-1, 1))};
      if (length_squared(q) > 0.01 && length_squared(q) <= 1) return normalize(q);
    }
  }

 private:
  std::uint64_t state_;
};

inline Quat turned(const Vec3& axis, double angle) { return axis_angle(normalize(axis), Real(angle)); }
inline Vec3d wide(const Vec3& v) { return {v.x, v.y, v.z}; }
inline Mat3d wide_matrix(const Quat& q) { return matrix(normalize(Quatd{q.x, q.y, q.z, q.w})); }

// The points nearer than the margin.
inline Manifold contact(const Shape& a, const Transform& at_a, const Shape& b, const Transform& at_b,
                        double margin = 0) {
  AxisCache cache;
  Manifold m;
  collide({&a.geometry(), at_a}, {&b.geometry(), at_b}, Real(margin), cache, m);
  return m;
}

inline std::span<const ManifoldPoint> points(const Manifold& m) { return {m.points.data(), std::size_t(m.count)}; }

inline double lowest_separation(const Manifold& m) {
  double low = 1e30;
  for (const ManifoldPoint& p : points(m)) low = std::min(low, double(p.separation));
  return low;
}

// A hull's corners, normals and edge directions in the common frame, in double.
struct WideHull {
  std::vector<Vec3d> vertices, normals, edges;
  std::vector<double> offsets;

  WideHull(const Shape& shape, const Transform& at) {
    const Mat3d r = wide_matrix(at.q);
    const Polyhedron& hull = shape.geometry().hull;
    for (const Vec3& v : hull.vertices) vertices.push_back(r * wide(v) + wide(at.p));
    for (const Polyhedron::Face& f : hull.faces) {
      normals.push_back(normalize(r * wide(f.normal)));
      offsets.push_back(farthest(normals.back()));
    }
    for (const Polyhedron::Edge& e : hull.edges) edges.push_back(vertices[e.to] - vertices[e.from]);
  }
  double farthest(const Vec3d& n) const {
    double d = -1e300;
    for (const Vec3d& v : vertices) d = std::max(d, dot(n, v));
    return d;
  }
  double height(const Vec3d& p) const {  // above the hull; exact inside, a lower bound of the distance outside
    double h = -1e300;
    for (std::size_t i = 0; i < normals.size(); ++i) h = std::max(h, dot(normals[i], p) - offsets[i]);
    return h;
  }
};

// How far b is beyond a along n (of length 1, from a to b).
inline double separation_along(const WideHull& a, const WideHull& b, const Vec3d& n) {
  return -b.farthest(-n) - a.farthest(n);
}

// The largest separation over all face normals and all cross products of edges: the negative of the depth if the hulls
// overlap, and positive exactly if they do not.
inline double oracle_separation(const WideHull& a, const WideHull& b) {
  double best = -1e300;
  for (const Vec3d& n : a.normals) best = std::max(best, separation_along(a, b, n));
  for (const Vec3d& n : b.normals) best = std::max(best, separation_along(a, b, -n));
  for (const Vec3d& ea : a.edges) {
    for (const Vec3d& eb : b.edges) {
      const Vec3d c = cross(ea, eb);
      const double l = length(c);
      if (l <= 1e-9 * length(ea) * length(eb)) continue;
      best = std::max(best, std::max(separation_along(a, b, c / l), separation_along(a, b, -(c / l))));
    }
  }
  return best;
}

// --- true distances, from the nearest triangle or edge ---

inline double distance_to_segment(const Vec3d& a, const Vec3d& b, const Vec3d& p) {
  return length(p - a - (b - a) * std::clamp(dot(p - a, b - a) / dot(b - a, b - a), 0.0, 1.0));
}

inline double distance_to_triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& p) {
  const Vec3d n = cross(b - a, c - a);
  const auto inside = [&](const Vec3d& u, const Vec3d& v) { return dot(cross(v - u, p - u), n) >= 0; };
  if (length(n) > 1e-12 && inside(a, b) && inside(b, c) && inside(c, a)) return std::abs(dot(n, p - a)) / length(n);
  return std::min({distance_to_segment(a, b, p), distance_to_segment(b, c, p), distance_to_segment(c, a, p)});
}

// 0 inside.
inline double distance_to_hull(const Shape& shape, const WideHull& hull, const Vec3d& p) {
  if (hull.height(p) <= 0) return 0;
  double best = 1e300;
  for (const auto& loop : shape.faces()) {
    for (std::size_t i = 2; i < loop.size(); ++i) {
      const auto& v = hull.vertices;
      best = std::min(best, distance_to_triangle(v[loop[0]], v[loop[i - 1]], v[loop[i]], p));
    }
  }
  return best;
}

// Of two hulls that are apart. Edges meet as in closest(), which round_test.cc tests.
inline double distance_between(const Shape& sa, const WideHull& a, const Shape& sb, const WideHull& b) {
  double best = 1e300;
  for (const Vec3d& v : a.vertices) best = std::min(best, distance_to_hull(sb, b, v));
  for (const Vec3d& v : b.vertices) best = std::min(best, distance_to_hull(sa, a, v));
  const auto narrow = [](const Vec3d& v) { return Vec3{Real(v.x), Real(v.y), Real(v.z)}; };
  for (const Polyhedron::Edge& ea : sa.geometry().hull.edges) {
    for (const Polyhedron::Edge& eb : sb.geometry().hull.edges) {
      const SegmentPoints c = closest({narrow(a.vertices[ea.from]), narrow(a.vertices[ea.to] - a.vertices[ea.from])},
                                      {narrow(b.vertices[eb.from]), narrow(b.vertices[eb.to] - b.vertices[eb.from])});
      best = std::min(best, double(length(c.on_a - c.on_b)));
    }
  }
  return best;
}

// A random hull of the size 1, more or less flat or long.
inline Shape random_hull(Random& random) {
  const int kind = random.below(4);
  const Vec3 size{Real(random.uniform(0.3, 2)), Real(random.uniform(0.3, 2)), Real(random.uniform(0.3, 2))};
  if (kind == 0) return box(size);
  std::vector<Vec3> cloud;
  const int n = kind == 1 ? 4 : 6 + random.below(10);
  for (;;) {
    cloud.clear();
    for (int i = 0; i < n; ++i) cloud.push_back(scale(size, random.direction()));
    try {
      Shape shape = hull(cloud);
      if (shape.mass_properties().volume > 0.02 * double(size.x * size.y * size.z)) return shape;
    } catch (const Error&) {}
  }
}

}
