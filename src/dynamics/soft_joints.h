// The joints of a batch of soft_step at both ends of a step.
#pragma once

#include "dynamics/soft_batch.h"

namespace sudar::inline SUDAR_PRECISION {

// After the bodies are gathered.
void prepare_joints(const SoftBatch&, std::span<const std::uint32_t> islands);
void store_joints(const SoftBatch&);

}
