// Below the picture: where in its history the run is. Buttons, branches, and a strip with marks of what happened, on
// which the mouse goes to and fro.
#pragma once

#include "ui/controls.h"

namespace sudar::ui {

class TimelineBar {
 public:
  static constexpr float height = 62;  // pixels
  explicit TimelineBar(Controls& controls) : controls_(controls) {}
  void draw(float x, float y, float width);

 private:
  void buttons(const Moment&);
  void branches(const Moment&);
  void strip(const Moment&);

  Controls& controls_;
  std::int64_t asked_ = -1;  // frame, while the mouse holds the strip
  char name_[48] = "";
};

}
