#include "geometry/primitives.h"

#include "geometry/predicates.h"

#include "unit/random.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace sudar;
using sudar_test::Random;

namespace {

constexpr double tiny = 1e-13;

TEST(Planes, ThroughThreePoints) {
  Random random;
  for (int i = 0; i < 1000; ++i) {
    const Vec3d a = random.in_cube(), b = random.in_cube(), c = random.in_cube(), x = random.in_cube();
    const Plane3 p = Plane3::through(a, b, c);
    for (const Vec3d& v : {a, b, c}) EXPECT_NEAR(p.distance(v), 0, tiny);
    EXPECT_GT(dot(cross(b - a, c - a), p.normal), 0);
    EXPECT_NEAR(p.distance(p.project(x)), 0, tiny);
    EXPECT_NEAR(length(x - p.project(x)), std::abs(p.distance(x)), tiny);
    EXPECT_NEAR(p.flipped().distance(x), -p.distance(x), tiny);
  }
}

TEST(Planes, NormalOfASliver) {
  // Corners 1e-9 off a line; the plain cross product keeps half of the digits.
  const Vec3d a{0.1, 0.2, 0.3}, u{1, 1, 1};
  const Vec3d b = a + u, c = a + u * 0.5 + Vec3d{1e-9, -1e-9, 0};
  const Vec3d v = b - a, w = c - a;
  const Vec3d n = normalize(accurate_cross(v, w));
  EXPECT_LT(std::abs(dot(n, w)), 1e-16 * 2);
  EXPECT_LT(std::abs(dot(n, v)), 1e-16 * 2);
}

TEST(Lines, DistanceAndParameter) {
  const Line3 line{{1, 0, 0}, {0, 2, 0}};
  EXPECT_EQ(line.parameter({5, 6, 0}), 3);
  EXPECT_NEAR(line.distance({4, 9, 4}), 5, tiny);
  EXPECT_EQ(line.at(2), (Vec3d{1, 4, 0}));
}

TEST(Segments, ClosestPointsBeatASearch) {
  Random random;
  for (int i = 0; i < 500; ++i) {
    Segment3 a{random.in_cube(), random.in_cube()}, b{random.in_cube(), random.in_cube()};
    if (i % 5 == 0) b.b = b.a + (a.b - a.a) * random.between(-1, 1);  // parallel
    if (i % 7 == 0) a.b = a.a;                                        // a point
    const auto [p, q] = closest(a, b);
    const double found = length(p - q);
    EXPECT_NEAR(length(a.closest(p) - p), 0, tiny);
    EXPECT_NEAR(length(b.closest(q) - q), 0, tiny);
    for (int k = 0; k <= 400; ++k) EXPECT_LE(found, length(a.at(k / 400.0) - b.closest(a.at(k / 400.0))) + tiny);
  }
  const auto [p, q] = closest({{0, 0, 0}, {1, 0, 0}}, {{0.5, 1, -1}, {0.5, 1, 2}});  // V40
  EXPECT_NEAR(length(p - q), 1, tiny);
}

TEST(Polygons, MeasuresOfARegularOne) {
  Random random;
  for (const int n : {3, 4, 6, 50}) {
    const Quatd q = random.rotation();
    const Vec3d center = random.in_cube(10);
    std::vector<Vec3d> v;
    for (int i = 0; i < n; ++i)
      v.push_back(center + rotate(q, Vec3d{sudar::cos(2 * pi * i / n), sudar::sin(2 * pi * i / n), 0}));
    const Polygon p(v);
    EXPECT_NEAR(p.area(), n / 2.0 * sudar::sin(2 * pi / n), tiny);
    EXPECT_LT(length(p.centroid() - center), tiny);
    EXPECT_LT(length(p.normal() - rotate(q, Vec3d{0, 0, 1})), tiny);
    EXPECT_NEAR(p.plane().distance(center), 0, tiny);
  }
}

TEST(Polygons, ConcaveL) {
  const Polygon l({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}});
  EXPECT_NEAR(l.area(), 3, tiny);
  EXPECT_LT(length(l.centroid() - Vec3d{5.0 / 6, 5.0 / 6, 0}), tiny);
}

TEST(Polygons, TwoClipsShareTheArea) {
  Random random;
  const Polygon square({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  int cut = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec3d n = random.direction();
    const Plane3 plane{n, dot(n, random.in_cube() + Vec3d{0.5, 0.5, 0})};
    const Polygon below = square.clip(plane), above = square.clip(plane.flipped());
    EXPECT_NEAR(below.area() + above.area(), 1, tiny);
    for (const Vec3d& v : below.vertices()) EXPECT_LT(plane.distance(v), tiny);
    cut += !below.vertices().empty() && !above.vertices().empty();
  }
  EXPECT_GT(cut, 100);
  EXPECT_EQ(square.clip({{0, 0, 1}, 0}).area(), 1);  // within the plane: kept
  EXPECT_TRUE(square.clip({{0, 0, 1}, -1}).vertices().empty());
}

TEST(Orientation, SignAndSymmetry) {
  const Vec3d o{}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  EXPECT_EQ(orientation(o, x, y, z), 1);
  EXPECT_EQ(orientation(o, y, x, z), -1);
  EXPECT_EQ(orientation(o, x, y, {7, -3, 0}), 0);
}

// Integers scaled by a power of two: the exact answer is known, the rounded one often is noise.
TEST(Orientation, ExactWhereRoundingDecides) {
  Random random;
  int zeros = 0;
  for (int i = 0; i < 20'000; ++i) {
    const int reach = i % 2 ? 3 : 1000;
    std::int64_t v[4][3];
    for (auto& p : v) {
      for (std::int64_t& c : p) c = random.whole(-reach, reach);
    }
    if (i % 5 == 0) {  // the last in the plane of the others
      for (int k = 0; k < 3; ++k) v[3][k] = v[0][k] + 2 * (v[1][k] - v[0][k]) - 3 * (v[2][k] - v[0][k]);
    }
    std::int64_t e[3][3];
    for (int j = 0; j < 3; ++j) {
      for (int k = 0; k < 3; ++k) e[j][k] = v[j + 1][k] - v[0][k];
    }
    const std::int64_t det = e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
                             e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
                             e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
    // A shift by 2^40 costs no digits of the coordinates, but the differences of products are far below them.
    Vec3d p[4];
    for (int j = 0; j < 4; ++j)
      p[j] = Vec3d{double(v[j][0]), double(v[j][1]), double(v[j][2])} + Vec3d{0x1p40, -0x1p41, 0x1p42};
    const int expected = (det > 0) - (det < 0);
    EXPECT_EQ(orientation(p[0], p[1], p[2], p[3]), expected);
    zeros += expected == 0;
  }
  EXPECT_GT(zeros, 3000);
}

// The next number above or below a coplanar point must be told apart from it.
TEST(Orientation, OneUlpOffThePlane) {
  Random random;
  for (int i = 0; i < 2000; ++i) {
    const double a = random.between(-1, 1), b = random.between(-1, 1);
    // Points with x = z: exactly coplanar whatever their digits.
    const Vec3d p{a, b, a}, q{b, 0.1 + a, b}, r{0.3 * a - b, b * b, 0.3 * a - b}, s{0.7, a * b, 0.7};
    EXPECT_EQ(orientation(p, q, r, s), 0);
    const int above = orientation(p, q, r, {s.x, s.y, 0.7 + 0x1p-53});
    EXPECT_NE(above, 0);
    EXPECT_EQ(orientation(p, q, r, {s.x, s.y, 0.7 - 0x1p-53}), -above);
  }
}

}
