// What other engines reach on the same scenes: the table of the report and of docs/verification.md. Measured once with
// each engine's default settings at 60 Hz, damping and sleeping off (Box3D 30c67b5 with 4 sub-steps; npm builds of
// Rapier 0.21.0, Jolt 1.1.0 with its gyroscopic force on, Havok 1.3.14, PhysX 5.6.1, Bullet as ammojs-typed 1.1.0,
// MuJoCo 3.3.8): they show what errors are reachable, not a ranking.
#pragma once

#include "verify/runner.h"

namespace sudar::verify {

struct PeerColumn {
  const char *title, *id;
  const char *set, *quantity;  // of ours
  std::string (*text)(const Quantity&);
};

struct PeerRow {
  const char* engine;
  std::vector<const char*> values;  // one for each column
};

const std::vector<PeerColumn>& peer_columns();
const std::vector<PeerRow>& peer_rows();

// Our value in the column, or a dash where the results do not hold it.
std::string our_value(const PeerColumn&, const std::vector<Result>&);

}
