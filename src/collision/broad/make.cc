#include "collision/broad/brute.h"
#include "collision/broad/tree.h"

namespace sudar::inline SUDAR_PRECISION {

std::unique_ptr<BroadPhase> make_broad_phase(Broad kind) {
  switch (kind) {
    case Broad::brute:
      return std::make_unique<Brute>();
    case Broad::tree:
      return std::make_unique<Tree>();
  }
  throw Error("broad", "no such broad phase");
}

}
