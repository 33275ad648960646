#include "view/canvas.h"

#include <algorithm>

namespace sudar::view {

Canvas::Canvas(int width, int height)
    : width_(width),
      height_(height),
      colour_(gl::make_texture(gl::picture_format, width, height, GL_NEAREST)),
      framebuffer_(gl::make_framebuffer(colour_, 0)) {}

Image Canvas::read() const {
  Image image{width_, height_, std::vector<std::uint8_t>(std::size_t(4) * std::size_t(width_) * std::size_t(height_))};
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
  const auto row = std::ptrdiff_t(4) * width_;  // OpenGL's rows run from bottom to top
  for (int y = 0; y < height_ / 2; ++y) {
    const auto top = image.rgba.begin() + y * row;
    std::swap_ranges(top, top + row, image.rgba.begin() + (height_ - 1 - y) * row);
  }
  return image;
}

void Canvas::show(int left, int bottom) const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  glBlitFramebuffer(0, 0, width_, height_, left, bottom, left + width_, bottom + height_, GL_COLOR_BUFFER_BIT,
                    GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

}
