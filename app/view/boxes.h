// The broad phase over the picture, as the outlines of boxes: those round the bodies white, its cells or nodes coloured
// by their size.
#pragma once

#include "view/instances.h"
#include "view/renderer.h"

namespace sudar::view {

class Boxes {
 public:
  void place(const Scene&, const Pos& eye, const Style&);
  void draw() const { instances_.draw(); }

 private:
  Instances instances_;
  std::size_t outline_ = instances_.add_mesh(cube_outline());
};

}
