#include "collision/broad/sweep.h"

namespace sudar::inline SUDAR_PRECISION {

namespace {

// Per end point; more happen when everything jumps. Uniform motion of 100,000 boxes was fastest without giving up.
constexpr std::size_t most_passings = 500;

}

bool Sweep::sort(std::array<Axis, 3>& axes) {
  std::size_t passings = 0;
  for (int k = 0; k < 3; ++k) {
    Axis& axis = axes[std::size_t(k)];
    for (std::size_t i = 0; i < axis.size(); ++i) {
      const EndPoint e{target(k, axis[i]), axis[i].id};
      std::size_t j = i;
      for (; j > 0 && before(e, axis[j - 1]); --j) {
        if (!e.upper() && axis[j - 1].upper()) meet(e, axis[j - 1]);
        axis[j] = axis[j - 1];
      }
      axis[j] = e;
      passings += i - j;
      if (passings > most_passings * axis.size()) return false;
    }
  }
  return true;
}

}
