// One more round of contacts, level by level from the ground up, in which a body stands on what lies below as on rock.
// Saves passes where weight presses on weight; wrong where the lower body should give way (docs/shock_propagation.md;
// Guendelman, Bridson, Fedkiw 2003).
#pragma once

#include "dynamics/sub_step.h"

namespace sudar::inline SUDAR_PRECISION {

// Changes rows and velocities: what the next sub-step begins with is stored before.
void propagate_shock(SubStep& s);

}
