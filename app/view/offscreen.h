// A sink without a window: a context of its own on any machine, with or without a screen (EGL, surfaceless), and
// pictures into memory.
#pragma once

#include <memory>

#include "view/renderer.h"

namespace sudar::view {

class Offscreen {
 public:
  Offscreen();  // throws std::runtime_error with the reason when the machine has no EGL or no OpenGL 3.3
  ~Offscreen();
  Image picture(const Scene&, const Camera&, const Style&, int width, int height);
  IdImage ids(const Scene&, const Camera&, int width, int height);
  std::string driver() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}
