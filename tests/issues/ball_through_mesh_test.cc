// A ball of 0.2 m fell through a triangle mesh at 200 m/s, with both solvers: from one sub-step to the next it came
// farther than it is large, and of a surface that is one-sided nothing was left to be seen from behind. Boxes and rods
// did so, too, and from any angle; a thin wall was passed in the same way, and so were two thin bodies by each other.
#include <cmath>

#include "unit/worlds.h"

namespace sudar_test {
namespace {

class BallThroughMesh : public WithEachSolver {};
INSTANTIATE_TEST_SUITE_P(Solvers, BallThroughMesh, each_solver(), solver_name);

TEST_P(BallThroughMesh, StaysInFrontOfASurfaceOfTriangles) {
  std::vector<Vec3> vertices;
  std::vector<std::uint32_t> triangles;
  constexpr std::uint32_t n = 20;
  for (std::uint32_t i = 0; i <= n; ++i) {
    for (std::uint32_t k = 0; k <= n; ++k) {
      vertices.push_back({Real(i) - 10, Real(0.2) * Real((i * 7 + k * 5) % 4), Real(k) - 10});
      if (i == n || k == n) continue;
      const std::uint32_t c = i * (n + 1) + k;
      for (const std::uint32_t v : {c, c + 1, c + n + 1, c + 1, c + n + 2, c + n + 1}) triangles.push_back(v);
    }
  }
  for (const double speed : {200.0, 3000.0}) {
    for (int k = 0; k < 12; ++k) {
      World w(config());
      const Material m{
          .friction_static = Real(0.3), .friction_dynamic = Real(0.3), .restitution = Real(k > 6 ? 0 : 0.5)};
      w.add({.shape = mesh(vertices, triangles), .material = m, .motion = Motion::fixed});
      const double aside = 0.05 * k * speed;
      const double t = 30 / speed;
      const Shape shapes[] = {sphere(Real(0.2)), box({Real(0.4), Real(0.1), Real(0.4)}), capsule(Real(0.05), 1)};
      const Body b = w.add({.shape = shapes[k % 3],
                            .at = {0.37 - aside * t, 30, 0.21},
                            .velocity = {Real(aside), Real(-speed), 0},
                            .spin = {3, Real(k), 20},
                            .mass = 1,
                            .material = m});
      for (int s = 0; s < 60 && std::abs(w[b].center().x) < 9.5 && std::abs(w[b].center().z) < 9.5; ++s) {
        w.step();
        if (std::abs(w[b].center().x) < 9.5) {
          ASSERT_GT(w[b].center().y, -0.3) << speed << " m/s, " << k << ", step " << s;
        }
      }
    }
  }
}

// A disc that spins in the plane of its way, and a wall that is thinner than itself.
TEST_P(BallThroughMesh, StaysInFrontOfAThinWall) {
  const Shape shapes[] = {sphere(Real(0.2)), cylinder(Real(0.2), Real(0.02)), cone(Real(0.1), Real(0.3)),
                          ellipsoid({Real(0.1), Real(0.3), Real(0.05)})};
  for (const Shape& shape : shapes) {
    for (const double speed : {60.0, 700.0, 5000.0}) {
      World w(config());
      w.add({.shape = box({Real(0.01), 20, 20}), .at = {20, 0, 0}, .motion = Motion::fixed});
      const Body b =
          w.add({.shape = shape, .velocity = {Real(speed), Real(speed / 50), 0}, .spin = {1, 2, 40}, .mass = 1});
      const double energy = w[b].kinetic_energy();
      step(w, int(40 / speed * 60) + 5);
      EXPECT_LT(w[b].center().x, 20) << speed << " m/s";
      EXPECT_LE(w[b].kinetic_energy(), energy) << speed << " m/s";
    }
  }
}

}
}
