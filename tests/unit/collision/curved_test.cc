// Exact cylinders, cones, ellipsoids and hollows in the narrow phase.
#include "curved_oracle.h"

#include "collision/narrow/separation.h"

#include <sudar/distance.h>

#include <gtest/gtest.h>

namespace sudar::test {
namespace {

constexpr Transform here{};
Transform at(double x, double y, double z, Quat q = {}) { return {{Real(x), Real(y), Real(z)}, q}; }

// --- the signed distance ---

TEST(Separation, IsTheLargestOverAllDirections) {
  Random random(1);
  for (int i = 0; i < 600; ++i) {
    const Shape a = random_convex(random), b = random_curved(random);
    const Transform pa{random.in_box(0.8), random.turn()}, pb{random.in_box(0.8), random.turn()};
    const Separation s = separation({a.geometry(), pa}, {b.geometry(), pb}, 1e9);
    const Solid solid_a(a, pa), solid_b(b, pb);
    // Attained along its normal, and no searched direction does better.
    EXPECT_NEAR(apart_along(solid_a, solid_b, s.normal), s.distance, 1e-7) << i;
    EXPECT_GT(s.distance, true_separation(solid_a, solid_b) - 1e-5) << i;
    EXPECT_NEAR(length(s.normal), 1, 1e-12);
    EXPECT_LT(length(s.on_a - s.on_b - s.normal * s.distance), 1e-5) << i;
  }
}

// --- manifolds ---

Pose pose(const Transform& t) { return {{t.p.x, t.p.y, t.p.z}, t.q}; }

constexpr double pi2 = pi / 2;
const Quat lying = turned({0, 0, 1}, pi2);  // a cylinder along −x

// None missed, no phantom, none too deep, points on both bodies, each with a number of its own.
void expect_sound(const Shape& a, const Transform& pa, const Shape& b, const Transform& pb, double margin) {
  const double truth = separation({a.geometry(), pa}, {b.geometry(), pb}, 1e9).distance;  // tested above
  const double scale = std::min(a.bounding_radius(), b.bounding_radius());
  const double tolerance = 2e-4 * std::abs(truth) + 1e-4 * scale;
  for (const bool swapped : {false, true}) {
    const Manifold m = swapped ? contact(b, pb, a, pa, margin) : contact(a, pa, b, pb, margin);
    if (std::abs(truth - margin) > 1e-6) { ASSERT_EQ(m.count > 0, truth < margin); }
    if (m.count == 0) continue;
    const Vec3d n = wide(m.normal) * (swapped ? -1.0 : 1.0);
    EXPECT_NEAR(length(n), 1, 1e-6);
    EXPECT_GT(apart_along({a, pa}, {b, pb}, n), truth - tolerance);
    EXPECT_GT(lowest_separation(m), truth - tolerance);
    EXPECT_LT(lowest_separation(m), truth < 0 ? truth / 2 + 2e-4 * scale : truth + tolerance);
    std::vector<std::uint32_t> numbers;
    for (const ManifoldPoint& p : points(m)) {
      EXPECT_LT(p.separation, margin);
      // Both surfaces are no farther than the separation.
      const Pos place{p.at.x, p.at.y, p.at.z};
      const double reach = std::abs(p.separation) + 2e-3 * scale;
      EXPECT_LT(distance(a, pose(pa), place).value, reach);
      EXPECT_LT(distance(b, pose(pb), place).value, reach);
      EXPECT_EQ(std::count(numbers.begin(), numbers.end(), p.feature), 0);
      numbers.push_back(p.feature);
    }
  }
}

TEST(Curved, RandomPairsAreSound) {
  Random random(2);
  for (int i = 0; i < 3000; ++i) {
    SCOPED_TRACE(i);
    const Shape a = random_convex(random), b = random_curved(random);
    const Transform pa{random.in_box(0.8), random.turn()}, pb{random.in_box(0.8), random.turn()};
    expect_sound(a, pa, b, pb, i % 2 ? 0.05 : 0);
  }
}

// Axes parallel or square to each other, or nearly so, and touching: where faces, sides and edges lie on each other.
TEST(Curved, SquareAndAlmostSquarePairsAreSound) {
  Random random(3);
  const auto turn = [&] {
    const Quat squares[] = {{}, turned({1, 0, 0}, pi2), lying};
    const double off = random.below(2) ? 0 : std::pow(10, -random.uniform(1, 7));
    const Quat square = squares[random.below(3)];
    return turned(random.direction(), off) * square;
  };
  for (int i = 0; i < 3000; ++i) {
    SCOPED_TRACE(i);
    const Shape a = random_convex(random), b = random_curved(random);
    const Transform pa{{}, turn()};
    Transform pb{random.in_box(random.below(2) ? 0 : 0.4), turn()};
    pb.p[random.below(3)] += Real(random.below(2) ? 0.3 : -0.3);
    const Separation s = separation({a.geometry(), pa}, {b.geometry(), pb}, 1e9);
    pb.p += convert<Real>(s.normal * (s.distance - random.uniform(-0.02, 0.012)));
    expect_sound(a, pa, b, pb, 0.01);
  }
}

// Story: on a large floor the points were a corner of the floor, where the direction had been exact from the start, and
// ellipsoids fell through.
TEST(Curved, OnALargeFloorPointsAreWhereTheBodyIs) {
  Random random(3);
  const Shape floor = box({40, 2, 40});
  for (int i = 0; i < 1000; ++i) {
    const Shape s = random_curved(random);
    const Quat q = random.turn();
    const double height = distance(s, {{}, q}, half_space(), {}).value;
    const Transform t = at(random.uniform(-9, 9), 1 - height - random.uniform(0, 0.01), random.uniform(-9, 9), q);
    const Manifold m = contact(s, t, floor, here, 0.01);
    ASSERT_GT(m.count, 0);
    EXPECT_NEAR(m.normal.y, 1, 1e-6);
    for (const ManifoldPoint& p : points(m)) {
      EXPECT_LT(distance(s, pose(t), Pos{p.at.x, p.at.y, p.at.z}).value, std::max(0.0, double(p.separation)) + 1e-5);
    }
  }
}

TEST(Curved, ACylinderStandsOnFourPointsOfItsRim) {
  const Shape can = cylinder(Real(0.5), 2);
  const struct {
    Shape floor;
    double top;
  } floors[] = {{half_space(), 0}, {box({4, 2, 4}), 1}, {cylinder(2, 2), 1}};
  for (const auto& f : floors) {
    const Manifold m = contact(can, at(0, f.top + 0.999, 0), f.floor, here, 0.01);
    ASSERT_EQ(m.count, 4);
    EXPECT_NEAR(m.normal.y, 1, 1e-6);
    for (const ManifoldPoint& p : points(m)) {
      EXPECT_NEAR(p.separation, -0.001, 1e-6);
      EXPECT_NEAR(std::hypot(p.at.x, p.at.z), 0.5, 1e-6);
      EXPECT_NEAR(p.at.y, f.top, 2e-3);
    }
  }
}

TEST(Curved, ACanOverTheEdgeOfABox) {
  // The can's centre is .3 from the box's edge x = 1: half of its rim, and the two crossings of the edge.
  const Manifold m = contact(cylinder(Real(0.5), 2), at(0.8, 1.999, 0), box({2, 2, 6}), here, 0.01);
  ASSERT_EQ(m.count, 4);
  double right = -1, left = 9;
  for (const ManifoldPoint& p : points(m)) {
    EXPECT_LE(p.at.x, 1.0001);
    EXPECT_LE(std::hypot(p.at.x - 0.8, p.at.z), 0.5001);
    right = std::max(right, double(p.at.x)), left = std::min(left, double(p.at.x));
  }
  EXPECT_NEAR(right, 1, 1e-5);
  EXPECT_NEAR(left, 0.3, 1e-5);
  // On a post thinner than itself: the post's corners.
  const Manifold post = contact(cylinder(1, 2), at(0.1, 1.999, 0), box({1, 2, 1}), here, 0.01);
  ASSERT_EQ(post.count, 4);
  for (const ManifoldPoint& p : points(post)) EXPECT_NEAR(std::abs(p.at.x) + std::abs(p.at.z), 1, 1e-5);
}

TEST(Curved, EqualCansOnEachOther) {
  const Shape can = cylinder(1, 2);
  for (const double turn : {0.0, 0.3, 1.0}) {
    const Manifold m = contact(can, here, can, at(0, 1.999, 0, turned({0, 1, 0}, turn)), 0.01);
    ASSERT_EQ(m.count, 4);
    for (const ManifoldPoint& p : points(m)) EXPECT_NEAR(p.separation, -0.001, 1e-5);
  }
  // Beside each other: the lens between the tips (.5, ±√.75).
  const Manifold lens = contact(can, here, can, at(1, 1.999, 0), 0.01);
  ASSERT_EQ(lens.count, 4);
  double tips = 0;
  for (const ManifoldPoint& p : points(lens)) {
    EXPECT_LE(std::hypot(p.at.x, p.at.z), 1.0001);
    EXPECT_LE(std::hypot(p.at.x - 1, p.at.z), 1.0001);
    tips = std::max(tips, std::abs(double(p.at.z)));
  }
  EXPECT_NEAR(tips, std::sqrt(0.75), 1e-5);
}

TEST(Curved, ALyingCylinderTouchesAlongALine) {
  const Shape roller = cylinder(Real(0.5), 2);
  const Shape floors[] = {half_space(), box({6, 2, 6}), cylinder(4, 2)};
  for (const Shape& floor : floors) {
    const double top = floor.kind() == ShapeKind::half_space ? 0 : 1;
    for (const double spin : {0.0, 0.4, 2.0}) {
      const Quat q = lying * turned({0, 1, 0}, spin);
      const Manifold m = contact(roller, at(0.2, top + 0.4995, 0.1, q), floor, here, 0.01);
      ASSERT_EQ(m.count, 2);
      for (const double x : {-0.8, 1.2}) {
        const bool found = length(points(m)[0].at - Vec3{Real(x), Real(top - 0.0005), Real(0.1)}) < 1e-5 ||
                           length(points(m)[1].at - Vec3{Real(x), Real(top - 0.0005), Real(0.1)}) < 1e-5;
        EXPECT_TRUE(found) << "on the roller's own surface";
      }
      EXPECT_NEAR(points(m)[0].separation, -0.0005, 1e-6);
      EXPECT_NE(points(m)[0].feature, points(m)[1].feature);
    }
  }
  // Over the edge of a table: the line ends at the edge.
  const Manifold over = contact(roller, at(2.5, 1.4995, 0, lying), box({6, 2, 6}), here, 0.01);
  ASSERT_EQ(over.count, 2);
  EXPECT_NEAR(std::max(points(over)[0].at.x, points(over)[1].at.x), 3, 1e-5);
  // Two beside each other, and across.
  const Manifold two = contact(roller, at(0, 0, 0, lying), roller, at(0.5, 0.999, 0, lying), 0.01);
  ASSERT_EQ(two.count, 2);
  EXPECT_NEAR(std::abs(points(two)[0].at.x - points(two)[1].at.x), 1.5, 1e-5);
  const Manifold across =
      contact(roller, at(0, 0, 0, lying), roller, at(0.2, 0.999, 0.3, turned({1, 0, 0}, pi2)), 0.01);
  ASSERT_EQ(across.count, 1);
  EXPECT_LT(length(points(across)[0].at - Vec3{Real(0.2), Real(0.4995), 0}), 1e-4);
}

TEST(Curved, AConeOnItsBaseItsSideAndItsTip) {
  const Shape s = cone(1, 4);  // from y = −1 to 3
  for (const Shape& floor : {half_space(), box({10, 2, 10})}) {
    const double top = floor.kind() == ShapeKind::half_space ? 0 : 1;
    EXPECT_EQ(contact(s, at(0, top + 0.999, 0), floor, here, 0.01).count, 4);
    // Its side makes the angle atan(1/4) with the axis; the middle of mass is 3/4 of the way down.
    const double angle = std::atan2(1.0, 4.0), height = 3 * std::sin(angle);
    const Manifold side = contact(s, at(0, top + height - 0.001, 0, turned({0, 0, 1}, pi2 + angle)), floor, here, 0.01);
    ASSERT_EQ(side.count, 2);
    EXPECT_NEAR(side.points[0].separation, -0.001, 1e-5);
    EXPECT_NEAR(side.points[1].separation, -0.001, 1e-5);
    EXPECT_NEAR(length(side.points[0].at - side.points[1].at), std::sqrt(17.0), 1e-4);
    const Manifold tip = contact(s, at(0, top + 2.999, 0, turned({0, 0, 1}, pi)), floor, here, 0.01);
    ASSERT_EQ(tip.count, 1);
    EXPECT_LT(length(tip.points[0].at - Vec3{0, Real(top - 0.001), 0}), 1e-5);
  }
}

TEST(Curved, PointsOfContactAreOnTheRoundSurface) {
  const Manifold egg = contact(ellipsoid({1, 2, 3}), at(0, 2.95, 0), box({4, 2, 4}), here, 0.01);
  ASSERT_EQ(egg.count, 1);
  EXPECT_LT(length(egg.points[0].at - Vec3{0, Real(0.95), 0}), 1e-5);
  const Manifold ball = contact(sphere(1), at(0.3, 1.95, 0), cylinder(4, 2), here, 0.01);
  ASSERT_EQ(ball.count, 1);
  EXPECT_LT(length(ball.points[0].at - Vec3{Real(0.3), Real(0.95), 0}), 1e-5);
  const Manifold tilted =
      contact(cylinder(1, Real(0.1)), at(0, std::sin(1.0) + 0.05 * std::cos(1.0) - 0.01, 0, turned({0, 0, 1}, 1)),
              half_space(), here, 0.01);
  ASSERT_EQ(tilted.count, 1);
  EXPECT_NEAR(tilted.points[0].at.y, -0.01, 1e-5);
}

// A wobbling coin's lowest point is a point of the circle, whatever the angle about the axis.
TEST(Curved, AWobblingCoinTouchesWhereItIsLowest) {
  const Shape coin = cylinder(1, Real(0.1));
  for (const double tilt : {1e-3, 0.01, 0.04, 0.1, 0.5}) {
    for (int k = 0; k < 16; ++k) {
      const double turn = k * 0.39;
      const Vec3 axis{Real(std::cos(turn)), 0, Real(std::sin(turn))};
      const Transform t =
          at(0, 0.05 * std::cos(tilt) + std::sin(tilt) - 0.001, 0, turned(axis, tilt) * turned({0, 1, 0}, k));
      for (const Shape& floor : {half_space(), cylinder(3, 2)}) {
        const double top = floor.kind() == ShapeKind::half_space ? 0 : 1;
        const Manifold m = contact(coin, {t.p + Vec3{0, Real(top), 0}, t.q}, floor, here, 0.0005);
        ASSERT_GE(m.count, 1);
        EXPECT_NEAR(lowest_separation(m), -0.001, 1e-4 * tilt + 2e-6) << tilt;
      }
    }
  }
}

std::vector<std::uint32_t> features(const Manifold& m) {
  std::vector<std::uint32_t> f;
  for (const ManifoldPoint& p : points(m)) f.push_back(p.feature);
  std::sort(f.begin(), f.end());
  return f;
}

TEST(Curved, FeaturesSurviveSmallMotion) {
  Random random(5);
  const Shape can = cylinder(1, 2), brick = box({4, 2, 4});
  const Transform rests[] = {at(0, 1.99, 0), at(1.7, 1.99, 0), at(0, 1.99, 0, lying), at(2, 1.99, 0.3, lying)};
  for (const Transform& r : rests) {
    const auto expected = features(contact(can, r, brick, here, 0.05));
    ASSERT_GE(expected.size(), 2u);
    EXPECT_EQ(std::adjacent_find(expected.begin(), expected.end()), expected.end()) << "each its own";
    for (int i = 0; i < 200; ++i) {
      const Transform moved{r.p + random.in_box(1e-4), turned(random.direction(), random.uniform(0, 1e-5)) * r.q};
      EXPECT_EQ(features(contact(can, moved, brick, here, 0.05)), expected);
    }
  }
}

TEST(Curved, BodiesInTheSamePlaceAndDegenerateOnes) {
  const Shape shapes[] = {cylinder(1, 2),
                          cone(1, 2),
                          ellipsoid({1, 2, 3}),
                          cylinder(1, Real(1e-3)),
                          cone(Real(1e-3), 2),
                          ellipsoid({1, 1, Real(1e-3)}),
                          sphere(1),
                          capsule(1, 1),
                          box({1, 2, 3}),
                          half_space()};
  for (const Shape& a : shapes) {
    for (const Shape& b : shapes) {
      if (a.kind() == ShapeKind::half_space && b.kind() == ShapeKind::half_space) continue;
      for (const Transform& t : {here, at(0, 1e-20, 0), at(1e-4, 0, 0), at(0, 0, 0, lying)}) {
        const Manifold m = contact(a, here, b, t);
        ASSERT_GT(m.count, 0) << int(a.kind()) << ' ' << int(b.kind());
        EXPECT_NEAR(length(m.normal), 1, 1e-6);
        for (const ManifoldPoint& p : points(m)) EXPECT_TRUE(is_finite(p.at) && std::isfinite(p.separation));
      }
    }
  }
}

TEST(Curved, SizesFarApart) {
  const Shape pin = cylinder(Real(1e-3), Real(2e-3)), ground = cylinder(1000, 2000);
  const Manifold m = contact(ground, at(0, -1000, 0), pin, at(300, 0.0009, 200), Real(1e-3));
  ASSERT_EQ(m.count, 4);
  EXPECT_NEAR(m.normal.y, -1, 1e-6);
  EXPECT_NEAR(lowest_separation(m), -1e-4, 1e-6);
}

// --- hollows ---

TEST(Hollow, ASphereInABowl) {
  Random random(6);
  for (int i = 0; i < 500; ++i) {
    const Transform bowl{random.in_box(1), random.turn()};
    const Vec3 out = random.direction();
    const double gap = random.uniform(-0.1, 0.1);
    const Transform ball{bowl.p + out * Real(1 - 0.2 - gap), random.turn()};
    const Manifold m = contact(sphere(Real(0.2)), ball, hollow_sphere(1), bowl, 0.05);
    ASSERT_EQ(m.count, gap < 0.05 ? 1 : 0);
    if (m.count == 0) continue;
    EXPECT_LT(length(m.normal + out), 1e-5);
    EXPECT_NEAR(m.points[0].separation, gap, 1e-5);
    EXPECT_LT(length(m.points[0].at - (ball.p + out * Real(0.2))), 1e-5);
    EXPECT_LT(length(contact(hollow_sphere(1), bowl, sphere(Real(0.2)), ball, 0.05).normal - out), 1e-5);
  }
  EXPECT_EQ(contact(sphere(Real(0.2)), at(1.1, 0, 0), hollow_sphere(1), here, 0.05).count, 0) << "from outside";
}

TEST(Hollow, ASphereInAPipeAndOnItsRim) {
  const Shape pipe = hollow_cylinder(1, 4), ball = sphere(Real(0.2));
  const Manifold wall = contact(ball, at(0.81, 1, 0), pipe, here, 0.05);
  ASSERT_EQ(wall.count, 1);
  EXPECT_NEAR(wall.normal.x, -1, 1e-6);
  EXPECT_NEAR(wall.points[0].separation, -0.01, 1e-6);
  const Manifold rim = contact(ball, at(0.9, 2.1, 0), pipe, here, 0.05);
  ASSERT_EQ(rim.count, 1);
  EXPECT_LT(length(rim.normal - normalize(Vec3{-1, 1, 0})), 1e-5);
  EXPECT_NEAR(rim.points[0].separation, std::sqrt(0.02) - 0.2, 1e-6);
  EXPECT_EQ(contact(ball, here, pipe, here, 0.05).count, 0);
  EXPECT_EQ(contact(ball, at(0.5, 3, 0), pipe, here, 0.05).count, 0);
}

}
}
