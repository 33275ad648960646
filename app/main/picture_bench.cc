#include "main/picture_bench.h"

#include <atomic>
#include <chrono>
#include <ctime>
#include <functional>
#include <thread>

#include "bench/heap.h"
#include "bench/meter.h"
#include "main/priority.h"
#include "view/offscreen.h"

namespace sudar::app {

using namespace view;

namespace {

using Clock = std::chrono::steady_clock;

double milliseconds(Clock::time_point since) {
  return std::chrono::duration<double, std::milli>(Clock::now() - since).count();
}

// Pictures one after the other from a camera on the move, until `over`.
PictureCost::Picture draw_pictures(Offscreen& offscreen, const Scene& scene, Finish finish, int width, int height,
                                   const std::function<bool(int)>& over) {
  Style style;
  style.set(finish);
  const Camera start = framing(scene, double(width) / height);
  std::vector<double> times;
  constexpr int warm_up = 2;
  std::clock_t from = 0;
  for (int i = 0; !over(i); ++i) {
    if (i == warm_up) from = std::clock();
    Camera camera = start;
    camera.eye.x += 0.05 * (i % 40);
    const Clock::time_point begin = Clock::now();
    offscreen.picture(scene, camera, style, width, height);
    if (i >= warm_up) times.push_back(milliseconds(begin));
  }
  if (times.empty()) return {};
  return {bench::median(times), 1e3 * double(std::clock() - from) / CLOCKS_PER_SEC / double(times.size())};
}

double thread_microseconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return 1e6 * double(t.tv_sec) + 1e-3 * double(t.tv_nsec);
}

struct StepCost {
  double us, clock_us;
};
StepCost step_world(World& w, int steps) {
  std::vector<double> own, clock;
  for (int i = 0; i < steps; ++i) {
    const Clock::time_point begin = Clock::now();
    const double before = thread_microseconds();
    w.step();
    own.push_back(thread_microseconds() - before);
    clock.push_back(1e3 * milliseconds(begin));
  }
  return {bench::median(own), bench::median(clock)};
}

}

PictureCost measure_pictures(int bodies, int width, int height) {
  constexpr int pictures = 20, steps = 60;
  World w(heap_config());
  add_heap(w, bodies);
  for (int i = 0; i < 100; ++i) w.step();
  PictureCost cost;
  cost.width = width, cost.height = height, cost.bodies = w.bodies().size() - 1;
  const Scene scene = make_scene(w);
  const Bytes start = w.save();
  const StepCost by_itself = step_world(w, steps);
  w.load(start);
  std::atomic<bool> alone = true, stepped = false;
  std::thread painter([&] {
    step_back();
    Offscreen offscreen;
    cost.driver = offscreen.driver();
    const auto enough = [](int n) { return n >= pictures; };
    cost.plain = draw_pictures(offscreen, scene, Finish::plain, width, height, enough);
    cost.fine = draw_pictures(offscreen, scene, Finish::fine, width, height, enough);
    alone = false;
    alone.notify_one();
    draw_pictures(offscreen, scene, Finish::plain, width, height, [&](int) { return stepped.load(); });
  });
  alone.wait(true);
  const StepCost beside = step_world(w, steps);
  stepped = true;
  painter.join();
  cost.alone_us = by_itself.us, cost.alone_clock_us = by_itself.clock_us;
  cost.beside_us = beside.us, cost.beside_clock_us = beside.clock_us;
  return cost;
}

}
