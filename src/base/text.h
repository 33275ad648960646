// Numbers as people write them, for messages.
#pragma once

#include <sudar/base.h>

#include <cstdio>

namespace sudar::inline SUDAR_PRECISION {

// Six digits at most, no trailing zeros: "0.3", "1e-09", "inf".
inline std::string text(double x) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%g", x);
  return buffer;
}

}
