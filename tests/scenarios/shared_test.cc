// Every scenario has the same bits, whoever shares its steps.
#include "scenarios/every_scenario.h"

using namespace sudar;

namespace {

std::uint64_t run(const ScenarioEntry& entry, int workers) {
  Session session(entry, {.config = {{"workers", std::to_string(workers)}}});
  for (int i = 0; i < 200; ++i) session.step();
  return session.world().hash();
}

void same_bits(const ScenarioEntry& entry) {
  const std::uint64_t expected = run(entry, 1);
  for (const int workers : {2, 3, 5}) EXPECT_EQ(run(entry, workers), expected) << workers << " workers";
}

}

int main(int argc, char** argv) { return test_every_scenario(argc, argv, same_bits); }
