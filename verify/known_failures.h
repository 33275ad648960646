// The cases that fail today, and why in a line; docs/verification.md tells more, with the experiments. `sudar verify`
// takes them for what they are: a case that fails and is not here is a regression, one that is here and passes has to
// leave the list.
#pragma once

#include <optional>
#include <string_view>

#include "verify/case.h"

namespace sudar::verify {

struct KnownFailure {
  const char *id, *reason;
  Effort from = Effort::quick;  // with less effort it passes, or is not run
  bool single = false;          // in single precision only
  std::optional<Solver> only{};  // with this solver only
};

// Null: the case is to pass, with this effort, in this precision and with this solver (none: it uses none).
const KnownFailure* known_failure(std::string_view id, Effort, std::optional<Solver>);

}
