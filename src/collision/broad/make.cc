#include "collision/broad/brute.h"

namespace sudar::inline SUDAR_PRECISION {

std::unique_ptr<BroadPhase> make_broad_phase(Broad kind) {
  switch (kind) {
    case Broad::brute:
      return std::make_unique<Brute>();
  }
  throw Error("broad", "no such broad phase");
}

}
