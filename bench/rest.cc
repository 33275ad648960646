// What rests costs nothing: a step with few moving bodies among many fixed or many sleeping ones, beside the same step
// without them; and rays into many bodies. Processor time, the better of several runs.
//   bench_rest
#include <sudar/world.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>

namespace {

using namespace sudar;

double seconds() {
  timespec t;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}
double measure(const std::function<void()>& what) {
  const double start = seconds();
  what();
  return seconds() - start;
}

// Milliseconds a step, least of several windows.
double step_ms(World& w) {
  constexpr int windows = 7, steps = 20;
  for (int i = 0; i < 5; ++i) w.step();
  double least = 1e9;
  for (int i = 0; i < windows; ++i) {
    least = std::min(least, measure([&] {
                       for (int k = 0; k < steps; ++k) w.step();
                     }));
  }
  return 1e3 * least / steps;
}

// `fixed` tiles and a hundred cubes that slide on a hundred of them.
World tiles(int fixed) {
  Config c;
  c.sleep = false;
  World w(c);
  w.add(Gravity{});
  const Shape tile = box({10, 0.5, 10}), cube = box({0.5, 0.5, 0.5});
  const int side = int(std::ceil(std::sqrt(fixed)));
  for (int i = 0; i < fixed; ++i)
    w.add({.shape = tile, .at = {10.0 * (i % side), 0, 10.0 * (i / side)}, .motion = Motion::fixed});
  for (int i = 0; i < 100; ++i)
    w.add({.shape = cube, .at = {3 + 9.0 * (i % 10), 0.5, 3 + 9.0 * (i / 10)}, .velocity = {1, 0, 0}});
  return w;
}

// Cubes asleep on a floor, and ten spheres that roll on beside them.
World sleepers(int asleep) {
  World w;
  w.add(Gravity{});
  w.add({.shape = half_space(), .motion = Motion::fixed});
  const Shape cube = box({1, 1, 1});
  const int side = int(std::ceil(std::sqrt(asleep)));
  for (int i = 0; i < asleep; ++i) w.add({.shape = cube, .at = {2.0 * (i % side), 0.5, 2.0 * (i / side)}});
  for (int i = 0; asleep > 0 && i < 120; ++i) w.step();
  for (int i = 0; i < 10; ++i)
    w.add({.shape = sphere(0.5), .at = {-10.0 - 3 * i, 0.5, 0}, .velocity = {0, 0, 3}, .sleeps = false});
  return w;
}

void ratio(const char* what, double few, double many) {
  std::printf("%-34s %.4f ms, alone %.4f ms, ratio %.2f (less is better)\n", what, many, few, many / few);
}

}

int main() {
  World few = tiles(100), *many = nullptr;
  const double made = measure([&] { many = new World(tiles(1000000)); });
  std::printf("%-34s %.2f s\n", "making a million fixed boxes", made);
  ratio("100 moving among a million fixed", step_ms(few), step_ms(*many));
  delete many;
  World awake = sleepers(0), asleep = sleepers(100000);
  ratio("10 moving among 100,000 asleep", step_ms(awake), step_ms(asleep));

  World w;
  const Shape cube = box({1, 1, 1});
  std::uint32_t state = 1;
  const auto random = [&] {
    state = state * 1664525u + 1013904223u;
    return double(state >> 8) / 16777216.0 - 0.5;
  };
  const auto anywhere = [&] { return Pos{200 * random(), 200 * random(), 200 * random()}; };
  for (int i = 0; i < 100000; ++i) w.add({.shape = cube, .at = anywhere(), .motion = Motion::fixed});
  constexpr int rays = 100000;
  int hits = 0;
  const double time = measure([&] {
    for (int i = 0; i < rays; ++i) {
      const Vec3 direction{Real(random()), Real(random()), Real(random())};
      hits += w.ray_cast(anywhere(), normalize(direction), 1000) ? 1 : 0;
    }
  });
  std::printf("%-34s %.0f a second (more is better), %d of %d hit\n", "rays into 100,000 bodies", rays / time, hits, rays);
}
