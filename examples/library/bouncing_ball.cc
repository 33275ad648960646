// A ball that bounces: how high it is every half a second, and the hash of its motion, which is the same everywhere.
#include <sudar/world.h>

#include <cstdio>

using namespace sudar;

int main() {
  World w;
  w.add(Gravity{});
  w.add({.shape = half_space(), .material = {.restitution = Real(0.8)}, .motion = Motion::fixed});
  const Body ball = w.add({.shape = sphere(Real(0.5)), .at = {0, 4, 0}, .material = {.restitution = Real(0.8)}});
  for (int i = 0; i < 180; ++i) {
    w.step();
    if (i % 30 == 29) std::printf("%3.1f s  %5.3f m\n", w.time(), w[ball].pose().p.y);
  }
  std::printf("%016llx\n", static_cast<unsigned long long>(w.motion_hash()));
}
