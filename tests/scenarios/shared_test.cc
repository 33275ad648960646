// Every scenario has the same bits, whoever shares its steps and however many contacts are solved side by side.
#include "scenarios/every_scenario.h"

using namespace sudar;

namespace {

std::uint64_t run(const ScenarioEntry& entry, const char* solver, int workers, int lanes = 0) {
  Session session(entry, {.config = {{"solver", solver},
                                     {"workers", std::to_string(workers)},
                                     {"soft_step.lanes", std::to_string(lanes)}}});
  for (int i = 0; i < 200; ++i) session.step();
  return session.world().motion_hash();
}

void same_bits(const ScenarioEntry& entry) {
  const std::uint64_t expected = run(entry, "impulse_2007", 1);
  for (const int workers : {2, 3, 5}) EXPECT_EQ(run(entry, "impulse_2007", workers), expected) << workers << " workers";
  const std::uint64_t soft = run(entry, "soft_step", 1, 1);
  for (const auto& [workers, lanes] : {std::pair(2, 4), {3, 8}, {5, 16}}) {
    EXPECT_EQ(run(entry, "soft_step", workers, lanes), soft) << workers << " workers, " << lanes << " lanes";
  }
}

}

int main(int argc, char** argv) { return test_every_scenario(argc, argv, same_bits); }
