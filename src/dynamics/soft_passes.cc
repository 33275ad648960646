#include "dynamics/rotation.h"
#include "dynamics/soft_rows.h"

namespace sudar::inline SUDAR_PRECISION {

extern const SoftPassTable soft_passes_1, soft_passes_4;
#ifdef __x86_64__
extern const SoftPassTable soft_passes_8, soft_passes_16;
#endif

void turn_in_parts(SoftMotion& m, std::uint32_t lane, Real h) {
  const auto at = [&](const Vec3T<SoftLanes>& v) { return Vec3{v.x[lane], v.y[lane], v.z[lane]}; };
  auto& q = m.orientation;
  const Quat now{q.x[lane], q.y[lane], q.z[lane], q.w[lane]};
  const Quat then = rotate_freely(now, at(m.momentum), at(m.inertia), at(m.inverse_inertia), h).orientation;
  q.x[lane] = then.x, q.y[lane] = then.y, q.z[lane] = then.z, q.w[lane] = then.w;
}

const SoftPassTable& soft_passes(int lanes) {
  const int most = lanes == 0 ? SoftLanes::count : lanes;
#ifdef __x86_64__
  if (most >= 16 && __builtin_cpu_supports("avx512f")) return soft_passes_16;
  if (most >= 8 && __builtin_cpu_supports("avx2")) return soft_passes_8;
#endif
  return most >= 4 ? soft_passes_4 : soft_passes_1;
}

}
