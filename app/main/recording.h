// A recording into a file, step by step: whatever ends the program, what was recorded so far opens.
#pragma once

#include <sudar/record.h>

#include "main/files.h"

namespace sudar::app {

class Recording {
 public:
  Recording(const std::string& path, World&, const std::string& title);  // starts now; throws Error
  void after_step();                                                     // once after every World::step
  void finish();
  std::int64_t steps() const { return steps_; }
  const std::string& path() const { return file_.path(); }

 private:
  void append(std::span<const std::byte> whole);  // what the file does not hold yet
  GrowingFile file_;
  Recorder recorder_;
  std::size_t written_ = 0;
  std::int64_t steps_ = 0;
};

}
