// A line on the terminal that shows how far long work is. In a pipe or a file: nothing.
#pragma once

#include <chrono>
#include <string>

namespace sudar::app {

class Progress {
 public:
  Progress(std::string title, double total);
  ~Progress() { clear(); }
  Progress(const Progress&) = delete;
  void show(double done);
  void clear();  // takes the line away

 private:
  using Clock = std::chrono::steady_clock;
  std::string title_;
  double total_;
  bool terminal_;
  Clock::time_point start_ = Clock::now(), next_ = start_;
};

}
