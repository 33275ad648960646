// Vectors, matrices, quaternions and poses: the identities that define them.
#include "unit/random.h"

#include <gtest/gtest.h>

using namespace sudar;
using sudar_test::Random;

namespace {

constexpr double tiny = 1e-14;  // some tens of roundings of numbers around 1

double largest(const Mat3d& m) {
  return max(max(max_component(abs(m[0])), max_component(abs(m[1]))), max_component(abs(m[2])));
}
Mat3d random_matrix(Random& random) { return {random.in_cube(), random.in_cube(), random.in_cube()}; }
// The angle between two rotations.
double apart(const Quatd& a, const Quatd& b) { return length(rotation_vector(conjugate(a) * b)); }

TEST(Vectors, Products) {
  Random random;
  for (int i = 0; i < 1000; ++i) {
    const Vec3d a = random.in_cube(), b = random.in_cube(), c = random.in_cube();
    EXPECT_NEAR(dot(a, cross(a, b)), 0, tiny);
    EXPECT_NEAR(dot(a, cross(b, c)), dot(b, cross(c, a)), tiny);
    EXPECT_LT(length(cross(a, cross(b, c)) - (b * dot(a, c) - c * dot(a, b))), tiny);
    EXPECT_NEAR(length_squared(cross(a, b)) + square(dot(a, b)), length_squared(a) * length_squared(b), tiny);
    EXPECT_NEAR(length(normalize(a)), 1, tiny);
  }
  EXPECT_EQ(cross(Vec3d{1, 0, 0}, Vec3d{0, 1, 0}), (Vec3d{0, 0, 1}));
  EXPECT_EQ(normalize(Vec3d{}), Vec3d{});
}

TEST(Vectors, AnyPerpendicular) {
  Random random;
  for (int i = 0; i < 1000; ++i) {
    Vec3d n = random.direction();
    if (i < 3) n = {}, n[i] = 1;
    const Vec3d p = any_perpendicular(n);
    EXPECT_NEAR(dot(n, p), 0, tiny);
    EXPECT_NEAR(length(p), 1, tiny);
  }
}

TEST(Vectors, ComponentsAndOrder) {
  const Vec3d a{1, -2, 3}, b{-4, 5, 0.5};
  EXPECT_EQ(min(a, b), (Vec3d{-4, -2, 0.5}));
  EXPECT_EQ(max(a, b), (Vec3d{1, 5, 3}));
  EXPECT_EQ(abs(a), (Vec3d{1, 2, 3}));
  EXPECT_EQ(max_component(b), 5);
  EXPECT_EQ(scale(a, b), (Vec3d{-4, -10, 1.5}));
  EXPECT_EQ(a[0], 1);
  EXPECT_EQ(a[2], 3);
  EXPECT_TRUE(is_finite(a));
  EXPECT_FALSE(is_finite(Vec3d{0, std::numeric_limits<double>::quiet_NaN(), 0}));
}

TEST(Matrices, InverseTransposeDeterminant) {
  Random random;
  for (int i = 0; i < 1000; ++i) {
    const Mat3d a = random_matrix(random), b = random_matrix(random);
    const Vec3d v = random.in_cube(), w = random.in_cube();
    if (std::abs(determinant(a)) > 0.01) { EXPECT_LT(largest(a * inverse(a) - Mat3d::identity()), 1e-12); }
    EXPECT_NEAR(determinant(a * b), determinant(a) * determinant(b), tiny);
    EXPECT_LT(largest(transpose(a * b) - transpose(b) * transpose(a)), tiny);
    EXPECT_NEAR(dot(w, a * v), dot(transpose(a) * w, v), tiny);
    EXPECT_LT(length((a * b) * v - a * (b * v)), tiny);
    EXPECT_LT(length(Mat3d::skew(v) * w - cross(v, w)), tiny);
    EXPECT_LT(length(Mat3d::outer(v, w) * a.c0 - v * dot(w, a.c0)), tiny);
    EXPECT_EQ(trace(Mat3d::diagonal(v)), v.x + v.y + v.z);
  }
}

TEST(Quaternions, RotateLikeTheirMatrices) {
  Random random;
  for (int i = 0; i < 1000; ++i) {
    const Quatd q = random.rotation(), p = random.rotation();
    const Vec3d v = random.in_cube();
    EXPECT_LT(length(rotate(q, v) - matrix(q) * v), tiny);
    EXPECT_LT(length(rotate_back(q, rotate(q, v)) - v), tiny);
    EXPECT_LT(length(rotate(p * q, v) - rotate(p, rotate(q, v))), tiny);
    EXPECT_LT(largest(matrix(p * q) - matrix(p) * matrix(q)), tiny);
    EXPECT_NEAR(determinant(matrix(q)), 1, tiny);
    EXPECT_NEAR(length(rotate(q, v)), length(v), tiny);
  }
}

TEST(Quaternions, RightHanded) {
  const Quatd q = axis_angle(Vec3d{0, 0, 1}, pi / 2);
  EXPECT_LT(length(rotate(q, Vec3d{1, 0, 0}) - Vec3d{0, 1, 0}), tiny);
}

TEST(Quaternions, FromMatrixInEveryBranch) {
  Random random;
  int branch[4] = {};
  for (int i = 0; i < 4000; ++i) {
    Quatd q = random.rotation();
    if (i % 2)
      q = axis_angle(i % 3 == 0   ? Vec3d{1, 0, 0}
                     : i % 3 == 1 ? Vec3d{0, 1, 0}
                                  : Vec3d{0, 0, 1},
                     random.between(3.0, 3.3)) *
          axis_angle(random.direction(), 0.01);
    const Vec3d a = abs(q.vector());
    const double w = std::abs(q.w), m = max_component(a);
    ++branch[w >= m ? 0 : m == a.x ? 1 : m == a.y ? 2 : 3];
    const Quatd back = quaternion(matrix(q));
    EXPECT_NEAR(std::abs(q.x * back.x + q.y * back.y + q.z * back.z + q.w * back.w), 1, tiny);
    EXPECT_LT(largest(matrix(back) - matrix(q)), tiny);
  }
  for (const int count : branch) EXPECT_GT(count, 100);
}

TEST(Quaternions, ExponentialRoundTrip) {
  Random random;
  for (int i = 0; i < 2000; ++i) {
    const Vec3d r = random.direction() * (i % 2 ? random.between(0, pi) : std::exp2(random.between(-100, 0)));
    const Quatd q = rotation(r);
    EXPECT_NEAR(length_squared(q), 1, tiny);
    EXPECT_LT(length(rotation_vector(q) - r), 1e-14 * length(r) + (length(r) > 3 ? 1e-13 : 0)) << length(r);
    // −q is the same rotation.
    EXPECT_LT(length(rotation_vector(Quatd{-q.x, -q.y, -q.z, -q.w}) - r),
              1e-14 * length(r) + (length(r) > 3 ? 1e-13 : 0));
  }
  EXPECT_EQ(rotation(Vec3d{}), Quatd{});
  EXPECT_EQ(rotation_vector(Quatd{}), Vec3d{});
  EXPECT_NEAR(length(rotation_vector(rotation(Vec3d{0, 5, 0}))), 2 * pi - 5, tiny);  // the short way round
}

TEST(Quaternions, RotationsAboutOneAxisAdd) {
  Random random;
  for (int i = 0; i < 1000; ++i) {
    const Vec3d axis = random.direction();
    const double a = random.between(-3, 3), b = random.between(-3, 3);
    EXPECT_LT(apart(axis_angle(axis, a) * axis_angle(axis, b), axis_angle(axis, a + b)), tiny);
  }
}

TEST(Transforms, ComposeAndInvert) {
  Random random;
  const double tolerance = 20 * double(std::numeric_limits<Real>::epsilon());
  for (int i = 0; i < 1000; ++i) {
    const Transform a{convert<Real>(random.in_cube()), convert<Real>(random.rotation())};
    const Transform b{convert<Real>(random.in_cube()), convert<Real>(random.rotation())};
    const Vec3 v = convert<Real>(random.in_cube());
    EXPECT_LT(double(length((a * b).point(v) - a.point(b.point(v)))), tolerance);
    EXPECT_LT(double(length(a.local(a.point(v)) - v)), tolerance);
    EXPECT_LT(double(length(inverse(a).point(a.point(v)) - v)), tolerance);
    EXPECT_LT(double(length((inverse(a) * a).point(v) - v)), tolerance);
    const Pose pose{Pos{} + a.p, a.q};
    EXPECT_LT(double(length(pose.point(v) - (Pos{} + a.point(v)))), tolerance);
    EXPECT_LT(double(length(pose.local(pose.point(v)) - v)), tolerance);
  }
}

TEST(Positions, MoveAsFinelyFarAway) {
  const Pos far{1e9, -1e9, 1e9};
  const Vec3 d{Real(0.001), Real(0.002), Real(-0.003)};
  EXPECT_LT(double(length(((far + d) - far) - d)), 1e-6);
  EXPECT_EQ((far - d) - far, -((far + d) - far));
}

TEST(Boxes, TouchingIsOverlap) {
  const Box a{{0, 0, 0}, {1, 1, 1}}, b{{1, 1, 1}, {2, 2, 2}}, c{{1.001, 0, 0}, {2, 1, 1}}, d{{0.5, 0, 0.5}, {1, 1, 1}};
  EXPECT_TRUE(overlap(a, b) && overlap(b, a));
  EXPECT_FALSE(overlap(a, c) || overlap(c, a));
  EXPECT_TRUE(contains(a, d) && contains(a, a));
  EXPECT_FALSE(contains(d, a) || contains(a, b));
}

}
