// Every scenario has the same bits with every broad phase.
#include "scenarios/catalogue.h"

#include "broad_kinds.h"

#include <gtest/gtest.h>

using namespace sudar;

namespace {

struct Hashes {
  std::uint64_t motion, state;
  bool operator==(const Hashes&) const = default;
};

Hashes run(const ScenarioEntry& entry, Broad kind) {
  Session session(entry, {.config = {{"broad", name_of(kind)}}});
  for (int i = 0; i < 400; ++i) session.step();
  const std::uint64_t motion = session.world().motion_hash();  // as it is, settings and all
  return {motion, hash_without_broad(session.world())};
}

class SameBits : public testing::Test {
 public:
  explicit SameBits(const ScenarioEntry& entry) : entry_(entry) {}
  void TestBody() override {
    const Hashes expected = run(entry_, Broad::brute);
    for (const Broad kind : broad_kinds()) EXPECT_TRUE(run(entry_, kind) == expected) << name_of(kind);
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
