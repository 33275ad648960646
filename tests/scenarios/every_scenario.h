// A test program with one test for each scenario.
#pragma once

#include "scenarios/catalogue.h"

#include <gtest/gtest.h>

namespace sudar::inline SUDAR_PRECISION {

class ScenarioTest : public testing::Test {
 public:
  using Run = void (*)(const ScenarioEntry&);
  ScenarioTest(const ScenarioEntry& entry, Run run) : entry_(entry), run_(run) {}
  void TestBody() override { run_(entry_); }

 private:
  const ScenarioEntry& entry_;
  Run run_;
};

// Runs `run` as the test NAME.what of every scenario; what main() returns.
inline int test_every_scenario(int argc, char** argv, ScenarioTest::Run run, const char* what = "same_bits") {
  testing::InitGoogleTest(&argc, argv);
  for (const ScenarioEntry* entry : scenarios().all()) {
    testing::RegisterTest(entry->name, what, nullptr, nullptr, __FILE__, __LINE__,
                          [entry, run]() -> testing::Test* { return new ScenarioTest(*entry, run); });
  }
  return RUN_ALL_TESTS();
}
}
