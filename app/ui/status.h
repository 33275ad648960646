// The state of the window in a file, for tests and scripts: one JSON object, replaced as a whole, some thirty times a
// second.
#pragma once

#include "ui/controls.h"
#include "ui/window.h"

namespace sudar::ui {

class StatusFile {
 public:
  explicit StatusFile(std::string path) : path_(std::move(path)) {}      // empty: none
  void write(const Controls&, const Window&, double frames_per_second);  // once a picture

 private:
  std::string path_;
  Clock::time_point last_{};
  std::int64_t pictures_ = 0;
};

}
