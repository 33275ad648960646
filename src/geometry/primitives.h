// Planes, lines, segments and polygons as values that are never changed, only replaced; in double.
#pragma once

#include <sudar/math.h>

#include <utility>
#include <vector>

namespace sudar::inline SUDAR_PRECISION {

// The cross product with a relative error of a few roundings even for nearly parallel vectors, where the plain
// formula's differences cancel: the normal of a sliver is as good as its corners are.
Vec3d accurate_cross(const Vec3d& a, const Vec3d& b);

// The points x with normal · x = offset; the normal has length 1 and points to the positive side.
struct Plane3 {
  Vec3d normal{0, 1, 0};
  double offset = 0;
  // Counter-clockwise a, b, c as seen from the positive side.
  static Plane3 through(const Vec3d& a, const Vec3d& b, const Vec3d& c);
  double distance(const Vec3d& point) const { return dot(normal, point) - offset; }
  Vec3d project(const Vec3d& point) const { return point - normal * distance(point); }
  Plane3 flipped() const { return {-normal, -offset}; }
};

// point + t direction; the direction need not have length 1, but must not be 0.
struct Line3 {
  Vec3d point, direction{1, 0, 0};
  Vec3d at(double t) const { return point + direction * t; }
  double parameter(const Vec3d& near) const { return dot(near - point, direction) / length_squared(direction); }
  double distance(const Vec3d& to) const { return length(to - at(parameter(to))); }
};

struct Segment3 {
  Vec3d a, b;
  Vec3d at(double t) const { return a + (b - a) * t; }
  Vec3d closest(const Vec3d& point) const;
};

// The points of the two segments that are nearest to each other; one such pair if they are parallel.
std::pair<Vec3d, Vec3d> closest(const Segment3& a, const Segment3& b);

// A flat polygon, counter-clockwise as seen from where its normal points. The measures also hold for one that is not
// convex, and are those of the best plane (Newell) for one that is not quite flat.
class Polygon {
 public:
  Polygon() = default;
  explicit Polygon(std::vector<Vec3d> vertices) : vertices_(std::move(vertices)) {}
  const std::vector<Vec3d>& vertices() const { return vertices_; }
  Vec3d area_vector() const;  // the normal, as long as the area
  double area() const { return length(area_vector()); }
  Vec3d normal() const { return normalize(area_vector()); }
  Vec3d centroid() const;
  Plane3 plane() const;
  // What lies on the negative side of the plane (Sutherland and Hodgman 1974); convex polygons only. May be empty.
  Polygon clip(const Plane3& plane) const;

 private:
  std::vector<Vec3d> vertices_;
};

}
