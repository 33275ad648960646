// Every scenario has the same bits with every broad phase.
#include "scenarios/every_scenario.h"

#include "broad_kinds.h"

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

void same_bits(const ScenarioEntry& entry) {
  const Hashes expected = run(entry, Broad::brute);
  for (const Broad kind : broad_kinds()) EXPECT_TRUE(run(entry, kind) == expected) << name_of(kind);
}

}

int main(int argc, char** argv) { return test_every_scenario(argc, argv, same_bits); }
