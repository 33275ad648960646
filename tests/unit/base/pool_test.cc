#include "base/pool.h"

#include <gtest/gtest.h>

#include <numeric>

using namespace sudar;

namespace {

TEST(Pool, DoesEveryTaskOnce) {
  for (const std::uint32_t workers : {1u, 2u, 3u, 5u}) {
    Pool pool(workers);
    for (const std::uint32_t n : {0u, 1u, 2u, 7u, 1000u}) {
      std::vector<int> done(n, 0);
      std::vector<int> by(workers, 0);
      for (int again = 0; again < 50; ++again) {
        pool.for_each(n, [&](std::uint32_t worker, std::uint32_t i) { ++done[i], ++by[worker]; });
      }
      for (const int d : done) ASSERT_EQ(d, 50) << n << " tasks, " << workers << " workers";
      EXPECT_EQ(std::accumulate(by.begin(), by.end(), 0), int(50 * n));
    }
  }
}

TEST(Pool, RangesCoverEverything) {
  Pool pool(2);
  std::vector<int> done(1001, 0);
  pool.for_ranges(1001, 16, [&](std::uint32_t, std::uint32_t first, std::uint32_t end) {
    ASSERT_LE(end - first, 16u);
    for (std::uint32_t i = first; i < end; ++i) ++done[i];
  });
  EXPECT_EQ(std::accumulate(done.begin(), done.end(), 0), 1001);
}

// What one loop wrote is there for the caller and for the next loop.
TEST(Pool, LoopsSeeWhatTheOneBeforeWrote) {
  Pool pool(3);
  std::vector<std::uint64_t> a(512, 1), b(512);
  for (int round = 0; round < 200; ++round) {
    pool.for_each(512, [&](std::uint32_t, std::uint32_t i) { b[i] = a[i] + a[511 - i]; });
    pool.for_each(512, [&](std::uint32_t, std::uint32_t i) { a[i] = (b[i] + b[(i + 1) % 512]) % 1000003; });
  }
  for (const std::uint64_t x : a) ASSERT_EQ(x, a[0]);
}

TEST(Pool, ChangesItsNumberOfWorkers) {
  Pool pool;
  for (const std::uint32_t workers : {1u, 4u, 2u, 1u, 3u}) {
    pool.resize(workers);
    std::atomic<int> sum = 0;
    pool.for_each(100, [&](std::uint32_t worker, std::uint32_t) { sum += worker < workers ? 1 : 1000; });
    EXPECT_EQ(sum, 100);
  }
}

}
