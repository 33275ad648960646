// The contacts of a batch of soft_step at both ends of a step: from manifolds and what is remembered of them to rows, and
// from rows to what is to be remembered.
#pragma once

#include "dynamics/soft_batch.h"

namespace sudar::inline SUDAR_PRECISION {

// After the bodies are gathered. All of rows but how bodies answer impulses (SoftPassTable::answer).
void prepare_contacts(const SoftBatch&, std::span<const std::uint32_t> islands);
void store_contacts(const SoftBatch&);

}
