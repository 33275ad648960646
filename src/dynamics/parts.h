// Joints are made of parts; each part fills its rows from where the joint is now. A joint is the list of its parts
// (joints.cc), solved as one block. Derivations use the gap c = anchor a − anchor b; directions "of a" turn with body
// a, which adds (ω_a × n)·c to the row n·ċ, hence the arm r_a − c instead of r_a.
#pragma once

#include "dynamics/rows.h"

namespace sudar::inline SUDAR_PRECISION {

// Where a joint is now: world axes.
struct JointFrame {
  Vec3 ra, rb;            // anchors from the centres of mass, m
  Vec3 gap;               // anchor a − anchor b, m
  Mat3 basis_a, basis_b;  // the joint's frame on each body; c0 is its axis
  Quat turn_a, turn_b;    // the same as quaternions
  Real length = 0;        // of a bar
  Vec3 reach_a, reach_b;  // of a pulley: anchors from where the rope bends
  Real ratio = 1;         // of a pulley
  Real radius = 0;        // of a reel
};

// n fixed to body a, or turning with the gap (then it is parallel to the gap and both arms agree).
inline Row linear_row(const JointFrame& f, const Vec3& n, Real error) {
  return {n, n, cross(f.ra - f.gap, n), cross(f.rb, n), error};
}
inline Row angular_row(const Vec3& n, Real error) { return {{}, {}, n, n, error}; }

struct Point {  // the anchors meet; thesis (3.23)
  static constexpr int rows = 3;
  static void fill(const JointFrame& f, Row* out) {
    for (int k = 0; k < 3; ++k) {
      Vec3 e;
      e[k] = 1;
      out[k] = {e, e, cross(f.ra, e), cross(f.rb, e), f.gap[k]};
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
struct Distance {  // thesis (3.22) along the bar: the anchors keep their distance; two anchors in one place have no
                   // line between them: any will do
  static constexpr int rows = 1;
  static Vec3 direction(const JointFrame& f) { return length_squared(f.gap) > 0 ? normalize(f.gap) : f.basis_a.c0; }
  static void fill(const JointFrame& f, Row* out) { out[0] = linear_row(f, direction(f), length(f.gap) - f.length); }
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

// Free coordinates: the row of the coordinate's rate (of b against a), its value, and the period after which the value
// repeats, 0: never.
struct Twist {
  static Real period(const JointFrame&) { return Real(2 * pi); }
  static Row row(const JointFrame& f) { return angular_row(-f.basis_a.c0, 0); }
  static Real value(const JointFrame& f) {
    const Quat q = conjugate(f.turn_a) * f.turn_b;
    return 2 * atan2(q.x, q.w);
  }
};
// b's axis d about that of a, u, from a's y. Only what turns d across u counts: the rate is
// (ω × d)·(u × d) / |u × d|² = ω·(u − (u·d) d) / |u × d|².
struct Bearing {
  static Real period(const JointFrame&) { return Real(2 * pi); }
  static Row row(const JointFrame& f) {
    const Vec3 &u = f.basis_a.c0, &d = f.basis_b.c0;
    const Real cosine = dot(u, d),
               sine2 = max(length_squared(cross(u, d)), Real(1e-6));  // one along the other: no angle
    return angular_row((u - d * cosine) * (-1 / sine2), 0);
  }
  static Real value(const JointFrame& f) {
    return atan2(dot(f.basis_b.c0, f.basis_a.c2), dot(f.basis_b.c0, f.basis_a.c1));
  }
};
struct Incline {  // between the two axes
  static Real period(const JointFrame&) { return 0; }
  static Row row(const JointFrame& f) {
    const Vec3 n = cross(f.basis_a.c0, f.basis_b.c0);
    return angular_row(length_squared(n) > 0 ? -normalize(n) : -f.basis_a.c2, 0);
  }
  static Real value(const JointFrame& f) {
    return atan2(length(cross(f.basis_a.c0, f.basis_b.c0)), dot(f.basis_a.c0, f.basis_b.c0));
  }
};
struct Travel {
  static Real period(const JointFrame&) { return 0; }
  static Row row(const JointFrame& f) { return linear_row(f, -f.basis_a.c0, 0); }
  static Real value(const JointFrame& f) { return -dot(f.basis_a.c0, f.gap); }
};
struct Span {  // the distance between the anchors
  static Real period(const JointFrame&) { return 0; }
  static Row row(const JointFrame& f) { return linear_row(f, Distance::direction(f), 0); }
  static Real value(const JointFrame& f) { return length(f.gap); }
};

struct Detour {  // the rope of a pulley
  static Real period(const JointFrame&) { return 0; }
  static Vec3 direction(const Vec3& v) { return length_squared(v) > 0 ? normalize(v) : Vec3{0, 1, 0}; }
  static Row row(const JointFrame& f) {
    const Vec3 along_a = direction(f.reach_a), along_b = direction(f.reach_b) * -f.ratio;  // b's part has a minus sign
    return {along_a, along_b, cross(f.ra, along_a), cross(f.rb, along_b), 0};
  }
  static Real value(const JointFrame& f) { return length(f.reach_a) + f.ratio * length(f.reach_b); }
};
struct Winding {  // the rope of a reel: its free part, and what lies on the axle, r · the angle of the tangent point in
                  // b
  static Real period(const JointFrame& f) { return Real(2 * pi) * f.radius; }
  struct Tangent {
    Vec3 out;    // from the axle's line to where the rope leaves it, length 1
    Vec3 along;  // from there to where it is tied
    Real free;   // m
  };
  static Tangent tangent(const JointFrame& f) {
    const Vec3 n = f.basis_b.c0, across = f.gap - n * dot(n, f.gap);
    const Real distance2 = max(length_squared(across), square(f.radius)), distance = sqrt(distance2);
    const Real free = sqrt(distance2 - square(f.radius));
    const Vec3 c = across * (1 / distance), along = (c * free + cross(n, c) * f.radius) * (1 / distance);
    return {cross(along, n), along, free};
  }
  static Row row(const JointFrame& f) {
    const Tangent t = tangent(f);
    return {t.along, t.along, cross(f.ra, t.along), cross(f.rb + t.out * f.radius, t.along), 0};
  }
  static Real value(const JointFrame& f) {
    const Tangent t = tangent(f);
    return t.free + f.radius * atan2(dot(t.out, f.basis_b.c2), dot(t.out, f.basis_b.c1));
  }
};

}
