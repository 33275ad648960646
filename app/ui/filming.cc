#include "ui/filming.h"

#include <algorithm>

namespace sudar::ui {

namespace {

constexpr int frames_per_second = 30;

view::Image upper_left(const view::Image& image, int width, int height) {
  view::Image part{width, height, {}};
  for (int y = 0; y < height; ++y) {
    part.rgba.insert(part.rgba.end(), image.pixel(0, y), image.pixel(0, y) + std::ptrdiff_t(4) * width);
  }
  return part;
}

}

Filming::Filming(std::string file, const view::Canvas& canvas, const view::PngText& provenance)
    : width_(canvas.width() & ~1),
      height_(canvas.height() & ~1),
      movie_(app::make_movie(file, width_, height_, frames_per_second, provenance)) {}

void Filming::add(const view::Canvas& canvas) {
  const double passed = std::chrono::duration<double>(Clock::now() - start_).count();
  const auto due = std::int64_t(passed * frames_per_second) + 1;
  if (frames_ >= due) return;
  const view::Image image = upper_left(canvas.read(), width_, height_);
  for (; frames_ < due; ++frames_) movie_->add(image);
}

}
