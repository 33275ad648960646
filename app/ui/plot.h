// Curves of what is measured, against time or against each other: energy from the start, and whatever is asked for,
// also of the past. The wheel zooms, the mouse pulls, the right button shows all, a click goes to that step.
#pragma once

#include "history/axis.h"
#include "ui/controls.h"

struct ImDrawList;

namespace sudar::ui {

class Plot {
 public:
  explicit Plot(Controls& controls) : controls_(controls) {}
  void draw(float x, float y, float width, float height);

 private:
  struct Paper {  // where curves are drawn, pixels
    float x, y, width, height;
  };
  void choices(const Moment&, float width);
  void add_menu(const Moment&);
  void exports(const Moment&);
  void time_curves(const Moment&, const Paper&);
  void phase(const Moment&, const Paper&);
  void mouse(const Chart&, const Axis& time, const Paper&);
  void request();
  bool shown(const Chart::Curve& c) const { return !hidden_.contains(c.number); }

  Controls& controls_;
  std::map<int, bool> hidden_;  // by number of the watch
  int against_ = 0;             // number of the watch that is the other axis; 0: time
  bool logarithmic_ = false;
  double from_ = 0, to_ = 0;  // the part of time that is shown, s; equal: all
  ChartRequest asked_;
  bool pulled_ = false;  // since the button went down
  int width_ = 400;      // of the paper when it was drawn last, pixels
};

}
