#include "ui/filming.h"

#include <algorithm>

#include "main/files.h"

namespace sudar::ui {

namespace {

constexpr int frames_per_second = 30;
constexpr std::size_t most_waiting = 8;  // pictures on their way to the packer: 30 MB

view::Image upper_left(const view::Image& image, int width, int height) {
  view::Image part{width, height, {}};
  for (int y = 0; y < height; ++y) {
    part.rgba.insert(part.rgba.end(), image.pixel(0, y), image.pixel(0, y) + std::ptrdiff_t(4) * width);
  }
  return part;
}

}

Account account_of(Simulation& simulation) {
  const auto promise = std::make_shared<std::promise<view::PngText>>();
  simulation.post([promise](History& h) { promise->set_value(app::provenance(h.run().playback())); });
  return promise->get_future().share();
}

void take_picture(Background& background, Simulation& simulation, const std::string& scene,
                  const view::Canvas& canvas) {
  background.post([&simulation, scene, image = canvas.read(), account = account_of(simulation)] {
    try {
      const std::string file = app::unused_name(scene, ".png");
      view::write_png(file, image, account.get());
      simulation.say("Picture: " + file);
    } catch (const std::exception& e) { simulation.say(e.what()); }
  });
}

Filming::Filming(Background& background, Simulation& simulation, const std::string& scene, const view::Canvas& canvas)
    : background_(background), simulation_(simulation), width_(canvas.width() & ~1), height_(canvas.height() & ~1) {
  post([scene, width = width_, height = height_, account = account_of(simulation)](Reel& reel) {
    reel.movie = app::make_movie(app::unused_name(scene, ".mp4"), width, height, frames_per_second, account.get());
  });
}

void Filming::post(std::function<void(Reel&)> job) {
  background_.post([reel = reel_, &simulation = simulation_, job = std::move(job)] {
    if (reel->failed) return;
    try {
      job(*reel);
    } catch (const std::exception& e) {
      reel->failed = true;
      simulation.say(e.what());
    }
  });
}

void Filming::add(const view::Canvas& canvas) {
  const double passed = std::chrono::duration<double>(Clock::now() - start_).count();
  const auto due = std::int64_t(passed * frames_per_second) + 1;
  if (frames_ >= due || background_.waiting() >= most_waiting) return;
  post([image = upper_left(canvas.read(), width_, height_), times = due - frames_](Reel& reel) {
    for (std::int64_t i = 0; i < times; ++i) reel.movie->add(image);
  });
  frames_ = due;
}

void Filming::finish() {
  post([&simulation = simulation_](Reel& reel) { simulation.say("Movie: " + reel.movie->finish()); });
}

}
