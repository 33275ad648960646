// What happens a kilometre away changes no bit: every scenario moves alone as it does beside strangers that fly, collapse,
// swing and sleep. Where bodies attract each other from afar every stranger is felt: there they are grains whose pull is
// lost in the rounding of the others' sums.
#include "scenarios/every_scenario.h"

#include <cstring>

using namespace sudar;

namespace {

constexpr int steps = 150;

bool attracts_from_afar(const World& w) {
  for (const ForceId f : w.forces()) {
    if (std::holds_alternative<NBody>(w[f])) return true;
  }
  return false;
}

void add_strangers(World& w) {
  const double x = 1000, z = -200;
  const Filter filter{1u << 30, 1u << 30, 0};  // whatever floor the scenario has, they have their own
  const auto cube = [&](double dx, double y, double dz) {
    return w.add({.shape = box({0.5, 0.5, 0.5}), .at = {x + dx, y, z + dz}, .filter = filter});
  };
  w.add({.shape = box({20, 1, 20}), .at = {x, -50.5, z}, .filter = filter, .motion = Motion::fixed});
  const Pos muzzle{x - 8, -49, z};  // of a bullet
  w.add({.shape = sphere(Real(0.1)), .at = muzzle, .velocity = {60, 0, 0}, .filter = filter});
  for (int k = 0; k < 12; ++k) cube(0.2 * (k % 3), -49 + 0.6 * k, 0.15 * (k % 2));  // a heap
  cube(6, -49.75, 6);  // at rest
  Body above;          // a chain
  for (int k = 0; k < 4; ++k) {
    const Body link = w.add({.shape = sphere(Real(0.2)), .at = {x + k, -40, z + 5}, .filter = filter});
    w.join(Ball{.a = above, .b = link, .at = {x + k - 0.5, -40, z + 5}});
    above = link;
  }
}

// Two grains that meet. They stay in the plane of the planets: above it they would lift what is at a height of exactly
// 0, where nothing is too small to be felt (by 10⁻³⁴ in solar_system).
void add_grains(World& w) {
  const double step = w.config().dt * double(w.config().time_factor);
  for (const double side : {-1.0, 1.0}) {
    w.add({.shape = sphere(1),
           .at = {20000 + 5 * side, 0, 15000},
           .velocity = {Real(-side / step), 0, 0},
           .mass = Real(1e-20)});
  }
}

std::vector<Pose> run(const ScenarioEntry& entry, bool strangers) {
  Session session(entry, {});
  World& w = session.world();
  const std::vector<Body> own = w.bodies();
  if (strangers) attracts_from_afar(w) ? add_grains(w) : add_strangers(w);
  std::vector<Pose> poses;
  for (int i = 0; i < steps; ++i) {
    session.step();
    for (const Body b : own) {
      if (w.alive(b)) poses.push_back(w[b].pose());
    }
  }
  return poses;
}

void same_bits(const ScenarioEntry& entry) {
  const std::vector<Pose> alone = run(entry, false), beside = run(entry, true);
  ASSERT_EQ(alone.size(), beside.size());
  std::size_t different = 0;
  for (std::size_t i = 0; i < alone.size(); ++i) {
    different += std::memcmp(&alone[i].p, &beside[i].p, sizeof alone[i].p) != 0 ||
                 std::memcmp(&alone[i].q, &beside[i].q, sizeof alone[i].q) != 0;
  }
  EXPECT_EQ(different, 0u) << "of " << alone.size() << " poses";
}

}

int main(int argc, char** argv) { return test_every_scenario(argc, argv, same_bits); }
