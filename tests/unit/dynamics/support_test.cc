// What contacts carry, where statics knows it.
#include "dynamics/support.h"

#include <gtest/gtest.h>

using namespace sudar;

namespace {

Support support(std::uint32_t upper, std::uint32_t lower, std::vector<Vec3> arms_upper, std::vector<Vec3> arms_lower) {
  Support s{.upper = upper, .lower = lower, .count = std::uint32_t(arms_upper.size()), .steepness = 1};
  for (std::size_t k = 0; k < arms_upper.size(); ++k) {
    s.arm_upper[k] = arms_upper[k], s.arm_lower[k] = arms_lower[k], s.carries[k] = true;
  }
  return s;
}
Vec3 at(double x) { return {Real(x), Real(-0.5), 0}; }

std::vector<Support> solve(std::vector<Support> supports, std::vector<Real> weight, std::vector<double> height) {
  std::vector<std::uint32_t> which;
  for (std::uint32_t i = 1; i < weight.size(); ++i) which.push_back(i);
  const std::vector<Real> radius(weight.size(), 1);
  SupportLoads().solve(supports, which, weight, height, radius, {0, 1, 0});
  return supports;
}

constexpr Real near = Real(1e-2);  // a thousandth of the spread softens the answer

}

// A beam with a load a quarter of the way: lever rule.
TEST(Support, ABeamsFeetCarryByTheirArms) {
  const auto s = solve({support(1, 0, {at(-1), at(1)}, {at(0), at(0)}), support(2, 1, {at(0)}, {{Real(0.5), Real(0.5), 0}})},
                       {0, 10, 40}, {0, 1, 2});
  EXPECT_NEAR(s[1].load[0], 40, near * 40);
  EXPECT_NEAR(s[0].load[0], 5 + 10, near * 50);
  EXPECT_NEAR(s[0].load[1], 5 + 30, near * 50);
}

TEST(Support, ATowersLoadsAddUp) {
  std::vector<Support> tower;
  for (std::uint32_t i = 1; i <= 10; ++i) tower.push_back(support(i, i - 1, {at(-1), at(1)}, {at(-1), at(1)}));
  std::vector<double> height;
  for (int i = 0; i <= 10; ++i) height.push_back(i);
  const auto s = solve(tower, std::vector<Real>(11, 3), height);
  for (std::size_t i = 0; i < 10; ++i) EXPECT_NEAR(s[i].load[0] + s[i].load[1], 3 * Real(10 - i), 1e-4);
}

// What hangs in the air together does not weigh on each other, and what topples is not carried.
TEST(Support, OnlyWhatStandsCarries) {
  const auto falling = solve({support(2, 1, {at(-1), at(1)}, {at(-1), at(1)})}, {0, 1, 1}, {0, 5, 6});
  EXPECT_EQ(falling[0].load[0], 0);
  const auto toppling = solve({support(1, 0, {at(0.5), at(1)}, {at(0), at(0)})}, {0, 1}, {0, 1});
  EXPECT_EQ(toppling[0].load[0] + toppling[0].load[1], 0);
}
