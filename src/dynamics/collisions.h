// Collisions, thesis §3.5, §3.6: passes over all contacts of an island that approach, until none does. Nothing is
// warm-started and nothing is kept: an impact is over at once.
#pragma once

#include "dynamics/sub_step.h"

namespace sudar::inline SUDAR_PRECISION {

void strike_contacts(SubStep& s);

}
