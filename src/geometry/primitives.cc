#include "geometry/primitives.h"

#include "math/pair.h"

namespace sudar::inline SUDAR_PRECISION {

Vec3d accurate_cross(const Vec3d& a, const Vec3d& b) {
  const auto difference = [](double p, double q, double r, double s) {  // pq − rs
    const Pair<double> x = two_product(p, q), y = two_product(r, s);
    return (x.hi - y.hi) + (x.lo - y.lo);
  };
  return {difference(a.y, b.z, a.z, b.y), difference(a.z, b.x, a.x, b.z), difference(a.x, b.y, a.y, b.x)};
}

Plane3 Plane3::through(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const Vec3d normal = normalize(accurate_cross(b - a, c - a));
  return {normal, dot(normal, a)};
}

Vec3d Segment3::closest(const Vec3d& point) const {
  const Vec3d d = b - a;
  const double dd = length_squared(d);
  return dd > 0 ? at(clamp(dot(point - a, d) / dd, 0.0, 1.0)) : a;
}

std::pair<Vec3d, Vec3d> closest(const Segment3& a, const Segment3& b) {
  // The nearest points of the two lines, clamped to the first segment; from there to the second and back, which is
  // exact: the squared distance is a convex quadratic form over the unit square of the two parameters.
  const Vec3d d = a.b - a.a, e = b.b - b.a, r = a.a - b.a;
  const double dd = dot(d, d), ee = dot(e, e), de = dot(d, e), sine = dd * ee - de * de;
  double s = 0;
  if (sine > 0) s = clamp((de * dot(e, r) - ee * dot(d, r)) / sine, 0.0, 1.0);
  const Vec3d on_b = b.closest(a.at(s));
  const Vec3d on_a = a.closest(on_b);
  return {on_a, on_b};
}

Vec3d Polygon::area_vector() const {
  Vec3d sum;
  for (std::size_t i = 2; i < vertices_.size(); ++i) {
    sum += accurate_cross(vertices_[i - 1] - vertices_[0], vertices_[i] - vertices_[0]);
  }
  return sum * 0.5;
}

Vec3d Polygon::centroid() const {
  const Vec3d n = normal();
  Vec3d sum;
  double weight = 0;
  for (std::size_t i = 2; i < vertices_.size(); ++i) {
    const Vec3d b = vertices_[i - 1] - vertices_[0], c = vertices_[i] - vertices_[0];
    const double w = dot(n, cross(b, c));
    sum += (b + c) * w;
    weight += 3 * w;
  }
  return weight != 0 ? vertices_[0] + sum / weight : vertices_[0];
}

Plane3 Polygon::plane() const {
  const Vec3d n = normal();
  return {n, dot(n, centroid())};
}

Polygon Polygon::clip(const Plane3& plane) const {
  std::vector<Vec3d> kept;
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    const Vec3d &from = vertices_[i], &to = vertices_[(i + 1) % vertices_.size()];
    const double d = plane.distance(from), e = plane.distance(to);
    if (d <= 0) kept.push_back(from);
    if ((d < 0 && e > 0) || (d > 0 && e < 0)) kept.push_back(from + (to - from) * (d / (d - e)));
  }
  return Polygon(kept.size() >= 3 ? std::move(kept) : std::vector<Vec3d>{});
}

}
