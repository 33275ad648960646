#include "verify/known_failures.h"

namespace sudar::verify {

namespace {

constexpr KnownFailure known[] = {
    {"V02", "single precision: the height is what 14 m of rise and fall leave over", Effort::quick, true},
    {"V09", "single precision: a velocity has 24 bits", Effort::quick, true},
    {"V12", "an impact happens at the beginning of the sub-step in which the gap closes"},
    {"V13", "an impact happens at the beginning of the sub-step in which the gap closes"},
    {"V23", "the passes do not converge at the edge of balance", Effort::quick, false, Solver::impulse_2007},
    {"V24", "where faces lean on each other sideways no load is known, and contacts give way", Effort::quick, false, Solver::soft_step},
    {"V31", "a body in contact starts half a sub-step late"},
    {"V36", "rounding of passes that never end early", Effort::normal},
    {"V42", "what is not very fast meets at the beginning of the sub-step in which the gap closes"},
    {"V43", "the passes do not converge at such a ratio of masses", Effort::quick, false, Solver::impulse_2007},
    {"V45", "the passes do not carry an impulse through a hundred levels", Effort::normal, false, Solver::impulse_2007},
    {"V50", "one of ten seeds takes longer", Effort::full},
    {"V13b", "an impact happens at the beginning of the sub-step in which the gap closes", Effort::normal},
    {"B1", "one sub-step: the balls' contacts are found before the slab moves", Effort::quick, false, Solver::soft_step},
    {"B2", "an overlap leaves by a fifth a step", Effort::normal},
    {"B3", "an impact happens at the beginning of the sub-step in which the gap closes", Effort::normal},
    {"B4", "few passes do not carry an impulse through so many levels", Effort::full},
    {"V57", "the velocity that a body in contact shows is that of the middle of the sub-step"},
};

}

const KnownFailure* known_failure(std::string_view id, Effort effort, std::optional<Solver> solver) {
  for (const KnownFailure& k : known) {
    const bool meant = k.id == id && effort >= k.from && (!k.single || sizeof(Real) == 4);
    if (meant && (!k.only || k.only == solver)) return &k;
  }
  return nullptr;
}

}
