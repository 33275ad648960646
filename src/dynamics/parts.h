// Joints are made of parts; each part fills its rows from where the joint is now. A joint is the list of its parts
// (joints.cc), solved as one block. Derivations use the gap c = anchor a − anchor b; directions "of a" turn with body a,
// which adds (ω_a × n)·c to the row n·ċ, hence the arm r_a − c instead of r_a.
#pragma once

#include "dynamics/rows.h"

namespace sudar::inline SUDAR_PRECISION {

// Where a joint is now: world axes.
struct JointFrame {
  Vec3 ra, rb;             // anchors from the centres of mass, m
  Vec3 gap;                // anchor a − anchor b, m
  Mat3 basis_a, basis_b;   // the joint's frame on each body; c0 is its axis
  Quat turn_a, turn_b;     // the same as quaternions
  Real length = 0;         // of a bar
};

// n fixed to body a, or turning with the gap (then it is parallel to the gap and both arms agree).
inline Row linear_row(const JointFrame& f, const Vec3& n, Real error) {
  return {n, cross(f.ra - f.gap, n), cross(f.rb, n), error};
}
inline Row angular_row(const Vec3& n, Real error) { return {{}, n, n, error}; }

struct Point {  // the anchors meet; thesis (3.23)
  static constexpr int rows = 3;
  static void fill(const JointFrame& f, Row* out) {
    for (int k = 0; k < 3; ++k) {
      Vec3 e;
      e[k] = 1;
      out[k] = {e, cross(f.ra, e), cross(f.rb, e), f.gap[k]};
    }
  }
};
struct Slide {  // anchor b stays on the axis of a
  static constexpr int rows = 2;
  static void fill(const JointFrame& f, Row* out) {
    out[0] = linear_row(f, f.basis_a.c1, dot(f.basis_a.c1, f.gap));
    out[1] = linear_row(f, f.basis_a.c2, dot(f.basis_a.c2, f.gap));
  }
};
struct Offset {  // anchor b stays in the plane of a
  static constexpr int rows = 1;
  static void fill(const JointFrame& f, Row* out) { out[0] = linear_row(f, f.basis_a.c0, dot(f.basis_a.c0, f.gap)); }
};
struct Distance {  // thesis (3.22) along the bar: the anchors keep their distance; two anchors in one place have no line between them: any will do
  static constexpr int rows = 1;
  static Vec3 direction(const JointFrame& f) { return length_squared(f.gap) > 0 ? normalize(f.gap) : f.basis_a.c0; }
  static void fill(const JointFrame& f, Row* out) {
    out[0] = linear_row(f, direction(f), length(f.gap) - f.length);
  }
};
struct Align {  // the axes stay parallel
  static constexpr int rows = 2;
  static void fill(const JointFrame& f, Row* out) {
    const Vec3 tilt = cross(f.basis_b.c0, f.basis_a.c0);
    out[0] = angular_row(f.basis_a.c1, dot(f.basis_a.c1, tilt));
    out[1] = angular_row(f.basis_a.c2, dot(f.basis_a.c2, tilt));
  }
};
struct Lock {  // no turning at all
  static constexpr int rows = 3;
  static void fill(const JointFrame& f, Row* out) {
    const Vec3 turn = rotation_vector(f.turn_a * conjugate(f.turn_b));
    for (int k = 0; k < 3; ++k) {
      Vec3 e;
      e[k] = 1;
      out[k] = angular_row(e, turn[k]);
    }
  }
};

// Free coordinates: the row of the coordinate's rate (of b against a) and its value; `angle` says that it wraps.
struct Twist {
  static constexpr bool angle = true;
  static Row row(const JointFrame& f) { return {{}, -f.basis_a.c0, -f.basis_a.c0, 0}; }
  static Real value(const JointFrame& f) {
    const Quat q = conjugate(f.turn_a) * f.turn_b;
    return 2 * atan2(q.x, q.w);
  }
};
struct Travel {
  static constexpr bool angle = false;
  static Row row(const JointFrame& f) { return linear_row(f, -f.basis_a.c0, 0); }
  static Real value(const JointFrame& f) { return -dot(f.basis_a.c0, f.gap); }
};
struct Span {  // the distance between the anchors
  static constexpr bool angle = false;
  static Row row(const JointFrame& f) { return linear_row(f, Distance::direction(f), 0); }
  static Real value(const JointFrame& f) { return length(f.gap); }
};

}
