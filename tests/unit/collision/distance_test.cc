// The public distance query: V39 and V40 of the catalogue of checks, boxes against an enumeration of their features,
// and the properties that hold for every pair.
#include "curved_oracle.h"

#include <sudar/distance.h>

#include "geometry/primitives.h"

#include <gtest/gtest.h>

namespace sudar::test {
namespace {

Pose at(double x, double y, double z, Quat q = {}) { return {{x, y, z}, q}; }
Vec3d from_origin(const Pos& p) { return {p.x, p.y, p.z}; }

TEST(Distance, V39ClosedForms) {
  const Shape cube = box({1, 1, 1});
  const Quat on_edge = turned({0, 0, 1}, pi / 4), on_vertex = turned({1, 0, -1}, std::acos(1 / std::sqrt(3.0)));
  EXPECT_NEAR(distance(cube, {}, cube, at(0, 2, 0, on_edge)).value, 0.792893218813, 1e-6);
  EXPECT_NEAR(distance(cube, at(0, 0, 0, on_edge), cube, at(0, 2, 0, turned({1, 0, 0}, pi / 4))).value, 0.585786437627,
              1e-6);
  EXPECT_NEAR(distance(cube, {}, cube, at(0, 2, 0, on_vertex)).value, 0.633974596216, 1e-6);
}

TEST(Distance, V40) {
  // Two segments that pass each other at the distance 1, as the axes of capsules.
  const SignedDistance d =
      distance(capsule(Real(0.25), 2), {}, capsule(Real(0.125), 2), at(1, 0.3, 0.2, turned({1, 0, 0}, 1)));
  EXPECT_NEAR(d.value, 1 - 0.375, 1e-7);
  EXPECT_NEAR(length(from_origin(d.on_a) - Vec3d{0.25, d.on_a.y, 0}), 0, 1e-7);

  // The foot of p on an ellipsoid is r² p/(r² + t), with t the root of Σ (r p/(r² + t))² = 1.
  const Vec3d r{1, 2, 3};
  for (const Vec3d& p : {Vec3d{4, 4, 4}, Vec3d{-1, 5, 0.1}, Vec3d{0.2, 0.3, 3.5}}) {
    double low = 0, high = 1000;
    const auto foot = [&](double t) {
      return Vec3d{r.x * r.x * p.x / (r.x * r.x + t), r.y * r.y * p.y / (r.y * r.y + t),
                   r.z * r.z * p.z / (r.z * r.z + t)};
    };
    for (int i = 0; i < 200; ++i) {
      const double t = (low + high) / 2;
      const Vec3d f = foot(t);
      (square(f.x / r.x) + square(f.y / r.y) + square(f.z / r.z) > 1 ? low : high) = t;
    }
    const double truth = length(p - foot(low));
    if (p.y == 4) { EXPECT_NEAR(truth, 4.947517709, 1e-9); }
    const SignedDistance e = distance(ellipsoid({1, 2, 3}), {}, Pos{p.x, p.y, p.z});
    EXPECT_NEAR(e.value, truth, 1e-7);
    EXPECT_LT(length(from_origin(e.on_a) - foot(low)), 1e-5);
    EXPECT_NEAR(distance(ellipsoid({1, 2, 3}), {}, sphere(Real(0.25)), at(p.x, p.y, p.z)).value, truth - 0.25, 1e-6);
  }

  // A cylinder that rests on its rim, tilted by 30°: the centre is at r cos 30° + h/2 sin 30°.
  const Pose tilted = at(0, 0.683012702, 0, turned({0, 0, 1}, pi / 3));
  EXPECT_NEAR(distance(cylinder(Real(0.5), 1), tilted, half_space(), {}).value, 0, 1e-6);
  EXPECT_NEAR(distance(half_space(), {}, cylinder(Real(0.5), 1), tilted).value, 0, 1e-6);
  EXPECT_NEAR(distance(cylinder(Real(0.5), 1), tilted, box({4, 2, 4}), at(0, -1, 0)).value, 0, 1e-6);
}

struct WideBox {
  Vec3d half, at;
  Mat3d turn;
  WideBox(const Vec3& edges, const Pose& p) : half(wide(edges) * 0.5), at(from_origin(p.p)), turn(wide_matrix(p.q)) {}
  Vec3d corner(int i) const {
    return at + turn * scale(half, {i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0});
  }
  double from(const Vec3d& p) const {
    const Vec3d local = transpose(turn) * (p - at);
    return length(local - max(-half, min(half, local)));
  }
};

// The nearest points of boxes that are apart are a corner and any point, or lie on two edges.
double enumerated(const WideBox& a, const WideBox& b) {
  double best = 1e300;
  for (int i = 0; i < 8; ++i) best = std::min({best, a.from(b.corner(i)), b.from(a.corner(i))});
  for (int i = 0; i < 8; ++i) {
    for (int j = 0; j < 8; ++j) {
      for (const int di : {1, 2, 4}) {
        for (const int dj : {1, 2, 4}) {
          if ((i & di) || (j & dj)) continue;
          const auto [p, q] = closest(Segment3{a.corner(i), a.corner(i | di)}, Segment3{b.corner(j), b.corner(j | dj)});
          best = std::min(best, length(p - q));
        }
      }
    }
  }
  return best;
}

TEST(Distance, RandomBoxesAgainstEnumeration) {
  Random random(1);
  int apart = 0, overlapping = 0;
  for (int i = 0; i < 4000; ++i) {
    const auto edge = [&] { return Real(random.uniform(0.1, 2)); };
    const Vec3 ea{edge(), edge(), edge()}, eb{edge(), edge(), edge()};
    const bool square_to = i % 4 == 0;  // parallel faces, edges and corners over each other
    const Transform ta{random.in_box(1), square_to ? Quat{} : random.turn()},
        tb{random.in_box(2), square_to ? Quat{} : random.turn()};
    const Pose pa{{ta.p.x, ta.p.y, ta.p.z}, ta.q}, pb{{tb.p.x, tb.p.y, tb.p.z}, tb.q};
    const Shape a = box(ea), b = box(eb);
    const double sat = oracle_separation({a, ta}, {b, tb});
    const double truth = sat > 0 ? enumerated({ea, pa}, {eb, pb}) : sat;
    (sat > 0 ? apart : overlapping)++;
    const SignedDistance d = distance(a, pa, b, pb);
    EXPECT_NEAR(d.value, truth, 2e-6) << i;
    EXPECT_NEAR(length(from_origin(d.on_a) - from_origin(d.on_b)), std::abs(d.value), 1e-6) << i;
  }
  EXPECT_GT(apart, 1000);
  EXPECT_GT(overlapping, 300);
}

TEST(Distance, TheBoxesOfV39) {
  struct ObbPair {
    double half_a[3], turn_a[3][3], half_b[3], turn_b[3][3], center_b[3], separation;
  };
  const ObbPair pairs[] = {
#include "data/obb_pairs.inc"
  };
  for (const ObbPair& p : pairs) {
    const auto edges = [](const double* h) { return Vec3{Real(2 * h[0]), Real(2 * h[1]), Real(2 * h[2])}; };
    const auto turn = [](const double(*r)[3]) {
      Mat3d m;
      for (int i = 0; i < 3; ++i) m[i] = {r[0][i], r[1][i], r[2][i]};
      return convert<Real>(quaternion(m));
    };
    const Pose pa{{}, turn(p.turn_a)}, pb{{p.center_b[0], p.center_b[1], p.center_b[2]}, turn(p.turn_b)};
    const double truth = p.separation > 0 ? enumerated({edges(p.half_a), pa}, {edges(p.half_b), pb}) : p.separation;
    EXPECT_NEAR(distance(box(edges(p.half_a)), pa, box(edges(p.half_b)), pb).value, truth, 1e-5);
  }
}

// Both points are on the bodies and the planes at right angles to the way between them hold the bodies apart: that
// together proves a distance, whatever the shapes.
TEST(Distance, ProvesItself) {
  Random random(2);
  for (int i = 0; i < 20000; ++i) {
    const Shape a = random_convex(random), b = random_convex(random);
    const Transform ta{random.in_box(1.5), random.turn()}, tb{random.in_box(1.5), random.turn()};
    const Pose pa{{ta.p.x, ta.p.y, ta.p.z}, ta.q}, pb{{tb.p.x, tb.p.y, tb.p.z}, tb.q};
    const SignedDistance d = distance(a, pa, b, pb);
    const Vec3d n = wide(d.normal);
    EXPECT_NEAR(apart_along({a, ta}, {b, tb}, n), d.value, 1e-6) << i;
    const SignedDistance swapped = distance(b, pb, a, pa);
    EXPECT_NEAR(swapped.value, d.value, 1e-6 + 2e-4 * std::max(0.0, -d.value)) << i;
    if (d.value < 0) continue;
    const Vec3d on_a = from_origin(d.on_a), on_b = from_origin(d.on_b);
    EXPECT_NEAR(length(on_a - on_b), d.value, 1e-6) << i;
    EXPECT_LT(distance(a, pa, d.on_a).value, 1e-6) << i;
    EXPECT_LT(distance(b, pb, d.on_b).value, 1e-6) << i;
  }
}

TEST(Distance, FarFromTheOriginKeepsItsDigits) {
  const SignedDistance d = distance(cylinder(1, 2), at(1e8, 5, -1e8), sphere(1), at(1e8 + 3.25, 5, -1e8));
  EXPECT_NEAR(d.value, 1.25, 1e-6);
  EXPECT_NEAR(d.on_a.x, 1e8 + 1, 1e-6);
}

TEST(Distance, PointsInsideAndDegeneratePairs) {
  EXPECT_NEAR(distance(cylinder(1, 4), {}, Pos{0.7, 0, 0}).value, -0.3, 1e-6);
  EXPECT_NEAR(distance(box({2, 4, 6}), {}, Pos{0, 0, 0}).value, -1, 1e-6);
  EXPECT_NEAR(distance(sphere(1), {}, Pos{0, 0, 0}).value, -1, 1e-12);
  EXPECT_NEAR(distance(sphere(1), {}, sphere(2), {}).value, -3, 1e-12);
  EXPECT_NEAR(distance(half_space(), at(0, 1, 0), Pos{0, 5, 0}).value, 4, 1e-12);
  const SignedDistance crossed = distance(capsule(1, 2), {}, capsule(1, 2), at(0, 0, 0, turned({1, 0, 0}, 1)));
  EXPECT_NEAR(crossed.value, -2, 1e-6);
  EXPECT_NEAR(std::abs(crossed.normal.x), 1, 1e-6);
}

TEST(Distance, WhatHasNoneIsRefused) {
  const auto field = [](const Shape& a, const Shape& b, const Pose& pose = {}) {
    try {
      distance(a, pose, b, {});
      return std::string();
    } catch (const Error& e) { return e.field; }
  };
  EXPECT_EQ(field(half_space(), half_space()), "b");
  EXPECT_EQ(field(hollow_sphere(1), sphere(1)), "a");
  EXPECT_EQ(field(sphere(1), Shape{}), "b");
  EXPECT_EQ(field(sphere(1), sphere(1), {{}, {0, 0, 0, 0}}), "a");
}

}
}
