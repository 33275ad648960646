// Random pairs of hulls against separating axes by brute force. SUDAR_ORACLE_PAIRS sets how many (10000).
#include "support.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace sudar::test {
namespace {

int pairs_to_try() {
  const char* n = std::getenv("SUDAR_ORACLE_PAIRS");
  return n ? std::atoi(n) : 10000;
}

constexpr double tolerance = 1e-4;  // × the size of the hulls, which is 1

struct Pair {
  Shape a, b;
  Transform at_a, at_b;
};

// Half of them barely touch, where an error would show; some share axes or are turned by very little.
Pair random_pair(Random& random) {
  Pair p{random_hull(random), random_hull(random), {random.in_box(2), random.turn()}, {}};
  const int turn = random.below(4);
  if (turn < 2 && random.below(2) == 0) p.b = p.a;
  p.at_b.q = turn == 0   ? p.at_a.q
             : turn == 1 ? p.at_a.q * turned(random.direction(), std::pow(10.0, random.uniform(-7, -1)))
             : turn == 2 ? p.at_a.q * turned({0, 1, 0}, random.uniform(0, 6))
                         : random.turn();
  p.at_b.p = p.at_a.p + random.direction() * Real(random.uniform(0, 2.5));
  if (random.below(2) == 0) {
    const double s = oracle_separation({p.a, p.at_a}, {p.b, p.at_b});
    p.at_b.p += normalize(p.at_a.p - p.at_b.p) * Real(s + random.uniform(-0.05, 0.05));
  }
  return p;
}

// Where hulls overlap, the normal is that of the least depth. Across a gap the true normal may be that of two vertices,
// which is no axis of separation by faces and edges; then the normal only has to separate.
void check_points(const Manifold& m, const WideHull& a, const WideHull& b, double truth) {
  EXPECT_NEAR(length(m.normal), 1, 1e-5);
  const double along = separation_along(a, b, -wide(m.normal));
  EXPECT_GE(along, std::min(truth, 0.0) - 2 * tolerance) << "the normal is not that of the least depth";
  EXPECT_GE(lowest_separation(m), along - tolerance) << "deeper than the true depth";
  if (truth < 0) { EXPECT_LE(lowest_separation(m), truth / 2 + 2 * tolerance) << "the deepest place was missed"; }
  for (const ManifoldPoint& p : points(m)) {
    const double widening = std::abs(p.separation) + tolerance;
    EXPECT_LE(a.height(wide(p.at)), widening);
    EXPECT_LE(b.height(wide(p.at)), widening);
  }
}

TEST(HullOracle, ContactExactlyWhereHullsOverlap) {
  Random random(1);
  int touching = 0, gaps = 0;
  for (int i = 0; i < pairs_to_try() && !testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE(i);
    const Pair p = random_pair(random);
    const WideHull a(p.a, p.at_a), b(p.b, p.at_b);
    const double truth = oracle_separation(a, b);
    const Manifold m = contact(p.a, p.at_a, p.b, p.at_b);
    if (truth < -tolerance) { ASSERT_GT(m.count, 0) << "missed, depth " << -truth; }
    if (truth > tolerance) { ASSERT_EQ(m.count, 0) << "phantom, gap " << truth; }
    if (m.count > 0) {
      ++touching;
      check_points(m, a, b, truth);
    }
    // With a margin gaps count too, but only real ones.
    const Manifold near = contact(p.a, p.at_a, p.b, p.at_b, 0.05);
    if (truth < -tolerance) { ASSERT_GT(near.count, 0); }
    if (truth > 0.05 + tolerance) { ASSERT_EQ(near.count, 0); }
    if (near.count > 0) {
      if (truth > 0) {
        ++gaps;
        EXPECT_LT(distance_between(p.a, a, p.b, b), 0.05 + tolerance) << "phantom across a gap";
      }
      check_points(near, a, b, truth);
    }
  }
  EXPECT_GT(touching, pairs_to_try() / 4);
  EXPECT_GT(gaps, pairs_to_try() / 50);
}

// Faces of more corners than the stack holds, nearly parallel edges by the hundred.
TEST(HullOracle, ManySidedHulls) {
  Random random(4);
  const Shape shapes[] = {cylinder(1, Real(0.7), 70), cone(1, 1, 40), truncated_icosahedron(Real(0.4)), box({1, 1, 1})};
  int touching = 0;
  for (int i = 0; i < 40; ++i) {
    SCOPED_TRACE(i);
    const Shape &sa = shapes[random.below(3)], &sb = shapes[random.below(4)];
    const Transform at_a{random.in_box(1), random.turn()};
    Transform at_b{at_a.p + random.direction() * Real(2), random.below(2) ? random.turn() : at_a.q};
    const WideHull a(sa, at_a);
    at_b.p += normalize(at_a.p - at_b.p) * Real(oracle_separation(a, {sb, at_b}) + random.uniform(-0.1, 0.3));
    const WideHull b(sb, at_b);
    const double truth = oracle_separation(a, b);
    const Manifold m = contact(sa, at_a, sb, at_b);
    if (std::abs(truth) > tolerance) { ASSERT_EQ(m.count > 0, truth < 0) << truth; }
    if (m.count > 0) ++touching, check_points(m, a, b, truth);
  }
  EXPECT_GT(touching, 10);
}

// Edge against edge, turned by almost nothing: the cross product is then mostly rounding.
TEST(HullOracle, NearlyParallelEdges) {
  Random random(6);
  int touching = 0;
  for (int i = 0; i < pairs_to_try() / 4; ++i) {
    SCOPED_TRACE(i);
    // A box askew in its frame: no edge has a component that is zero or exact.
    const Vec3 half{Real(random.uniform(0.2, 1)), Real(random.uniform(0.2, 1)), 1};
    const Quat askew = random.turn();
    std::vector<Vec3> corners;
    for (int k = 0; k < 8; ++k) {
      corners.push_back(
          rotate(askew, scale(half, Vec3{Real(k & 1) * 2 - 1, Real(k >> 1 & 1) * 2 - 1, Real(k >> 2) * 2 - 1})));
    }
    const Shape shape = hull(corners);
    const Transform at_a{{}, turned({0, 0, 1}, random.uniform(0.4, 1.2)) * conjugate(askew)};
    Transform at_b{{3, Real(random.uniform(-0.3, 0.3)), Real(random.uniform(-1, 1))},
                   turned(random.direction(), std::pow(10.0, random.uniform(-7, -2))) * at_a.q};
    const WideHull a(shape, at_a);
    for (int k = 0; k < 12; ++k) at_b.p.x -= Real(oracle_separation(a, {shape, at_b}));  // until they touch
    at_b.p.x -= Real(random.uniform(-0.005, 0.01));
    const WideHull b(shape, at_b);
    const double truth = oracle_separation(a, b);
    const Manifold m = contact(shape, at_a, shape, at_b);
    if (std::abs(truth) > tolerance) { ASSERT_EQ(m.count > 0, truth < 0) << truth; }
    if (m.count > 0) ++touching, check_points(m, a, b, truth);
  }
  EXPECT_GT(touching, pairs_to_try() / 16);
}

TEST(HullOracle, CacheChangesNothing) {
  Random random(2);
  for (int i = 0; i < pairs_to_try() / 4; ++i) {
    SCOPED_TRACE(i);
    Pair p = random_pair(random);
    AxisCache warm;
    for (int step = 0; step < 4; ++step) {
      AxisCache cold;
      Manifold with, without;
      collide({&p.a.geometry(), p.at_a}, {&p.b.geometry(), p.at_b}, Real(0.01), warm, with);
      collide({&p.a.geometry(), p.at_a}, {&p.b.geometry(), p.at_b}, Real(0.01), cold, without);
      ASSERT_EQ(with.count, without.count);
      ASSERT_EQ(with.normal, without.normal);
      for (int k = 0; k < with.count; ++k) {
        ASSERT_EQ(with.points[std::size_t(k)].at, without.points[std::size_t(k)].at);
        ASSERT_EQ(with.points[std::size_t(k)].separation, without.points[std::size_t(k)].separation);
        ASSERT_EQ(with.points[std::size_t(k)].feature, without.points[std::size_t(k)].feature);
      }
      p.at_b.p += random.in_box(step == 2 ? 0.5 : 0.01);
      p.at_b.q = p.at_b.q * turned(random.direction(), step == 2 ? 0.5 : 0.01);
    }
    // A cache of another pair, with numbers that this one does not have.
    AxisCache foreign{std::uint32_t(random.below(6)), std::uint32_t(random.below(99)), std::uint32_t(random.below(99))};
    Manifold m;
    collide({&p.a.geometry(), p.at_a}, {&p.b.geometry(), p.at_b}, Real(0.01), foreign, m);
    EXPECT_EQ(m.normal, contact(p.a, p.at_a, p.b, p.at_b, 0.01).normal);
  }
}

TEST(HullOracle, SwappedAndMovedPairsAgree) {
  Random random(3);
  for (int i = 0; i < pairs_to_try() / 4; ++i) {
    SCOPED_TRACE(i);
    const Pair p = random_pair(random);
    const WideHull a(p.a, p.at_a), b(p.b, p.at_b);
    const double truth = oracle_separation(a, b);
    const Manifold m = contact(p.a, p.at_a, p.b, p.at_b), swapped = contact(p.b, p.at_b, p.a, p.at_a);
    const Transform move{random.in_box(3), random.turn()};
    const Manifold moved = contact(p.a, move * p.at_a, p.b, move * p.at_b);
    if (std::abs(truth) < 2 * tolerance) continue;
    ASSERT_EQ(m.count > 0, swapped.count > 0);
    ASSERT_EQ(m.count > 0, moved.count > 0);
    if (m.count == 0) continue;
    EXPECT_NEAR(separation_along(a, b, wide(swapped.normal)), truth, 2 * tolerance);
    EXPECT_NEAR(separation_along(a, b, -wide(rotate_back(move.q, moved.normal))), truth, 2 * tolerance);
    EXPECT_NEAR(length(swapped.normal), 1, 1e-5);
  }
}

}
}
