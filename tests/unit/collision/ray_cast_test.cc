#include "support.h"

#include <gtest/gtest.h>

namespace sudar::test {
namespace {

// How far a point is outside of the shape (negative inside), up to a factor.
double outside(const Shape& s, const Vec3d& p) {
  switch (s.kind()) {
    case ShapeKind::sphere:
      return length(p) - s.radius();
    case ShapeKind::capsule: {
      const double h = s.half_length();
      return length(p - Vec3d{0, std::clamp(p.y, -h, h), 0}) - s.radius();
    }
    case ShapeKind::half_space:
      return p.y;
    case ShapeKind::hull:
      return WideHull(s, {}).height(p);
  }
  return 0;
}

TEST(RayCast, AgreesWithMarching) {
  Random random(1);
  int hits = 0;
  for (int i = 0; i < 1000; ++i) {
    SCOPED_TRACE(i);
    const int kind = i % 4;
    const Shape shape = kind == 0   ? sphere(Real(random.uniform(0.2, 1)))
                        : kind == 1 ? capsule(Real(random.uniform(0.2, 0.6)), Real(random.uniform(0.1, 2)))
                        : kind == 2 ? half_space()
                                    : random_hull(random);
    const Vec3 from = random.in_box(random.below(3) ? 2 : 0.7);
    const Vec3 direction = normalize(random.in_box(1) - from);
    constexpr double reach = 3;
    RayOnGeometry hit;
    const bool found = ray_cast(shape.geometry(), from, direction, Real(reach), hit);
    if (outside(shape, wide(from)) < 0) {
      EXPECT_FALSE(found) << "starts inside";
      continue;
    }
    double deepest = 1e30;  // along the ray, up to the hit if there is one
    const double end = found ? double(hit.distance) : reach;
    for (int k = 0; k <= 600; ++k)
      deepest = std::min(deepest, outside(shape, wide(from) + wide(direction) * (end * k / 600)));
    if (!found) {
      EXPECT_GT(deepest, -1e-5);
      continue;
    }
    ++hits;
    const Vec3d at = wide(from) + wide(direction) * double(hit.distance);
    EXPECT_GT(deepest, -1e-5) << "an earlier entrance was missed";
    EXPECT_NEAR(outside(shape, at), 0, 1e-5);
    EXPECT_NEAR(length(hit.normal), 1, 1e-6);
    EXPECT_LE(dot(hit.normal, direction), 1e-6);
    EXPECT_LT(outside(shape, at - wide(hit.normal) * 1e-3), 0);
    EXPECT_GT(outside(shape, at + wide(hit.normal) * 1e-3), 0);
    EXPECT_FALSE(ray_cast(shape.geometry(), from, direction, hit.distance * Real(0.999), hit)) << "beyond the length";
  }
  EXPECT_GT(hits, 200);
}

TEST(RayCast, FarOriginKeepsDigits) {
  RayOnGeometry hit;
  ASSERT_TRUE(ray_cast(sphere(1).geometry(), {0, 0, 10000}, {0, 0, -1}, 20000, hit));
  EXPECT_NEAR(hit.distance, 9999, 1e-3);
}

TEST(RayCast, AlongTheSidesOfABox) {
  RayOnGeometry hit;
  const Shape cube = box({2, 2, 2});
  EXPECT_FALSE(ray_cast(cube.geometry(), {Real(1.001), 0, -5}, {0, 0, 1}, 10, hit));
  EXPECT_TRUE(ray_cast(cube.geometry(), {Real(0.999), 0, -5}, {0, 0, 1}, 10, hit));
  EXPECT_EQ(hit.distance, 4);
  EXPECT_EQ(hit.normal, (Vec3{0, 0, -1}));
}

}
}
