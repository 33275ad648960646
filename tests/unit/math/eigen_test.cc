#include "math/eigen.h"

#include "unit/random.h"

#include <gtest/gtest.h>

using namespace sudar;
using sudar_test::Random;

namespace {

double largest(const Mat3d& m) {
  return max(max(max_component(abs(m[0])), max_component(abs(m[1]))), max_component(abs(m[2])));
}

void expect_decomposition(const Mat3d& m) {
  const Eigen3 e = eigen_symmetric(m);
  const double size = largest(m);
  EXPECT_LT(largest(e.vectors * Mat3d::diagonal(e.values) * transpose(e.vectors) - m),
            1e-14 * 10 * size + 1e-9 * std::abs(trace(m)) * (e.vectors == Mat3d::identity()));
  EXPECT_LT(largest(transpose(e.vectors) * e.vectors - Mat3d::identity()), 1e-14);
  EXPECT_NEAR(determinant(e.vectors), 1, 1e-14);
}

TEST(Eigen, RandomMatrices) {
  Random random;
  for (int i = 0; i < 10'000; ++i) {
    const Mat3d r = matrix(random.rotation());
    Vec3d values = random.in_cube(10);
    if (i % 3 == 0) values.y = values.x;  // a double eigenvalue
    if (i % 7 == 0) values = scale(values, {1, 1e-8, 1});
    Mat3d m = r * Mat3d::diagonal(values) * transpose(r);
    m = (m + transpose(m)) * 0.5;
    expect_decomposition(m);
    const Eigen3 e = eigen_symmetric(m);
    double sorted[2][3] = {{values.x, values.y, values.z}, {e.values.x, e.values.y, e.values.z}};
    for (auto& s : sorted) std::sort(s, s + 3);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(sorted[0][k], sorted[1][k], 1e-13 * 10);
  }
}

TEST(Eigen, DiagonalKeepsItsAxesInAnyOrder) {
  for (const Vec3d& d : {Vec3d{1, 2, 3}, {3, 1, 2}, {5, 5, 5}, {0, 0, 0}, {2, 7, 2}}) {
    Mat3d m = Mat3d::diagonal(d);
    m[1][0] = m[0][1] = 0.9e-9 * trace(m);
    const Eigen3 e = eigen_symmetric(m);
    EXPECT_EQ(e.vectors, Mat3d::identity());
    EXPECT_EQ(e.values, d);
  }
}

TEST(Eigen, TurnsAsLittleAsItMay) {
  const Quatd small = axis_angle(normalize(Vec3d{1, 2, -1}), 0.1);
  const Mat3d r = matrix(small);
  const Eigen3 e = eigen_symmetric(r * Mat3d::diagonal({3, 1, 2}) * transpose(r));
  EXPECT_LT(largest(e.vectors - r), 1e-13);
  EXPECT_LT(length(e.values - Vec3d{3, 1, 2}), 1e-13);
}

}
