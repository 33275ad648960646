// Everything in one place: 500 equal boxes at one spot took 5.4 s for the first step, 2000 did not finish it in 50 s.
// Every two overlap, n²/2 contacts; but whoever is deep in many others needs only a few of them to be pushed out. (They
// part faster than anybody would like: how fast overlap is removed has no limit yet.)
#include "broad_kinds.h"
#include "unit/worlds.h"

namespace sudar_test {
namespace {

// n bodies of a kind at one spot; nothing else.
World one_place(int n, const Shape& shape, Broad broad = Broad::tree) {
  Config c;
  c.broad = broad;
  World w(c);
  for (int i = 0; i < n; ++i) w.add({.shape = shape, .at = {0, 3, 0}});
  return w;
}

const Shape kinds[] = {box({1, 1, 1}), sphere(Real(0.5)), box({1, Real(0.5), 2}), cone(Real(0.5), 1)};

TEST(OnePlace, PartsAndLosesNobody) {
  for (const Shape& shape : kinds) {
    World w = one_place(100, shape);
    for (int i = 0; i < 240; ++i) ASSERT_TRUE(w.step().quarantined.empty());
    EXPECT_EQ(w.bodies().size(), 100u);
    EXPECT_LT(double(w.quality().penetration_max), 0.05);
  }
}

// Of 1000 bodies there are half a million pairs, and at most 1000 log₂ 1000 contacts.
TEST(OnePlace, HasFewContacts) {
  Config c;
  c.substeps = 1, c.impulse_2007.correction = 0;  // they stay
  World w(c);
  for (int i = 0; i < 1000; ++i) w.add({.shape = box({1, 1, 1}), .at = {0, 3, 0}});
  for (int i = 0; i < 2; ++i) {
    w.step();
    EXPECT_GT(w.profile().contacts, 1000);
    EXPECT_LT(w.profile().contacts, 1000 * 10);
  }
}

TEST(OnePlace, HasTheSameBitsWhicheverBroadPhase) {
  std::vector<std::uint64_t> hashes;
  for (const Broad broad : broad_kinds()) {
    World w = one_place(60, box({1, 1, 1}), broad);
    step(w, 40);
    hashes.push_back(w.motion_hash());
  }
  for (const std::uint64_t h : hashes) EXPECT_EQ(h, hashes[0]);
}

TEST(OnePlace, GoesOnAfterLoad) {
  World w = one_place(60, box({1, 1, 1})), again;
  step(w, 7);
  again.load(w.save());
  step(w, 20), step(again, 20);
  EXPECT_EQ(again.hash(), w.hash());
}

// What merely lies on each other is no crowd: every contact is there.
TEST(OnePlace, APileIsNone) {
  World w;
  w.add(Gravity{});
  add_floor(w);
  for (int x = 0; x < 4; ++x) {
    for (int y = 0; y < 4; ++y) {
      for (int z = 0; z < 4; ++z) w.add(cube({1.0 * x, 0.5 + y, 1.0 * z}));
    }
  }
  w.step();
  const std::int64_t on_the_floor = 4 * 4, faces = 3 * 3 * 4 * 4;
  EXPECT_GE(w.profile().contacts, on_the_floor + faces);
}

}
}
