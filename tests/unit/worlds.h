// Small worlds that many tests start from.
#pragma once

#include <gtest/gtest.h>

#include <sudar/world.h>

namespace sudar_test {

using namespace sudar;

constexpr double by_precision(double in_float, double in_double) { return sizeof(Real) == 4 ? in_float : in_double; }

// Nothing sleeps, one sub-step: what a test counts is what the engine does.
inline Config steady(double dt = 0.01, int substeps = 1) {
  Config c;
  c.dt = dt;
  c.substeps = substeps;
  c.sleep = false;
  return c;
}

// Where bodies sleep.
inline Config sleepy(double dt = 0.01) {
  Config c = steady(dt);
  c.sleep = true;
  return c;
}

// Tests that hold with each solver, as it is by default but that nothing sleeps; instantiated with
// INSTANTIATE_TEST_SUITE_P(Solvers, NAME, each_solver(), solver_name).
class WithEachSolver : public testing::TestWithParam<Solver> {
 protected:
  Config config() const {
    Config c;
    c.solver = GetParam();
    c.sleep = false;
    return c;
  }
};
inline auto each_solver() { return testing::Values(Solver::impulse_2007, Solver::soft_step); }
inline std::string solver_name(const testing::TestParamInfo<Solver>& info) { return names(Solver{})[int(info.param)]; }

inline Body add_floor(World& w, double y = 0, const Material& material = {}) {
  return w.add({.shape = half_space(), .at = {0, y, 0}, .material = material, .motion = Motion::fixed});
}

// A unit cube of 1 kg.
inline BodyDef cube(const Pos& at, const Material& material = {}) {
  return {.shape = box({1, 1, 1}), .at = at, .mass = 1, .material = material};
}

inline void step(World& w, int steps) {
  for (int i = 0; i < steps; ++i) w.step();
}

template <class V, class U>
void expect_near(const V& value, const U& expected, double tolerance) {
  EXPECT_NEAR(double(value.x), double(expected.x), tolerance);
  EXPECT_NEAR(double(value.y), double(expected.y), tolerance);
  EXPECT_NEAR(double(value.z), double(expected.z), tolerance);
}

inline double distance(const Pos& a, const Pos& b) {
  return std::sqrt(square(a.x - b.x) + square(a.y - b.y) + square(a.z - b.z));
}

}
