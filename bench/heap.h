// A heap of boxes and balls that falls and spreads: every body moves, none is hidden for good. What pictures are timed
// with, off-screen and in the window.
#pragma once

#include <sudar/world.h>

namespace sudar::inline SUDAR_PRECISION {

inline Config heap_config() {
  Config c;
  c.dt = 0.01, c.substeps = 1, c.sleep = false;
  c.impulse_2007.collision_passes = c.impulse_2007.contact_passes = 5;
  return c;
}

inline void add_heap(World& w, int bodies) {
  w.add(Gravity{});
  w.add({.shape = half_space(), .motion = Motion::fixed});
  const Shape cube = box({1, 1, 1}), ball = sphere(0.5);
  constexpr int columns = 20;
  for (int i = 0; i < bodies; ++i) {
    const int x = i % columns, z = i / columns % columns, y = i / (columns * columns);
    w.add({.shape = i % 4 == 3 ? ball : cube, .at = {1.3 * x + 0.1 * (y % 3), 1 + 1.2 * y, 1.3 * z + 0.1 * (y % 2)}});
  }
}

}
