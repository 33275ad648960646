#include "verify/cases/cases.h"
#include "verify/runner.h"

namespace sudar::verify {

const std::vector<Case>& all_cases() {
  static const std::vector<Case> cases = [] {
    std::vector<Case> all;
    for (const auto file : {free_bodies, rotations, pendulums, chains, joints,    impacts,      bounces,     fast,
                            momentum,    friction,  rolling,   bowls,  tops,      toppling,     domino_rows, stacks,
                            arches,      grains,    silos,     solids, distances, simbenchmark, errata}) {
      std::vector<Case> some = file();
      all.insert(all.end(), some.begin(), some.end());
    }
    return all;
  }();
  return cases;
}

}
