// The cases that fail today, and why in a line; docs/verification.md tells more, with the experiments. `sudar verify`
// takes them for what they are: a case that fails and is not here is a regression, one that is here and passes has to
// leave the list.
#pragma once

#include <string_view>

#include "verify/case.h"

namespace sudar::verify {

struct KnownFailure {
  const char *id, *reason;
  Effort from = Effort::quick;  // with less effort it passes, or is not run
  bool single = false;          // in single precision only
};

// Null: the case is to pass, with this effort and in this precision.
const KnownFailure* known_failure(std::string_view id, Effort);

}
