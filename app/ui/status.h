// The state of the window in a file, for tests and scripts: one JSON object, replaced as a whole, ten times a second.
#pragma once

#include "ui/controls.h"

namespace sudar::ui {

class StatusFile {
 public:
  explicit StatusFile(std::string path) : path_(std::move(path)) {}  // empty: none
  void write(const Controls&, double frames_per_second);

 private:
  std::string path_;
  Clock::time_point last_{};
};

}
