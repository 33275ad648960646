// Elapsed wall time.
#pragma once

#include <sudar/base.h>

#include <chrono>

namespace sudar::inline SUDAR_PRECISION {

class Timer {
 public:
  double microseconds() const {
    return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// Adds the time of its scope.
class Stopwatch {
 public:
  explicit Stopwatch(double& microseconds) : sum_(microseconds) {}
  ~Stopwatch() { sum_ += timer_.microseconds(); }

 private:
  double& sum_;
  Timer timer_;
};

}
