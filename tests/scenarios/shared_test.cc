// Every scenario has the same bits, whoever shares its steps.
#include "scenarios/catalogue.h"

#include <gtest/gtest.h>

using namespace sudar;

namespace {

std::uint64_t run(const ScenarioEntry& entry, int workers) {
  Session session(entry, {.config = {{"workers", std::to_string(workers)}}});
  for (int i = 0; i < 200; ++i) session.step();
  return session.world().hash();
}

class SameBits : public testing::Test {
 public:
  explicit SameBits(const ScenarioEntry& entry) : entry_(entry) {}
  void TestBody() override {
    const std::uint64_t expected = run(entry_, 1);
    for (const int workers : {2, 3, 5}) EXPECT_EQ(run(entry_, workers), expected) << workers << " workers";
  }

 private:
  const ScenarioEntry& entry_;
};

}

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  for (const ScenarioEntry* entry : scenarios().all()) {
    testing::RegisterTest(entry->name, "same_bits", nullptr, nullptr, __FILE__, __LINE__,
                          [entry]() -> testing::Test* { return new SameBits(*entry); });
  }
  return RUN_ALL_TESTS();
}
