// A pile of 20,000 boxes has the same bits with every broad phase.
#include "broad_kinds.h"
#include "unit/random.h"

#include <gtest/gtest.h>

namespace sudar::test {
namespace {

// Boxes of random sizes and turns in loose layers, thrown down on a plate; so few passes that only pairs count.
World pile(Broad kind, int columns, int layers) {
  Config config;
  config.broad = kind;
  config.dt = 0.02;
  config.substeps = 1;
  config.impulse_2007.collision_passes = config.impulse_2007.contact_passes = 2;
  World w(config);
  w.add(Gravity{});
  w.add({.shape = box({200, 2, 200}), .at = {0, -1, 0}, .motion = Motion::fixed});
  sudar_test::Random random(7);
  std::vector<Shape> shapes;
  const auto between = [&](double low, double high) { return Real(random.between(low, high)); };
  for (int i = 0; i < 8; ++i) shapes.push_back(box({between(0.3, 1), between(0.3, 1), between(0.3, 1)}));
  for (int y = 0; y < layers; ++y) {
    for (int x = 0; x < columns; ++x) {
      for (int z = 0; z < columns; ++z) {
        w.add({.shape = shapes[std::size_t(random.whole(0, 7))],
               .at = {double(x) - columns / 2 + between(0, 0.2), 0.6 + y, double(z) - columns / 2 + between(0, 0.2)},
               .turn = convert<Real>(random.rotation()),
               .velocity = {between(-3, 3), -5, between(-3, 3)}});
      }
    }
  }
  return w;
}

TEST(Pile, OfTwentyThousandBoxesHasTheSameBits) {
  std::uint64_t expected = 0;
  for (const Broad kind : broad_kinds()) {
    World w = pile(kind, 40, 13);
    EXPECT_GE(w.bodies().size(), 20000u);
    for (int i = 0; i < 6; ++i) w.step();
    EXPECT_GT(w.profile().contacts, 5000);
    const std::uint64_t hash = hash_without_broad(w);
    if (kind == Broad::brute) expected = hash;
    EXPECT_EQ(hash, expected) << name_of(kind);
  }
}

}
}
