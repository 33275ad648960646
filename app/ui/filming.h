// A movie of what the window shows, in its time: a picture that came late stands for the ones that it kept waiting.
#pragma once

#include "main/movie.h"
#include "ui/simulation.h"
#include "view/canvas.h"

namespace sudar::ui {

class Filming {
 public:
  Filming(std::string file, const view::Canvas&, const view::PngText& provenance);  // throws Error
  bool fits(const view::Canvas& c) const { return c.width() >= width_ && c.height() >= height_; }
  void add(const view::Canvas&);  // as often as is due
  std::string finish() { return movie_->finish(); }

 private:
  int width_, height_;  // even, as the codecs want it
  Clock::time_point start_ = Clock::now();
  std::int64_t frames_ = 0;
  std::unique_ptr<app::Movie> movie_;
};

}
