// Contacts of one colour share no body that answers impulses, and every contact has its turn.
#include "dynamics/colours.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

using namespace sudar;

namespace {

using Sides = std::vector<std::array<std::uint32_t, 2>>;

Sides random_contacts(std::uint32_t bodies, std::uint32_t count) {
  std::mt19937 random(7);
  Sides sides;
  while (sides.size() < count) {
    const auto a = std::uint32_t(random() % bodies), b = std::uint32_t(random() % bodies);
    if (a != b) sides.push_back({a, b});
  }
  return sides;
}

}

TEST(Colours, NoTwoContactsOfAColourShareABody) {
  for (const std::uint32_t bodies : {3u, 20u, 500u}) {
    const Sides sides = random_contacts(bodies, 800);
    Colours colours;
    colours.assign(800, bodies, [&](std::uint32_t k) { return sides[k]; });
    std::size_t seen = colours.of(Colours::crowded).size();
    for (std::uint32_t c = 1; c <= Colours::colours; ++c) {
      std::set<std::uint32_t> met;
      for (const std::uint32_t k : colours.of(c)) {
        ++seen;
        for (const std::uint32_t body : sides[k]) EXPECT_TRUE(body == 0 || met.insert(body).second) << bodies;
      }
    }
    EXPECT_EQ(seen, 800u);
  }
}

// Twenty contacts on one plate need twenty colours; what finds none of 64 goes first, one by one.
TEST(Colours, ACrowdedBodyHasAnOverflow) {
  Colours colours;
  colours.assign(100, 102, [](std::uint32_t k) { return std::array{1u, k + 2}; });
  EXPECT_EQ(colours.of(Colours::crowded).size(), 100 - Colours::half);
}

// Others have no say: an island has the same colours wherever it stands in the list.
TEST(Colours, DependOnTheIslandAlone) {
  const Sides own = random_contacts(30, 60);
  Sides both = random_contacts(20, 50);
  for (auto& s : both) s = {s[0] == 0 ? 0 : s[0] + 100, s[1] == 0 ? 0 : s[1] + 100};
  const auto others = std::uint32_t(both.size());
  both.insert(both.end(), own.begin(), own.end());
  Colours alone, together;
  alone.assign(60, 30, [&](std::uint32_t k) { return own[k]; });
  together.assign(std::uint32_t(both.size()), 200, [&](std::uint32_t k) { return both[k]; });
  for (std::uint32_t c = 0; c <= Colours::colours; ++c) {
    std::vector<std::uint32_t> mine;
    for (const std::uint32_t k : together.of(c)) {
      if (k >= others) mine.push_back(k - others);
    }
    const auto expected = alone.of(c);
    EXPECT_TRUE(std::equal(mine.begin(), mine.end(), expected.begin(), expected.end())) << "colour " << c;
  }
}
