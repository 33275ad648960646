// What references are computed with, against values from tables and against each other.
#include "verify/numerics.h"

#include <gtest/gtest.h>

#include <sudar/math.h>

using namespace sudar;
using namespace sudar::verify;

namespace {

TEST(Numerics, EllipticIntegral) {
  // Abramowitz & Stegun, table 17.1.
  EXPECT_NEAR(elliptic_k(0), pi / 2, 1e-15);
  EXPECT_NEAR(elliptic_k(0.5), 1.854074677301372, 1e-14);
  EXPECT_NEAR(elliptic_k(0.99), 3.695637362989875, 1e-13);
}

TEST(Numerics, IncompleteEllipticIntegral) {
  for (double m : {0.0, 0.3, 0.99}) {
    const auto speed = [&](double angle) { return 1 / std::sqrt(1 - m * square(std::sin(angle))); };
    for (double phi : {0.1, 0.8, 1.4}) EXPECT_NEAR(elliptic_f(phi, m), integral(speed, 0, phi), 1e-12);
    EXPECT_NEAR(elliptic_f(pi / 2, m), elliptic_k(m), 1e-12);
  }
}

TEST(Numerics, JacobiFunctionsSolveTheirEquation) {
  const double m = 0.7;
  const Rate law = [&](double, const Vector& y) { return Vector{y[1] * y[2], -y[0] * y[2], -m * y[0] * y[1]}; };
  for (double u : {0.3, 1.0, 2.5, 7.0}) {
    const Vector y = solve_ode(law, 0, {0, 1, 1}, u);
    const Jacobi j = jacobi(u, m);
    EXPECT_NEAR(j.sn, y[0], 1e-9);
    EXPECT_NEAR(j.cn, y[1], 1e-9);
    EXPECT_NEAR(j.dn, y[2], 1e-9);
  }
  EXPECT_NEAR(jacobi(elliptic_k(m), m).sn, 1, 1e-12);
}

TEST(Numerics, Quadrature) {
  EXPECT_NEAR(integral([](double x) { return std::exp(-x * x); }, -8, 8), std::sqrt(pi), 1e-12);
  EXPECT_NEAR(integral([](double x) { return 1 / std::sqrt(x); }, 1e-12, 1), 2 - 2e-6, 1e-9);
}

TEST(Numerics, EquationsOfMotionAndEvents) {
  const Rate pendulum = [](double, const Vector& y) { return Vector{y[1], -std::sin(y[0])}; };
  const Moment quarter = solve_until(pendulum, 0, {2.5, 0}, 100, [](double, const Vector& y) { return -y[0]; });
  EXPECT_NEAR(quarter.t, elliptic_k(std::pow(std::sin(1.25), 2)), 1e-9);
  EXPECT_NEAR(quarter.y[1], -2 * std::sin(1.25), 1e-9);
  EXPECT_THROW(solve_until(pendulum, 0, {0.1, 0}, 100, [](double, const Vector& y) { return y[0] - 1; }), Error);
}

TEST(Numerics, SolutionsThatEnd) {
  const Rate sliding = [](double, const Vector& y) { return Vector{y[1], y[1] > 0 ? -1.0 : 1.0}; };  // rubs to rest
  EXPECT_THROW(solve_ode(sliding, 0, {0, 0.5}, 2), Error);
}

TEST(Numerics, Roots) {
  EXPECT_NEAR(root([](double x) { return x * x * x - 2; }, 0, 2), std::cbrt(2), 1e-14);
  EXPECT_NEAR(root([](double x) { return std::tanh(50 * (x - 0.3)); }, -1, 5), 0.3, 1e-13);
  EXPECT_THROW(root([](double x) { return x * x + 1; }, 0, 1), Error);
}

TEST(Numerics, Feasibility) {
  EXPECT_TRUE(feasible({{1, 1}, {-1, 0}}, {3, -1}));                // x + y ≤ 3, x ≥ 1
  EXPECT_FALSE(feasible({{1, 1}, {-1, 0}, {0, -1}}, {3, -2, -2}));  // x ≥ 2, y ≥ 2
  EXPECT_TRUE(feasible({{1, 1}, {-1, 0}, {0, -1}}, {4, -2, -2}));
}

TEST(Numerics, SlopeAndCrossings) {
  EXPECT_NEAR(slope({{0, 1}, {1, 3}, {2, 5}}), 2, 1e-15);
  Crossings c;
  for (int i = 0; i <= 100; ++i) c.sample(i * 0.1, std::cos(i * 0.1));
  ASSERT_EQ(c.moments().size(), 3u);
  EXPECT_NEAR(c.moments()[1], 1.5 * pi, 1e-4);
}

}
