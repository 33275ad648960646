// A heavy weight on a chain of light links: hanging straight and kicked aside, swinging down from the level, or cracking like
// a whip. Each link swings about its middle the faster, the tauter it is; explicit in its direction, the exact solution of the
// joints was refused there, and the passes that stood in for it let the chain tear itself apart (verify V44: 46 times its
// length).
#include <gtest/gtest.h>
#include <sudar/world.h>

using namespace sudar;

namespace {

struct Chain {
  const char* name;
  int links;
  double weight;  // kg; a link has 1
  bool level;     // else it hangs straight
  double kick;    // m/s, of the weight, sideways
};
void PrintTo(const Chain& c, std::ostream* out) { *out << c.name; }

class TautChain : public testing::TestWithParam<std::tuple<Solver, Chain>> {};

TEST_P(TautChain, HoldsAndMakesNoEnergy) {
  const auto [solver, chain] = GetParam();
  World w({.solver = solver, .sleep = false});
  w.add(Gravity{});
  const Vec3 along = chain.level ? Vec3{1, 0, 0} : Vec3{0, -1, 0};
  const Quat turn = chain.level ? Quat{} : axis_angle(Vec3{0, 0, 1}, Real(-pi / 2));
  const double half = 0.5;
  const auto at = [&](double way) { return Pos{along.x * way, along.y * way, 0}; };
  std::vector<Joint> joints;
  Body last;
  for (int i = 0; i < chain.links; ++i) {
    const Body link = w.add({.shape = box({Real(2 * half), Real(0.1), Real(0.1)}), .at = at(2 * half * i + half), .turn = turn,
                             .mass = 1});
    joints.push_back(i == 0 ? w.join(Ball{.a = link, .at = at(0)}) : w.join(Ball{.a = last, .b = link, .at = at(2 * half * i)}));
    last = link;
  }
  const double reach = 2 * half * chain.links;
  const Body weight = w.add({.shape = sphere(Real(0.3)), .at = at(reach + 0.3), .mass = Real(chain.weight)});
  joints.push_back(w.join(Ball{.a = last, .b = weight, .at = at(reach)}));
  w.set_velocity(weight, {0, 0, Real(chain.kick)}, {});
  const double start = w.energy().total();
  const double scale = (chain.weight + chain.links) * 9.81 * reach;
  for (int i = 0; i < 600; ++i) {
    w.step();
    for (const Joint j : joints) ASSERT_LT(length(w[j].anchor_a() - w[j].anchor_b()), 1e-3 * reach) << "step " << i;
    ASSERT_LT((w.energy().total() - start) / scale, 1e-3) << "step " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Chains, TautChain,
                         testing::Combine(testing::Values(Solver::impulse_2007, Solver::soft_step),
                                          testing::Values(Chain{"hanging", 20, 1000, false, 1e-4},
                                                          Chain{"kicked", 20, 1000, false, 0.2},
                                                          Chain{"heavier", 20, 1e5, false, 0.2},
                                                          Chain{"swinging", 20, 1000, true, 0},
                                                          Chain{"whip", 20, 1, true, 0})));

}
