#include "dynamics/soft_rows.h"

namespace sudar::inline SUDAR_PRECISION {

extern const SoftPassTable soft_passes_1, soft_passes_4;
#ifdef __x86_64__
extern const SoftPassTable soft_passes_8, soft_passes_16;
#endif

const SoftPassTable& soft_passes(int lanes) {
  const int most = lanes == 0 ? SoftLanes::count : lanes;
#ifdef __x86_64__
  if (most >= 16 && __builtin_cpu_supports("avx512f")) return soft_passes_16;
  if (most >= 8 && __builtin_cpu_supports("avx2")) return soft_passes_8;
#endif
  return most >= 4 ? soft_passes_4 : soft_passes_1;
}

}
