// Groups of contacts: who shares a body keeps the order, and no two of a group do.
#include "dynamics/grouping.h"

#include <gtest/gtest.h>

#include <random>

using namespace sudar;

TEST(Grouping, KeepsTheOrderOfContactsThatShareABody) {
  constexpr std::uint32_t still = 0xffffffffu;
  std::mt19937 random(3);
  for (const std::uint32_t bodies : {2u, 5u, 12u, 60u}) {
    std::vector<std::array<std::uint32_t, 2>> contacts;
    for (int k = 0; k < 200; ++k) {
      const auto a = std::uint32_t(random() % bodies), b = std::uint32_t(random() % bodies);
      contacts.push_back({a, a == b ? still : b});
    }
    std::vector<ContactGroup> groups;
    group_contacts(std::uint32_t(contacts.size()), still, [&](std::uint32_t k) { return contacts[k]; }, groups);
    std::vector<std::size_t> turn(contacts.size(), groups.size());  // the group that each came into
    std::size_t seen = 0, full = 0;
    for (std::size_t g = 0; g < groups.size(); ++g) {
      for (std::size_t n = 0; n < groups[g].count; ++n) turn[groups[g].members[n]] = g, ++seen;
      full += groups[g].count == ContactGroup::most;
    }
    EXPECT_EQ(seen, contacts.size());
    if (bodies == 60) {
      EXPECT_GT(full, groups.size() / 2);
    }
    for (std::size_t later = 0; later < contacts.size(); ++later) {
      ASSERT_LT(turn[later], groups.size()) << "left out";
      for (std::size_t k = 0; k < later; ++k) {
        for (const std::uint32_t body : contacts[k]) {
          if (body == still || (body != contacts[later][0] && body != contacts[later][1])) continue;
          ASSERT_LT(turn[k], turn[later]) << k << " and " << later << " share body " << body;
        }
      }
    }
  }
}
