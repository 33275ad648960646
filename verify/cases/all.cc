#include "verify/cases/cases.h"
#include "verify/runner.h"

namespace sudar::verify {

const std::vector<Case>& all_cases() {
  static const std::vector<Case> cases = [] {
    std::vector<Case> all;
    for (const auto file : {free_bodies, rotations, pendulums, impacts, friction, rolling}) {
      std::vector<Case> some = file();
      all.insert(all.end(), some.begin(), some.end());
    }
    for (const auto file : {toppling, stacks}) {  // minutes, not seconds: V20, V24, V45 and V57 are still to be judged
      for (Case& c : file()) c.effort = Effort::full, all.push_back(std::move(c));
    }
    return all;
  }();
  return cases;
}

}
