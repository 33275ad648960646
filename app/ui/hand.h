// Mouse and keyboard over the picture: on a body the left button selects and drags, beside it turns the camera.
#pragma once

#include "ui/controls.h"
#include "ui/input.h"

namespace sudar::ui {

class Hand {
 public:
  using Pick = std::function<Body(int x, int y)>;  // what is seen at a pixel of the picture
  Hand(Controls& controls, Pick pick) : controls_(controls), pick_(std::move(pick)) {}

  void take(const InputEvent&, const Area&);
  void fly(double seconds);  // while the right button is held with WASD QE
  bool busy() const { return mode_ != Mode::none; }

 private:
  enum class Mode { none, drag, twist, orbit, pan, right };
  void aim();
  void press(const InputEvent&, const Area&);
  void move(double dx, double dy, const Area&);
  void release();
  void key(const InputEvent&);

  Controls& controls_;
  Pick pick_;
  Mode mode_ = Mode::none;
  int button_ = 0;
  double x_ = 0, y_ = 0;
  std::vector<int> down_;  // keys
};

}
