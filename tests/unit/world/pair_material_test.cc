// Friction and restitution of two bodies, set for the pair instead of mixed.
#include "unit/worlds.h"

namespace sudar_test {
namespace {

const Material ice{.friction_static = 0, .friction_dynamic = 0};

// Of two sliders one rubs as its material says, the other does not. In either order of the two.
TEST(PairMaterial, IsUsedInsteadOfTheMix) {
  World w(steady());
  w.add(Gravity{});
  const Body ground = add_floor(w);
  const Body rough = w.add(cube({0, 0.5, 0})), smooth = w.add(cube({0, 0.5, 3})), other = w.add(cube({0, 0.5, 6}));
  const Body ball = w.add({.shape = sphere(Real(0.5)), .at = {0, 2, 9}});
  w.set_pair_material(ground, smooth, ice);
  w.set_pair_material(other, ground, ice);
  w.set_pair_material(ball, ground, Material{.restitution = 1});
  EXPECT_EQ(w.pair_material(smooth, ground).friction_static, 0);
  EXPECT_EQ(w.pair_material(rough, ground).friction_static, Material{}.friction_static);
  for (const Body b : {rough, smooth, other}) w.set_velocity(b, {1, 0, 0}, {});
  double highest = 0;
  for (int i = 0; i < 140; ++i) {
    w.step();
    if (i > 80) highest = std::max(highest, w[ball].center().y);
  }
  EXPECT_NEAR(w[rough].velocity().x, 0, 1e-4);
  EXPECT_NEAR(w[smooth].velocity().x, 1, 1e-4);
  EXPECT_NEAR(w[other].velocity().x, 1, 1e-4);
  EXPECT_NEAR(highest, 2, 0.1);
  w.set_pair_material(ground, smooth, {});
  step(w, 100);
  EXPECT_NEAR(w[smooth].velocity().x, 0, 1e-4);
}

// It is state: hashed, saved, and gone without a trace when it is taken back.
TEST(PairMaterial, IsState) {
  World w(steady());
  const Body a = w.add(cube({0, 0, 0})), b = w.add(cube({5, 0, 0})), c = w.add(cube({9, 0, 0}));
  const std::uint64_t before = w.hash();
  w.set_pair_material(c, a, ice);
  const std::uint64_t with = w.hash();
  EXPECT_NE(with, before);
  World restored;
  restored.load(w.save());
  EXPECT_EQ(restored.hash(), with);
  EXPECT_EQ(restored.pair_material(a, c).friction_static, 0);
  w.set_pair_material(a, b, ice);
  w.set_pair_material(b, a, std::nullopt);
  EXPECT_EQ(w.hash(), with);
  w.set_pair_material(a, c, std::nullopt);
  EXPECT_EQ(w.hash(), before);
}

// A new body in the place of a removed one does not inherit it.
TEST(PairMaterial, GoesWithTheBody) {
  World w(steady());
  const Body a = w.add(cube({0, 0, 0})), b = w.add(cube({5, 0, 0}));
  w.set_pair_material(a, b, ice);
  w.remove(b);
  const Body next = w.add(cube({5, 0, 0}));
  ASSERT_EQ(next.index, b.index);
  EXPECT_EQ(w.pair_material(a, next).friction_static, Material{}.friction_static);
}

}
}
