// From manifolds to the rows that solvers iterate on.
#pragma once

#include "dynamics/sub_step.h"

namespace sudar::inline SUDAR_PRECISION {

// Sets the rows of the island's contacts, with the impulses that the last sub-step left, and s.fastest.
void prepare_contacts(SubStep& s);

}
