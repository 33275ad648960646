// The sparse factorisation of joints against the matrix itself.
#include "dynamics/joint_system.h"

#include <gtest/gtest.h>

#include <random>

using namespace sudar;

namespace {

// Random rows between random bodies.
struct Net {
  std::vector<SolverBody> bodies;
  std::vector<JointSystem::Joint> joints;
  std::vector<std::vector<PreparedRow>> rows;
  std::mt19937 random{7};

  Real number() { return std::uniform_real_distribution<Real>(-1, 1)(random); }
  Vec3 vec() { return {number(), number(), number()}; }
  explicit Net(std::size_t count) : bodies(count) {
    for (SolverBody& b : bodies) b.inverse_mass = 1 + square(number()), b.inverse_inertia = lanes(Mat3::diagonal({1, 2, 3}));
  }
  void join(std::uint32_t a, std::uint32_t b, int count) {
    joints.push_back({a, b, count});
    const auto body = [&](std::uint32_t i) { return i == JointSystem::nobody ? SolverBody{} : bodies[i]; };
    std::vector<PreparedRow> own;
    for (int r = 0; r < count; ++r) own.push_back({Row{vec(), vec(), vec(), vec()}, body(a), body(b)});
    rows.push_back(own);
  }

  // u that the impulses λ lead to.
  std::vector<std::array<Real, 6>> answer(const std::vector<std::array<Real, 6>>& lambda) const {
    std::vector<Moving> moving(bodies.size());
    Moving ground;
    const auto of = [&](std::uint32_t i) -> Moving& { return i == JointSystem::nobody ? ground : moving[i]; };
    for (std::size_t k = 0; k < joints.size(); ++k) {
      for (std::size_t r = 0; r < rows[k].size(); ++r) rows[k][r].apply(of(joints[k].a), of(joints[k].b), lambda[k][r]);
    }
    ground = {};
    std::vector<std::array<Real, 6>> u(joints.size());
    for (std::size_t k = 0; k < joints.size(); ++k) {
      for (std::size_t r = 0; r < rows[k].size(); ++r) u[k][r] = rows[k][r].speed(of(joints[k].a), of(joints[k].b));
    }
    return u;
  }

  void expect_solved() {
    std::optional<JointSystem> system = JointSystem::plan(joints, 1'000'000);
    ASSERT_TRUE(system);
    std::vector<std::span<const PreparedRow>> spans(rows.begin(), rows.end());
    system->factor(spans);
    std::vector<std::array<Real, 6>> wanted(joints.size());
    for (std::size_t k = 0; k < joints.size(); ++k) {
      for (std::size_t r = 0; r < rows[k].size(); ++r) wanted[k][r] = number();
    }
    std::vector<std::array<Real, 6>> lambda = wanted;
    system->solve(lambda);
    const auto got = answer(lambda);
    for (std::size_t k = 0; k < joints.size(); ++k) {
      for (std::size_t r = 0; r < rows[k].size(); ++r) EXPECT_NEAR(got[k][r], wanted[k][r], 2e-2) << k << " " << r;
    }
  }
};

}

TEST(JointSystem, SolvesAChain) {
  Net net(12);
  net.join(JointSystem::nobody, 0, 3);
  for (std::uint32_t i = 0; i + 1 < 12; ++i) net.join(i, i + 1, i % 2 == 0 ? 3 : 1);
  net.expect_solved();
}

TEST(JointSystem, SolvesATreeHungAtTwoBodies) {
  Net net(10);
  net.join(3, JointSystem::nobody, 1);
  for (std::uint32_t i = 1; i < 10; ++i) net.join(i / 2, i, 3);
  net.join(9, JointSystem::nobody, 1);
  net.expect_solved();
}

TEST(JointSystem, SolvesALoopAndTwoJointsOfOnePair) {
  Net net(6);
  for (std::uint32_t i = 0; i < 6; ++i) net.join(i, (i + 1) % 6, 2);
  net.join(2, 3, 1);
  net.join(5, 2, 1);
  net.expect_solved();
}

TEST(JointSystem, RefusesWhatCostsTooMuch) {
  std::vector<JointSystem::Joint> grid;
  for (std::uint32_t i = 0; i < 400; ++i) {
    if (i % 20 != 19) grid.push_back({i, i + 1, 3});
    if (i < 380) grid.push_back({i, i + 20, 3});
  }
  EXPECT_FALSE(JointSystem::plan(grid, 100'000));
  std::vector<JointSystem::Joint> chain;
  for (std::uint32_t i = 0; i < 400; ++i) chain.push_back({i, i + 1, 3});
  EXPECT_TRUE(JointSystem::plan(chain, 100'000));
}
