#include "collision/broad/broad.h"

#include "support.h"

#include <gtest/gtest.h>

namespace sudar::test {
namespace {

Proxy random_proxy(Random& random) {
  Proxy p;
  // On a coarse grid, so that boxes often only touch.
  for (int i = 0; i < 3; ++i) {
    p.box.low[i] = random.below(20);
    p.box.high[i] = p.box.low[i] + random.below(5);
  }
  p.filter.category = 1u << random.below(3);
  p.filter.mask = random.below(3) ? 0xffffffffu : std::uint32_t(random.below(8));
  p.filter.group = random.below(4) ? 0 : random.below(3) - 1;
  p.present = random.below(5) > 0;
  p.fixed = random.below(4) == 0;
  return p;
}

TEST(Filters, GroupsGoBeforeMasks) {
  EXPECT_TRUE(may_touch({1, 2, 0}, {2, 1, 0}));
  EXPECT_FALSE(may_touch({1, 2, 0}, {2, 2, 0}));
  EXPECT_FALSE(may_touch({1, 1, -3}, {1, 1, -3}));
  EXPECT_TRUE(may_touch({1, 0, 3}, {1, 0, 3}));
  EXPECT_TRUE(may_touch({1, 1, -3}, {1, 1, -4}));
}

// Whatever the kind, it must give the pairs that the contract describes, sentence by sentence.
TEST(BroadPhase, KeepsTheContract) {
  const auto broad = make_broad_phase(Broad::brute);
  Random random(1);
  std::vector<Proxy> proxies;
  for (int step = 0; step < 60; ++step) {
    std::vector<std::uint32_t> changed;
    for (std::uint32_t i = 0; i < proxies.size(); ++i) {
      if (random.below(6) == 0) changed.push_back(i), proxies[i] = random_proxy(random);
    }
    for (int i = random.below(12); i > 0; --i) {
      changed.push_back(std::uint32_t(proxies.size()));
      proxies.push_back(random_proxy(random));
    }
    std::vector<ProxyPair> found{{7, 9}};  // what is there stays
    broad->update(proxies, changed, found);
    ASSERT_EQ(found[0], (ProxyPair{7, 9}));
    found.erase(found.begin());

    std::vector<ProxyPair> expected;
    for (std::uint32_t a = 0; a < proxies.size(); ++a) {
      for (std::uint32_t b = a + 1; b < proxies.size(); ++b) {
        const Proxy &p = proxies[a], &q = proxies[b];
        const bool moved = std::ranges::count(changed, a) + std::ranges::count(changed, b) > 0;
        if (moved && p.present && q.present && !(p.fixed && q.fixed) && overlap(p.box, q.box) &&
            may_touch(p.filter, q.filter)) {
          expected.push_back({a, b});
        }
      }
    }
    ASSERT_EQ(found, expected);
  }
}

}
}
