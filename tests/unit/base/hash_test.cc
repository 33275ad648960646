#include "base/hash.h"

#include <gtest/gtest.h>

#include <bitset>
#include <set>
#include <vector>

using namespace sudar;

namespace {

TEST(Hash, DependsOnEveryByteLengthAndSeed) {
  std::vector<unsigned char> bytes(100);
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<unsigned char>(i * 37);
  std::set<std::uint64_t> seen;
  std::size_t count = 0;
  for (std::size_t size = 0; size <= bytes.size(); ++size, ++count) seen.insert(hash_bytes(bytes.data(), size));
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    for (int bit = 0; bit < 8; ++bit, ++count) {
      bytes[i] = static_cast<unsigned char>(bytes[i] ^ (1 << bit));
      seen.insert(hash_bytes(bytes.data(), bytes.size()));
      bytes[i] = static_cast<unsigned char>(bytes[i] ^ (1 << bit));
    }
  }
  for (std::uint64_t seed = 1; seed < 100; ++seed, ++count) seen.insert(hash_bytes(bytes.data(), bytes.size(), seed));
  EXPECT_EQ(seen.size(), count);
}

// A changed bit of the input changes each bit of the result with probability one half.
TEST(Hash, Avalanche) {
  for (const std::size_t size : {8u, 40u, 77u}) {
    std::vector<unsigned char> bytes(size, 0x5a);
    const std::uint64_t before = hash_bytes(bytes.data(), size);
    std::size_t flipped = 0;
    for (std::size_t i = 0; i < size * 8; ++i) {
      bytes[i / 8] = static_cast<unsigned char>(bytes[i / 8] ^ (1 << i % 8));
      flipped += std::bitset<64>(before ^ hash_bytes(bytes.data(), size)).count();
      bytes[i / 8] = static_cast<unsigned char>(bytes[i / 8] ^ (1 << i % 8));
    }
    EXPECT_NEAR(double(flipped) / double(size * 8), 32, 2);
  }
}

// Recordings are compared between machines and versions: these values must never change.
TEST(Hash, PinnedValues) {
  const char text[] = "Sudar: the same input gives the same bits everywhere.";
  EXPECT_EQ(hash_bytes(text, 0), 13205639532393747828u);
  EXPECT_EQ(hash_bytes(text, sizeof text - 1), 13505120045746478460u);
}

TEST(Hash, HasherTellsOrderAndSplits) {
  const std::vector<int> all{1, 2, 3};
  EXPECT_NE(Hasher().add(1).add(2).value(), Hasher().add(2).add(1).value());
  EXPECT_NE(Hasher().add(0).value(), Hasher().add(0).add(0).value());
  EXPECT_EQ(Hasher().add_all(std::span<const int>(all)).value(), Hasher().add_all(std::span<const int>(all)).value());
  EXPECT_NE(Hasher().add_all(std::span<const int>(all)).value(),
            Hasher().add_all(std::span<const int>(all).first(2)).value());
}

}
