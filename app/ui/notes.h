// Notes over the picture, as large as their text: the scenario's keys, what colours and arrows mean, what was just
// done, help.
#pragma once

#include "ui/controls.h"

namespace sudar::ui {

class Notes {
 public:
  explicit Notes(Controls& controls) : controls_(controls) {}
  void draw(const Area&);

 private:
  void keys(const Area&);
  void legend(const Area&);
  void message(const Area&);
  void help(const Area&);

  Controls& controls_;
  std::int64_t seen_message_ = 0;
  Clock::time_point message_since_{};
};

}
