#include "dynamics/soft_passes.h"

namespace sudar::inline SUDAR_PRECISION {

extern const SoftPassTable soft_passes_8 = SoftPasses<8>::table();

}
