// The moment at which two shapes on their ways meet: conservative advancement (B. Mirtich 1996, §2.3; X. Zhang, M. Lee,
// Y. Kim 2006) on the exact distance of separation.h.
//
// At any time the nearest points give an axis n, of length 1 from b to a, along which the shapes are apart by d. Along
// it they come nearer at most at the rate −n·(v_a − v_b) + Σ |ω × n| R, R being the swing of a shape about the centre
// that it turns about: so nothing can happen for d / rate. How far they are apart along *that* axis then costs two
// support points, no search; only when that, too, has closed is a new axis looked for (as in E. Catto's bilateral
// advancement, GDC 2013, but every step is safe, however fast bodies turn). Where the rate is not positive they never
// meet.
#pragma once

#include <optional>

#include "collision/narrow/separation.h"

namespace sudar::inline SUDAR_PRECISION {

// The way of a body over a stretch of time: a point of it, the pivot, moves straight, and it turns steadily about that.
struct Course {
  double begin = 0;      // s
  Pos from;              // of the pivot, at that time
  Quatd turned;          // body → world, then
  Vec3d velocity, spin;  // m/s; rad/s, world axes
  Vec3 pivot;            // in the body's frame: zero is the centre of mass

  Quatd orientation(double t) const { return normalize(rotation(spin * (t - begin)) * turned); }
  Pos at(double t) const { return from + velocity * (t - begin); }
  Pos center(double t) const { return at(t) - rotate(orientation(t), convert<double>(pivot)); }
  // From one pose to another within `time`. `spin`: about how fast it turns, by which whole turns are told from none.
  static Course between(double begin, const Pose& start, const Pose& end, const Vec3& spin, double time,
                        const Vec3& pivot = {});
};

// A shape of a body on its way.
struct ShapeOnCourse {
  const Geometry* geometry;
  Transform frame;  // shape → body
  Course course;
};

// One of the two, and only one, may be a half space, a hollow or a mesh; of that `triangle` is meant.
class Encounter {
 public:
  Encounter(const ShapeOnCourse& a, const ShapeOnCourse& b, std::uint32_t triangle);

  // Whether balls around them, along the whole way, are ever near each other. Costs next to nothing.
  bool may_meet(double begin, double end, double distance) const;
  // The first time from `begin` to `end` at which they are apart by `least` (negative: overlap) or less, but for
  // `rounding` [m]; the distance at that time lies between the two.
  std::optional<double> first(double begin, double end, double least, double rounding) const;
  // The same, or the first time at which they are seen farther apart than `leave`, if that comes earlier.
  std::optional<double> first_or_left(double begin, double end, double least, double rounding, double leave) const;
  // How far they are apart then, m; negative: overlap.
  double distance(double t) const { return apart(t, std::numeric_limits<double>::infinity()).distance; }
  // Whether it is the business of this triangle, if it is one: a body in front of it that meets its face, or comes over
  // an edge as far as the surface turns there, or whose middle goes through it.
  bool concerns(double begin, double moment, double end) const;
  // The way from b to a at that moment, as the two were given, of length 1; and the middle between their nearest
  // points.
  struct Place {
    Pos at;
    Vec3 normal;
  };
  Place place(double t) const;

 private:
  enum class Other : std::uint8_t { convex, half_space, hollow };

  Convex convex(const ShapeOnCourse&, const Geometry&, double t) const;
  Separation apart(double t, double reach) const;
  double along(double t, const Vec3d& normal) const;
  double closing(const Vec3d& normal) const;
  double fastest() const;
  Vec3d middle(const ShapeOnCourse&, double t) const;
  Vec3d in_mesh(double t) const;

  ShapeOnCourse a_, b_;  // b is what is not convex
  bool exchanged_;
  Other kind_;
  const Geometry* of_b_;  // b's, or the triangle's
  const TriangleMesh* mesh_ = nullptr;
  std::uint32_t triangle_;
};

}
