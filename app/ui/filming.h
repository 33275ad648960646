// What the window shows, into files, without holding it up: pictures and movies in real time, packed in the background.
#pragma once

#include <atomic>
#include <future>

#include "main/movie.h"
#include "ui/background.h"
#include "ui/simulation.h"
#include "view/canvas.h"

namespace sudar::ui {

// Where a picture comes from, told by the physics thread when it gets round to it.
using Account = std::shared_future<view::PngText>;
Account account_of(Simulation&);

void take_picture(Background&, Simulation&, const std::string& scene, const view::Canvas&);

// A movie of `canvas`, thirty pictures a second by the clock however many the window makes; what the packer cannot keep
// up with is left out, and the picture before it stays longer.
class Filming {
 public:
  Filming(Background&, Simulation&, const std::string& scene, const view::Canvas&);
  bool fits(const view::Canvas& canvas) const { return canvas.width() >= width_ && canvas.height() >= height_; }
  void add(const view::Canvas&);  // once a picture
  void finish();                  // tells where it is
  bool failed() const { return reel_->failed; }

 private:
  struct Reel {  // of the background thread, but for `failed`
    std::unique_ptr<app::Movie> movie;
    std::atomic<bool> failed = false;
  };
  void post(std::function<void(Reel&)>);  // what it throws ends the movie

  Background& background_;
  Simulation& simulation_;
  int width_, height_;
  std::shared_ptr<Reel> reel_ = std::make_shared<Reel>();
  std::int64_t frames_ = 0;
  Clock::time_point start_ = Clock::now();
};

}
