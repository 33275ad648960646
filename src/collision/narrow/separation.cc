#include "collision/narrow/separation.h"

#include "collision/narrow/gjk.h"
#include "geometry/primitives.h"

namespace sudar::inline SUDAR_PRECISION {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double core_separation(const Convex& a, const Convex& b, const Vec3d& normal) {
  return dot(normal, a.support(-normal) - b.support(normal));
}

// The way out, as a plane that supports the Minkowski difference: depth = normal · w.
struct WayOut {
  Vec3d normal;  // outward from a − b: along it b would have to be moved
  double depth = infinity;
};

// The difference a − b of two cores as a growing polytope of triangles.
class Polytope {
 public:
  Polytope(const Convex& a, const Convex& b) : a_(a), b_(b), rounding_(1e-13 * (a.radius() + b.radius())) {}

  WayOut shortest_way_out() {
    constexpr double bracket = 1e-4;
    if (!begin()) return best_;
    for (;;) {
      const int nearest = nearest_face();
      if (nearest < 0) break;
      const double least = faces_[nearest].offset;
      if (best_.depth - least <= bracket * max(best_.depth, 0.0) + 1e-2 * bracket * size_) break;
      const int v = add(faces_[nearest].normal);
      if (v < 0 || !(dot(faces_[nearest].normal, points_[v]) > least + rounding_)) break;
      if (!grow(nearest, v)) break;
    }
    return best_;
  }

 private:
  static constexpr int most_points = 128, most_faces = 320;

  struct Face {
    int corner[3], beside[3];  // beside[i]: the face across the edge corner[i] → corner[i + 1]
    Vec3d normal;
    double offset;
    bool alive;
  };

  // Measures the support plane of that normal (any length); the number of the point, −1 if there is no room.
  int add(const Vec3d& direction) {
    const double l = length(direction);
    if (!(l > 0) || point_count_ == most_points) return -1;
    const Vec3d n = direction / l, w = a_.support(n) - b_.support(-n);
    if (dot(n, w) < best_.depth) best_ = {n, dot(n, w)};
    points_[point_count_] = w;
    return point_count_++;
  }

  // A tetrahedron as fat as four directions can tell. It need not hold the origin: faces that see the origin from
  // outside have a negative offset, and grow first.
  bool begin() {
    const auto better = [&](const Vec3d& n, const Vec3d& from) {  // the one of ±n that leads farther
      const int plus = add(n), minus = add(-n);
      if (plus < 0 || minus < 0) return -1;
      return abs(dot(n, points_[plus] - from)) >= abs(dot(n, points_[minus] - from)) ? plus : minus;
    };
    const int p0 = add({1, 0, 0}), p1 = better({0, 1, 0}, points_[p0]);
    const Vec3d along = normalize(points_[p1] - points_[p0]);
    const int p2 = p1 < 0 || along == Vec3d{} ? -1 : better(any_perpendicular(along), points_[p0]);
    if (p2 < 0) return false;
    const Vec3d side = points_[p2] - points_[p0], across = cross(along, side);
    int p3 = better(across, points_[p0]);
    if (p3 < 0) return false;
    int corner[4] = {p0, p1, p2, p3};
    if (dot(across, points_[p3] - points_[p0]) > 0) std::swap(corner[1], corner[2]);
    size_ = length(points_[p1] - points_[p0]);
    constexpr int triangles[4][3] = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
    constexpr int beside[4][3] = {{1, 2, 3}, {3, 2, 0}, {1, 3, 0}, {2, 1, 0}};
    for (int f = 0; f < 4; ++f) {
      Face& face = faces_[face_count_++];
      for (int i = 0; i < 3; ++i) face.corner[i] = corner[triangles[f][i]], face.beside[i] = beside[f][i];
      measure(face);
    }
    return true;
  }

  void measure(Face& f) {
    const Vec3d &p = points_[f.corner[0]], &q = points_[f.corner[1]], &r = points_[f.corner[2]];
    const Vec3d n = cross(q - p, r - p);
    const double l = length(n), edges = length_squared(q - p) + length_squared(r - p);
    f.alive = true;
    // A sliver has no direction to grow in; its neighbours cover what is near it.
    f.normal = l > 0 ? n / l : n;
    f.offset = l > 1e-13 * edges ? dot(f.normal, p) : infinity;
  }

  int nearest_face() const {
    int best = -1;
    double least = infinity;
    for (int f = 0; f < face_count_; ++f) {
      if (faces_[f].alive && faces_[f].offset < least) least = faces_[f].offset, best = f;
    }
    return best;
  }

  // Replaces the faces that see the point by a fan from it to their outline.
  bool grow(int seen_first, int point) {
    fan_count_ = removed_count_ = 0;
    remove(seen_first);
    for (int i = 0; i < 3; ++i) {
      if (!visit(faces_[seen_first].beside[i], seen_first, point)) return false;
    }
    if (fan_count_ < 3) return false;
    for (int i = 0; i < fan_count_; ++i) {  // the outline was walked in order
      const int now = fan_[i], next = fan_[(i + 1) % fan_count_];
      if (faces_[now].corner[1] != faces_[next].corner[0]) return false;
      faces_[now].beside[1] = next;
      faces_[next].beside[2] = now;
    }
    for (int i = 0; i < removed_count_; ++i) free_[free_count_++] = removed_[i];
    return true;
  }

  // Its place is free again only when the fan is closed: until then its neighbours are told by its number.
  void remove(int f) {
    faces_[f].alive = false;
    removed_[removed_count_++] = f;
  }

  // Comes over an edge from the removed face `from`.
  bool visit(int f, int from, int point) {
    Face& face = faces_[f];
    if (!face.alive) return true;
    int entry = 0;
    while (entry < 2 && face.beside[entry] != from) ++entry;
    const double height = face.offset < infinity ? dot(face.normal, points_[point] - points_[face.corner[0]]) : 0;
    if (height > rounding_ || (face.offset == infinity && height == 0)) {
      remove(f);
      return visit(face.beside[(entry + 1) % 3], f, point) && visit(face.beside[(entry + 2) % 3], f, point);
    }
    if (free_count_ == 0 && face_count_ == most_faces) return false;
    const int made = free_count_ > 0 ? free_[--free_count_] : face_count_++;
    fan_[fan_count_++] = made;
    Face& fan = faces_[made];
    fan.corner[0] = face.corner[(entry + 1) % 3], fan.corner[1] = face.corner[entry], fan.corner[2] = point;
    fan.beside[0] = f;
    face.beside[entry] = made;
    measure(fan);
    return true;
  }

  const Convex &a_, &b_;
  const double rounding_;
  double size_ = 0;
  WayOut best_;
  Vec3d points_[most_points];
  Face faces_[most_faces];
  int point_count_ = 0, face_count_ = 0;
  int fan_[most_faces], removed_[most_faces], free_[most_faces];
  int fan_count_ = 0, removed_count_ = 0, free_count_ = 0;
};

// b moved out along the way and a little more: what opens is a gap whose direction is a better way, until no more.
Separation polished(const Convex& a, const Convex& b, WayOut way) {
  const double size = min(a.radius(), b.radius());
  Separation out{-way.depth, -way.normal, {}, {}};
  out.on_a = a.support(way.normal);
  out.on_b = out.on_a - out.normal * out.distance;
  for (int i = 0; i < 4; ++i) {
    const double opening = 0.1 * max(way.depth, 0.0) + 1e-3 * size;
    const Vec3d shift = way.normal * (max(way.depth, 0.0) + opening);
    const Gap g = gap(a, b, shift, -way.normal, infinity);
    if (!g.apart) break;
    const double depth = -core_separation(a, b, g.normal), better = way.depth - depth;
    if (better > 0) way = {-g.normal, depth};
    // The nearest points of the opened gap also where the direction was right already: a support point of a flat side
    // may be any corner of it.
    out = {-way.depth, -way.normal, g.on_a, g.on_a + way.normal * -way.depth};
    if (!(better > 1e-9 * size)) break;  // the next one would be better by the square of the error
  }
  return out;
}

// From that of the cores.
Separation rounded(const Convex& a, const Convex& b, const Separation& core) {
  return {core.distance - a.round - b.round, core.normal, core.on_a - core.normal * a.round,
          core.on_b + core.normal * b.round};
}

Separation between_segments(const Convex& a, const Convex& b) {
  const Vec3d along_a = a.axis() * double(a.geometry->half_length),
              along_b = b.axis() * double(b.geometry->half_length);
  const auto [on_a, on_b] = closest(Segment3{a.at - along_a, a.at + along_a}, Segment3{b.at - along_b, b.at + along_b});
  const double distance = length(on_a - on_b);
  if (distance > 1e-11 * (a.radius() + b.radius()))
    return rounded(a, b, {distance, (on_a - on_b) / distance, on_a, on_b});
  // They cross: out across both, or across the longer one.
  const Vec3d across = cross(along_a, along_b);
  const Vec3d longer = length_squared(along_a) < length_squared(along_b) ? b.axis() : a.axis();
  const Vec3d n = length_squared(across) > 0 ? normalize(across) : any_perpendicular(longer);
  return rounded(a, b, {0, n, on_a, on_b});
}

}

double separation_along(const Convex& a, const Convex& b, const Vec3d& normal) {
  return core_separation(a, b, normal) - a.round - b.round;
}

Separation separation(const Convex& a, const Convex& b, double reach) {
  if (a.thin() && b.thin()) return between_segments(a, b);
  const Gap g = gap(a, b, {}, a.center() - b.center(), reach + a.round + b.round);
  return rounded(
      a, b,
      g.apart ? Separation{g.distance, g.normal, g.on_a, g.on_b} : polished(a, b, Polytope(a, b).shortest_way_out()));
}

}
