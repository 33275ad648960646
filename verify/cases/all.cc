#include "verify/cases/cases.h"
#include "verify/runner.h"

namespace sudar::verify {

const std::vector<Case>& all_cases() {
  static const std::vector<Case> cases = [] {
    std::vector<Case> all;
    for (const auto file : {free_bodies, rotations, pendulums, impacts, friction, rolling, toppling, stacks, arches, chains, domino_rows, tops}) {
      std::vector<Case> some = file();
      all.insert(all.end(), some.begin(), some.end());
    }
    return all;
  }();
  return cases;
}

}
