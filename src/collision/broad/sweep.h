// Sweep and prune, thesis (3.27), on three axes whose end points are kept in order by insertion sort, which is the
// fastest for what is nearly in order: O(n + passings). See end_points.h.
#pragma once

#include "collision/broad/end_points.h"

namespace sudar::inline SUDAR_PRECISION {

class Sweep final : public EndPointSweep {
 private:
  bool sort(std::array<Axis, 3>& axes) override;
};

}
