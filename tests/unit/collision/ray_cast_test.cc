#include "curved_oracle.h"

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
    case ShapeKind::cylinder:
      return std::max(std::hypot(p.x, p.z) - s.radius(), std::abs(p.y) - s.half_length());
    case ShapeKind::cone: {
      const double h = s.half_length(), side = std::hypot(s.radius(), 2 * h);
      const double above = (std::hypot(p.x, p.z) * 2 * h + (p.y - 1.5 * h) * s.radius()) / side;
      return std::max(above, -0.5 * h - p.y);
    }
    case ShapeKind::ellipsoid: {
      const Vec3d r = wide(s.radii());
      return (length(Vec3d{p.x / r.x, p.y / r.y, p.z / r.z}) - 1) * std::min({r.x, r.y, r.z});
    }
    case ShapeKind::hollow_sphere:
      return s.radius() - length(p);
    case ShapeKind::hollow_cylinder:
      return s.radius() - std::hypot(p.x, p.z);  // where it is long enough
    case ShapeKind::mesh:
      break;  // tests/unit/world/mesh_test.cc
  }
  return 0;
}

TEST(RayCast, AgreesWithMarching) {
  Random random(1);
  int hits = 0;
  for (int i = 0; i < 2400; ++i) {
    SCOPED_TRACE(i);
    const int kind = i % 8;
    const Shape shape = kind == 0   ? sphere(Real(random.uniform(0.2, 1)))
                        : kind == 1 ? capsule(Real(random.uniform(0.2, 0.6)), Real(random.uniform(0.1, 2)))
                        : kind == 2 ? half_space()
                        : kind == 3 ? hollow_sphere(Real(random.uniform(0.7, 2)))
                        : kind == 4 ? hollow_cylinder(Real(random.uniform(0.7, 2)), 20)
                        : kind < 7  ? random_curved(random)
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
  EXPECT_GT(hits, 500);
}

TEST(RayCast, FarOriginKeepsDigits) {
  RayOnGeometry hit;
  ASSERT_TRUE(ray_cast(sphere(1).geometry(), {0, 0, 10000}, {0, 0, -1}, 20000, hit));
  EXPECT_NEAR(hit.distance, 9999, 1e-3);
}

TEST(RayCast, APipeIsOpenAtItsEnds) {
  const Shape pipe = hollow_cylinder(1, 2);
  RayOnGeometry hit;
  ASSERT_TRUE(ray_cast(pipe.geometry(), {0, 0, 0}, {1, 0, 0}, 5, hit));
  EXPECT_EQ(hit.distance, 1);
  EXPECT_EQ(hit.normal, (Vec3{-1, 0, 0}));
  EXPECT_FALSE(ray_cast(pipe.geometry(), {0, 0, 0}, {0, 1, 0}, 5, hit));
  EXPECT_FALSE(ray_cast(pipe.geometry(), {0, 0, 0}, normalize(Vec3{1, Real(1.1), 0}), 5, hit));
  EXPECT_FALSE(ray_cast(pipe.geometry(), {3, 0, 0}, {-1, 0, 0}, 1.5, hit)) << "from outside";
}

TEST(RayCast, AlongAConesSideAndAxis) {
  const Shape s = cone(1, 4);  // from y = −1 to 3
  RayOnGeometry hit;
  ASSERT_TRUE(ray_cast(s.geometry(), {0, 10, 0}, {0, -1, 0}, 20, hit));
  EXPECT_NEAR(hit.distance, 7, 1e-5);
  ASSERT_TRUE(ray_cast(s.geometry(), {Real(0.5), -10, 0}, {0, 1, 0}, 20, hit));
  EXPECT_NEAR(hit.distance, 9, 1e-5);
  EXPECT_EQ(hit.normal, (Vec3{0, -1, 0}));
  const Vec3 along = normalize(Vec3{-1, 4, 0});  // a generator's direction
  EXPECT_FALSE(ray_cast(s.geometry(), Vec3{Real(1.1), -1, 0} - along * Real(3), along, 20, hit));
  EXPECT_TRUE(ray_cast(s.geometry(), Vec3{Real(0.9), -1, 0} - along * Real(3), along, 20, hit));
  EXPECT_NEAR(hit.distance, 3, 1e-5);
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
