#include "collision/broad/brute.h"
#include "collision/broad/grid.h"
#include "collision/broad/kinetic_sweep.h"
#include "collision/broad/sweep.h"
#include "collision/broad/tree.h"

namespace sudar::inline SUDAR_PRECISION {

std::unique_ptr<BroadPhase> make_broad_phase(Broad kind) {
  switch (kind) {
    case Broad::brute:
      return std::make_unique<Brute>();
    case Broad::grid:
      return std::make_unique<Grid>();
    case Broad::sweep:
      return std::make_unique<Sweep>();
    case Broad::kinetic_sweep:
      return std::make_unique<KineticSweep>();
    case Broad::tree:
      return std::make_unique<Tree>();
  }
  throw Error("broad", "no such broad phase");
}

}
