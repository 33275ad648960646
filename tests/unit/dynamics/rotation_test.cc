// Free rotation: what Euler's equations conserve, and Jacobi's and Poinsot's closed solutions.
#include "dynamics/rotation.h"

#include <gtest/gtest.h>

#include "unit/random.h"
#include "unit/worlds.h"

namespace sudar_test {
namespace {

// A body by its principal moments alone.
struct Top {
  Vec3 inertia;
  Quat orientation{};
  Vec3 angular_momentum, spin;

  Top(const Vec3& moments, const Vec3& spin_at_start)
      : inertia(moments), angular_momentum(scale(moments, spin_at_start)), spin(spin_at_start) {}
  void advance(Real h) {
    const Rotation r =
        rotate_freely(orientation, angular_momentum, inertia, {1 / inertia.x, 1 / inertia.y, 1 / inertia.z}, h);
    orientation = r.orientation, spin = r.spin;
  }
  Vec3 body_spin() const { return rotate_back(orientation, spin); }
  double energy() const { return 0.5 * dot(convert<double>(spin), convert<double>(angular_momentum)); }
};

// V04: I = (1, 2, 3), ω₀ = (.01, 1, .02), about the unstable axis. Jacobi's solution: ω₂ is zero at
// 8.813359544 s + n · 16.5974985 s.
TEST(Rotation, UnstableAxisFlipsWhenJacobiSays) {
  const Real h = Real(1.0 / 240);
  Top top({1, 2, 3}, {Real(0.01), 1, Real(0.02)});
  const double energy = top.energy();
  std::vector<double> zeros;
  double drift = 0;
  for (int i = 1; i <= 60 * 240; ++i) {
    const double before = top.body_spin().y;
    top.advance(h);
    const double after = top.body_spin().y;
    if (before * after < 0) zeros.push_back((i - after / (after - before)) / 240);
    drift = std::max(drift, std::abs(top.energy() / energy - 1));
  }
  ASSERT_EQ(zeros.size(), 4u);
  for (int n = 0; n < 4; ++n) EXPECT_NEAR(zeros[std::size_t(n)], 8.813359544 + 16.5974985 * n, 0.02) << n;
  EXPECT_LT(drift, 1e-5);
}

// V04 at 20 s: the spin in the body's axes and the orientation, to the accuracy of the method.
TEST(Rotation, FollowsJacobisSolution) {
  Top top({1, 2, 3}, {Real(0.01), 1, Real(0.02)});
  for (int i = 0; i < 20 * 1000; ++i) top.advance(Real(0.001));
  expect_near(top.body_spin(), Vec3d{0.084601003, -0.996465087, 0.052463732}, by_precision(1e-3, 1e-5));
  const Quat q = top.orientation;
  const double sign = q.w < 0 ? 1 : -1;
  EXPECT_NEAR(sign * q.w, -0.0555622888, by_precision(1e-3, 1e-5));
  expect_near(Vec3d{sign * q.x, sign * q.y, sign * q.z}, Vec3d{0.996815748, 0.0172940590, -0.0545170845},
              by_precision(1e-3, 1e-5));
}

// V05: a symmetric top's axis circles about L at |L|/I₁.
TEST(Rotation, SymmetricTopPrecesses) {
  for (const int rate : {240, 480}) {
    Top top({2, 2, 3}, {Real(0.3), 0, 5});
    for (int i = 0; i < 4 * rate; ++i) top.advance(Real(1.0 / rate));
    const double tolerance = 1e-4 * 240 * 240 / (rate * rate);  // second order
    expect_near(rotate(top.orientation, Vec3{0, 0, 1}), Vec3d{0.0328311473, 0.0393304327, 0.9986867541},
                tolerance + by_precision(2e-5, 0));
  }
}

// Halving h quarters the error.
TEST(Rotation, IsOfSecondOrder) {
  const auto spin_at_2 = [](int rate) {
    Top top({1, 2, 3}, {1, 2, Real(0.5)});
    for (int i = 0; i < 2 * rate; ++i) top.advance(Real(1.0 / rate));
    return convert<double>(top.body_spin());
  };
  const Vec3d exact = spin_at_2(400);
  const double coarse = length(spin_at_2(10) - exact), fine = length(spin_at_2(20) - exact);
  EXPECT_NEAR(coarse / fine, 4, 0.5);
}

// A spin about a principal axis stays, whatever the axis and the size of the step.
TEST(Rotation, PrincipalAxesKeepTheirSpin) {
  for (const Vec3 spin : {Vec3{3, 0, 0}, Vec3{0, 3, 0}, Vec3{0, 0, 3}}) {
    Top top({1, 2, 3}, spin);
    for (int i = 0; i < 1000; ++i) top.advance(Real(0.01));
    expect_near(top.spin, spin, by_precision(2e-6, 1e-13));
  }
}

// Stiff moments and fast spins: nothing blows up.
TEST(Rotation, ThinBodiesStayFinite) {
  Random random(3);
  for (int k = 0; k < 200; ++k) {
    const Vec3 moments{Real(random.between(1e-5, 1)), 1, Real(random.between(0.5, 1))};
    Top top(moments, convert<Real>(random.direction() * random.between(1, 300)));
    const double energy = top.energy();
    for (int i = 0; i < 240; ++i) top.advance(Real(1.0 / 240));
    ASSERT_TRUE(is_finite(top.spin));
    const double least = 0.5 * double(length_squared(top.angular_momentum)) / double(max_component(moments));
    EXPECT_GE(top.energy(), least * (1 - 1e-4));
    EXPECT_LT(top.energy(), 200 * energy);
  }
}

// In a world: the angular momentum is the state, so it keeps its bits, however the body tumbles.
TEST(FreeBody, AngularMomentumKeepsItsBits) {
  World w(steady(1.0 / 60, 4));
  const Body b = w.add({.shape = box({1, 2, 4}), .velocity = {1, 2, 3}, .spin = {Real(0.1), 5, Real(0.2)}});
  const Vec3 momentum = w[b].angular_momentum();
  const double energy = w[b].kinetic_energy();
  for (int i = 0; i < 3600; ++i) {
    w.step();
    ASSERT_EQ(w[b].angular_momentum(), momentum);
    ASSERT_NEAR(w[b].kinetic_energy() / energy, 1, 1e-4);
  }
  EXPECT_EQ(w[b].velocity(), (Vec3{1, 2, 3}));
  expect_near(w[b].center(), Pos{60, 120, 180}, by_precision(2e-4, 1e-10));
}

// A body that spins about a principal axis turns by ω t: the Cayley map falls short by (ω h)²/12 of it.
TEST(FreeBody, TurnsByItsSpin) {
  World w(steady(1.0 / 60, 4));
  const Body b = w.add({.shape = sphere(1), .spin = {0, 6, 0}});
  step(w, 60);
  const double h = 1.0 / 240, angle = 240 * 2 * std::atan(6 * h / 2);
  const Quat q = w[b].pose().q;
  EXPECT_NEAR(q.y, std::sin(angle / 2), by_precision(1e-5, 1e-12));
  EXPECT_NEAR(q.w, std::cos(angle / 2), by_precision(1e-5, 1e-12));
}

}
}
