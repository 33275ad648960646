// Spheres and capsules against closed forms and sampling.
#include "support.h"

#include <gtest/gtest.h>

namespace sudar::test {
namespace {

// The least of a convex function on 0…1, by golden sections.
template <class F>
double least(F f) {
  double low = 0, high = 1;
  for (int i = 0; i < 60; ++i) {
    const double third = (high - low) * 0.381966;
    if (f(low + third) < f(high - third)) {
      high -= third;
    } else {
      low += third;
    }
  }
  return f((low + high) / 2);
}

struct Rod {
  Vec3d start, along;
  double radius;
  Rod(const Shape& s, const Transform& t) : radius(s.radius()) {
    const Vec3d half = wide_matrix(t.q) * Vec3d{0, s.half_length(), 0};
    start = wide(t.p) - half, along = half * 2.0;
  }
  Vec3d at(double t) const { return start + along * t; }
};

Shape random_round(Random& random) {
  const Real radius = Real(random.uniform(0.1, 0.6));
  return random.below(3) == 0 ? sphere(radius) : capsule(radius, Real(random.uniform(0.2, 2)));
}

TEST(Round, AgainstEachOther) {
  Random random(1);
  int hits = 0, two = 0;
  for (int i = 0; i < 3000; ++i) {
    const Shape a = random_round(random), b = random_round(random);
    const Transform at_a{random.in_box(0.5), random.turn()};
    const Transform at_b{random.in_box(1), random.below(3) ? random.turn() : at_a.q};
    const Rod ra(a, at_a), rb(b, at_b);
    const double centre = least([&](double s) { return least([&](double t) { return length(ra.at(s) - rb.at(t)); }); });
    const double truth = centre - ra.radius - rb.radius;
    const Manifold m = contact(a, at_a, b, at_b, 0.1);
    if (std::abs(truth - 0.1) > 1e-5) { ASSERT_EQ(m.count > 0, truth < 0.1); }
    if (m.count == 0 || centre < 1e-3) continue;
    ++hits, two += m.count == 2;
    EXPECT_NEAR(lowest_separation(m), truth, 2e-6);
    EXPECT_NEAR(length(m.normal), 1, 1e-6);
    // a lies on the side that the normal points to: moved by the separation it just touches.
    const Transform away{at_a.p - m.normal * Real(truth), at_a.q};
    const Rod moved(a, away);
    EXPECT_NEAR(least([&](double s) { return least([&](double t) { return length(moved.at(s) - rb.at(t)); }); }),
                ra.radius + rb.radius, 2e-3);
    const Manifold swapped = contact(b, at_b, a, at_a, 0.1);
    EXPECT_EQ(swapped.count, m.count);
    EXPECT_NEAR(lowest_separation(swapped), truth, 2e-6);
  }
  EXPECT_GT(hits, 500);
  EXPECT_GT(two, 50);
}

TEST(Round, AgainstHulls) {
  Random random(2);
  int outside = 0, inside = 0, two = 0;
  for (int i = 0; i < 1500 && !testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE(i);
    const Shape a = random_round(random), b = random_hull(random);
    const Transform at_a{random.in_box(1.2), random.turn()}, at_b{random.in_box(0.5), random.turn()};
    const Rod rod(a, at_a);
    const WideHull hull(b, at_b);
    const Manifold m = contact(a, at_a, b, at_b, 0.1);
    const double centre = least([&](double t) { return distance_to_hull(b, hull, rod.at(t)); });
    if (centre > 1e-3) {  // the axis is outside: exact
      const double truth = centre - rod.radius;
      if (std::abs(truth - 0.1) > 1e-4) { ASSERT_EQ(m.count > 0, truth < 0.1); }
      if (m.count == 0) continue;
      ++outside;
      EXPECT_NEAR(lowest_separation(m), truth, 1e-4);
    } else {  // it enters: the least of the ways out, by faces and by edges crossed with it
      ASSERT_GT(m.count, 0);
      ++inside;
      const double way_out = rod.radius - lowest_separation(m) - rod.radius;
      const auto out_along = [&](const Vec3d& n) {
        return hull.farthest(n) - std::min(dot(n, rod.at(0)), dot(n, rod.at(1))) + rod.radius;
      };
      double truth = 1e300;
      for (const Vec3d& n : hull.normals) truth = std::min(truth, out_along(n));
      for (const Vec3d& e : hull.edges) {
        const Vec3d c = cross(e, rod.along);
        if (length(c) <= 1e-9) continue;
        for (const double sign : {1.0, -1.0}) truth = std::min(truth, out_along(c * (sign / length(c))));
      }
      EXPECT_LE(way_out, truth + 1e-4) << "deeper than the true depth";
      EXPECT_NEAR(out_along(wide(m.normal)), truth, 2e-4) << "not the shortest way out";
    }
    two += m.count == 2;
    EXPECT_NEAR(length(m.normal), 1, 1e-6);
    for (const ManifoldPoint& p : points(m)) {  // on the round shape's surface, below an end or between
      const double from_axis = least([&](double t) { return length(rod.at(t) - wide(p.at)); });
      EXPECT_NEAR(from_axis, rod.radius, 2e-3);
    }
  }
  EXPECT_GT(outside, 200);
  EXPECT_GT(inside, 100);
  EXPECT_GT(two, 20);
}

TEST(Round, LyingCapsuleTouchesInTwoPoints) {
  const Shape rod = capsule(Real(0.5), 3), cube = box({2, 2, 2});
  const Transform lying{{0, Real(1.49), 0}, turned({0, 0, 1}, pi / 2)};
  const Manifold on_box = contact(rod, lying, cube, {}, 0.01);
  ASSERT_EQ(on_box.count, 2);
  for (const ManifoldPoint& p : points(on_box)) {
    EXPECT_NEAR(std::abs(p.at.x), 1, 1e-5);  // where the box ends
    EXPECT_NEAR(p.at.y, 0.99, 1e-5);         // on the capsule
    EXPECT_NEAR(p.separation, -0.01, 1e-5);
  }
  EXPECT_NE(on_box.points[0].feature, on_box.points[1].feature);
  const Manifold on_floor = contact(rod, {{0, Real(0.49), 0}, lying.q}, half_space(), {}, 0.01);
  ASSERT_EQ(on_floor.count, 2);
  for (const ManifoldPoint& p : points(on_floor)) EXPECT_NEAR(std::abs(p.at.x), 1.5, 1e-5);
  const Manifold on_rod = contact(rod, lying, rod, {{1, Real(0.49), 0}, turned({0, 0, 1}, -pi / 2)}, 0.01);
  ASSERT_EQ(on_rod.count, 2);  // antiparallel: beside each other from −0.5 to 1.5
  const double x0 = on_rod.points[0].at.x, x1 = on_rod.points[1].at.x;
  EXPECT_NEAR(std::min(x0, x1), -0.5, 1e-5);
  EXPECT_NEAR(std::max(x0, x1), 1.5, 1e-5);
  EXPECT_EQ(contact(rod, {{0, Real(1.99), 0}, {}}, half_space(), {}, 0.01).count, 1);  // standing
}

TEST(Round, SphereOnPlaneAndSphere) {
  const Manifold floor = contact(sphere(2), {{3, Real(1.75), 5}, {}}, half_space(), {});
  ASSERT_EQ(floor.count, 1);
  EXPECT_EQ(floor.points[0].at, (Vec3{3, Real(-0.25), 5}));  // on the sphere
  EXPECT_EQ(floor.points[0].separation, Real(-0.25));
  const Manifold pair = contact(sphere(1), {}, sphere(2), {{0, Real(2.5), 0}, {}});
  ASSERT_EQ(pair.count, 1);
  EXPECT_EQ(pair.points[0].separation, Real(-0.5));
  EXPECT_EQ(pair.points[0].at, (Vec3{0, Real(0.75), 0}));  // half-way
  EXPECT_EQ(pair.normal, (Vec3{0, -1, 0}));
}

}
}
