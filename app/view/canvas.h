// A picture on the graphics card: what a Renderer draws into, to be read or shown.
#pragma once

#include "view/gl.h"
#include "view/renderer.h"

namespace sudar::view {

class Canvas {
 public:
  Canvas(int width, int height);
  int width() const { return width_; }
  int height() const { return height_; }
  Target target() const { return {framebuffer_, width_, height_}; }
  Image read() const;
  void show(int left, int bottom) const;  // copies it into the window's framebuffer, its lower left corner there

 private:
  int width_, height_;
  gl::Texture colour_;
  gl::Framebuffer framebuffer_;
};

}
