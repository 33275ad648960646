// What a picture of many bodies costs, and what it costs the physics thread beside it.
#pragma once

#include <string>

namespace sudar::app {

struct PictureCost {
  std::string driver;
  int width = 0, height = 0;
  std::size_t bodies = 0;
  struct Picture {
    double ms = 0, cpu_ms = 0;  // median by the clock, mean of all cores together
  } plain, fine;
  // A step of the physics thread, median of its processor time, in µs: alone, and beside plain pictures that are drawn
  // without a pause; and the same by the clock.
  double alone_us = 0, beside_us = 0, alone_clock_us = 0, beside_clock_us = 0;
};

PictureCost measure_pictures(int bodies, int width, int height);

}
