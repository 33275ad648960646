// Restitution in soft_step: true impacts before a sub-step's gravity, one contact after the other, its points at once.
#pragma once

#include "dynamics/soft_batch.h"

namespace sudar::inline SUDAR_PRECISION {

void strike_contacts(const SoftBatch&);
// What comes fast and will bounce must not be braked before it touches: lifts its row out of the passes' reach.
void leave_bouncing_alone(const SoftBatch&);

}
