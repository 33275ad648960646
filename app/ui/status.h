// The state of the window in a file, for tests and scripts: one JSON object, replaced as a whole with every picture:
// who has pressed a key waits for the number of pictures to grow by two, and what it reads then has the answer.
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
  std::int64_t pictures_ = 0;
};

}
