// Two balls on a bar slide over a floor of triangles. With soft_step islands with joints are left to impulse_2007, sub-step by
// sub-step, but with the contacts of the step's beginning: a triangle that a ball came onto within the step was missing, and the
// ball fell until the next step.
#include <gtest/gtest.h>
#include <sudar/world.h>

using namespace sudar;

namespace {

// A level floor of 40 × 40 squares of half a metre.
Shape floor_of_triangles() {
  constexpr int squares = 40;
  std::vector<Vec3> vertices;
  std::vector<std::uint32_t> triangles;
  for (int i = 0; i <= squares; ++i) {
    for (int j = 0; j <= squares; ++j) vertices.push_back({Real(0.5 * i - 10), 0, Real(0.5 * j - 10)});
  }
  for (std::uint32_t i = 0; i < squares; ++i) {
    for (std::uint32_t j = 0; j < squares; ++j) {
      const std::uint32_t a = i * (squares + 1) + j, b = a + 1, c = a + squares + 1, d = c + 1;
      triangles.insert(triangles.end(), {a, b, d, a, d, c});
    }
  }
  return mesh(vertices, triangles);
}

class JointedOnMesh : public testing::TestWithParam<std::tuple<Solver, double>> {};

TEST_P(JointedOnMesh, FeelsNoInnerEdge) {
  const auto [solver, speed] = GetParam();
  World w({.solver = solver, .sleep = false});
  w.add(Gravity{});
  const Material smooth{.friction_static = 0, .friction_dynamic = 0};
  w.add({.shape = floor_of_triangles(), .material = smooth, .motion = Motion::fixed});
  const Body front = w.add({.shape = sphere(Real(0.2)), .at = {-8, 0.2, 0.13}, .material = smooth});
  const Body back = w.add({.shape = sphere(Real(0.2)), .at = {-9, 0.2, 0.13}, .material = smooth});
  w.join(Bar{.a = front, .b = back, .at_a = {-8, 0.2, 0.13}, .at_b = {-9, 0.2, 0.13}});
  for (int n = 0; n < 60; ++n) w.step();
  for (const Body b : {front, back}) w.set_velocity(b, {Real(speed), 0, Real(0.1 * speed)}, {});
  const double height = w[front].pose().p.y;
  double hop = 0;
  for (int n = 0; n < int(60 * std::min(1.5, 15 / speed)); ++n) {
    w.step();
    for (const Body b : {front, back}) hop = std::max(hop, std::abs(w[b].pose().p.y - height));
  }
  EXPECT_LT(hop, 1e-4);
  EXPECT_NEAR(w[front].velocity().x, speed, 1e-3 * speed);
}

INSTANTIATE_TEST_SUITE_P(Speeds, JointedOnMesh,
                         testing::Combine(testing::Values(Solver::impulse_2007, Solver::soft_step), testing::Values(2.0, 7.0, 20.0)));

}
