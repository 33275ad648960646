// What cases with many balls are built from. What is known of grains is measured, not derived: ranges. Lengths are in
// diameters of a grain, which is 1 m: the laws have no length of their own.
#pragma once

#include "verify/numerics.h"
#include "verify/scene.h"

namespace sudar::verify {

inline constexpr double grain_mass = 1;

// A shaft of width × width about the y axis, open above and below.
inline void add_shaft(World& w, double width, const Material& m) {
  for (int side = 0; side < 4; ++side) {
    const double angle = side * pi / 2;
    const Quat turn =
        axis_angle(Vec3{0, 1, 0}, Real(angle)) * axis_angle(Vec3{0, 0, 1}, Real(pi / 2));  // y to −x, and on
    add_ground(w, m, Pos{} - rotate(convert<double>(turn), Vec3d{0, width / 2, 0}), turn);
  }
}

inline Body add_grain(World& w, const Pos& at, const Material& m, const Vec3& velocity = {}) {
  return w.add({.shape = sphere(0.5), .at = at, .velocity = velocity, .mass = Real(grain_mass), .material = m});
}

// n grains in the shaft above y, loosely, each a little off its place.
inline std::vector<Body> fill(World& w, int n, double width, double y, const Material& m, Random& random) {
  const int side = int(width / 1.25);  // room to fall out of order
  const double pitch = width / side;
  std::vector<Body> grains;
  for (int i = 0; i < n; ++i) {
    const double wobble = (pitch - 1) / 2;
    const auto place = [&](int k) { return (k + 0.5) * pitch - width / 2 + random.between(-wobble, wobble); };
    grains.push_back(
        add_grain(w, {place(i % side), y + 0.55 + 1.1 * double(i / (side * side)), place(i / side % side)}, m));
  }
  return grains;
}

}
