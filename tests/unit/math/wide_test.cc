// Numbers side by side: each lane is a problem of its own.
#include "math/wide.h"

#include <gtest/gtest.h>

using namespace sudar;

namespace {

template <int W>
void goes_there_and_back() {
  alignas(64) Real places[16][4], back[16][4] = {};
  for (int lane = 0; lane < 16; ++lane) {
    for (int k = 0; k < 4; ++k) places[lane][k] = Real(10 * lane + k);
  }
  const wide::Fours<W> f = wide::load<W>([&](int lane) { return static_cast<const void*>(places[15 - lane]); });
  for (int lane = 0; lane < W; ++lane) {
    EXPECT_EQ(f.x[lane], places[15 - lane][0]);
    EXPECT_EQ(f.w[lane], places[15 - lane][3]);
  }
  wide::store<W>(f, [&](int lane, const Wide<4>& four) {
    for (int k = 0; k < 4; ++k) back[15 - lane][k] = four[k];
  });
  for (int lane = 0; lane < W; ++lane) {
    for (int k = 0; k < 4; ++k) EXPECT_EQ(back[15 - lane][k], places[15 - lane][k]) << W << ' ' << lane << ' ' << k;
  }
}

template <int W>
void roots_are_exact() {
  Wide<W> x{};
  for (int lane = 0; lane < W; ++lane) x[lane] = Real(0.37) * Real(lane);
  const Wide<W> r = wide::root(x);
  for (int lane = 0; lane < W; ++lane) EXPECT_EQ(r[lane], sqrt(x[lane]));
}

template <int W>
void any_sees_each_lane() {
  const Wide<W> none{};
  EXPECT_FALSE(wide::any(none > wide::all<Wide<W>>(0)));
  for (int lane = 0; lane < W; ++lane) {
    Wide<W> one{};
    one[lane] = 1;
    EXPECT_TRUE(wide::any(one > none)) << W << ' ' << lane;
  }
}

}

// Wider ones are compiled for processors that have them; on others the compiler makes narrow ones of them.
TEST(Wide, FoursAreTransposedAndPutBack) {
  goes_there_and_back<1>();
  goes_there_and_back<4>();
}
TEST(Wide, RootsAreThoseOfEachLane) {
  roots_are_exact<1>();
  roots_are_exact<4>();
}

TEST(Wide, AnySeesEachLane) {
  any_sees_each_lane<1>();
  any_sees_each_lane<4>();
}
