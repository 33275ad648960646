// What tells two worlds, or two recordings, apart: the first field that differs, whose it is, and both values.
#pragma once

#include <sudar/record.h>

namespace sudar::inline SUDAR_PRECISION {

struct Difference {
  // As docs/state.md calls it, a path in what is no single number: "velocity" of a body, "config.dt",
  // "joints.impulse.low", "pairs.manifold.normal".
  std::string field;
  Body body{};              // whose field it is; null: no body's
  std::int64_t index = -1;  // of the body, joint, pair or another row of a table; -1: of no table
  std::string a, b;         // the values as JSON; empty where one is not known
};

// The first difference in the order in which the state is saved: the settings, the bodies, joints, and so on; the
// geometry comes last. None: the two go on with the same bits.
std::optional<Difference> difference(const World& a, const World& b);

struct RecordingDifference {
  std::int64_t step;  // 0: they begin with different worlds
  // "start"; "operation": what the user did before the step, or its length; a stage of the step, by the hashes of its
  // last sub-step; "end": one is longer.
  std::string stage;
  Difference difference;
};

// Runs both, from where they are, up to the first difference. Where what was done is the same, and only the recorded
// results differ (two programs made them), a value is known only on the side with which this program agrees.
std::optional<RecordingDifference> difference(Replay& a, Replay& b);

}
