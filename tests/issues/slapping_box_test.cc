// Boxes that fell on each other, a little tilted, ended up to a quarter of their edge inside each other (Box3D: 52 mm of
// 1 m). Three causes, all with contacts that are looked at once a step: a box that lands on an edge slaps down within the
// next step, on corners that were none of the four points kept; edges that crossed almost in the plane of a face made a
// contact of one point; and a face whose points lay along one edge was kept while the box turned about that edge.
#include <gtest/gtest.h>
#include <sudar/world.h>

#include <random>

using namespace sudar;

namespace {

// The deepest overlap within 1.7 s of a pile of 16 layers of n × n unit boxes, dropped, m.
double deepest(int n) {
  World w({.solver = Solver::soft_step});
  w.add(Gravity{});
  w.add({.shape = half_space(), .material = {.friction_static = 0.6, .friction_dynamic = 0.6}, .motion = Motion::fixed});
  std::mt19937 random(7);
  const auto tilt = [&] { return Real(0.08 * (double(random()) / 4294967296.0 - 0.5)); };
  for (int k = 0; k < 16 * n * n; ++k) {
    const Quat turn{tilt(), tilt(), tilt(), 1};
    w.add({.shape = box({1, 1, 1}),
           .at = {1.25 * (k % n), 0.6 + 1.2 * (k / n / n), 1.25 * (k / n % n)},
           .turn = normalize(turn),
           .material = {.friction_static = 0.6, .friction_dynamic = 0.6}});
  }
  double most = 0;
  for (int k = 0; k < 100; ++k) {
    w.step();
    most = std::max(most, double(w.quality().penetration_max));
  }
  return most;
}

TEST(SlappingBox, OverlapsLittleInAPile) {
  EXPECT_LT(deepest(2), 0.045);
  EXPECT_LT(deepest(4), 0.045);
}

}
