// Random numbers for tests: the same on every platform, unlike std:: distributions.
#pragma once

#include <sudar/math.h>

#include <cstdint>

namespace sudar_test {

class Random {
 public:
  explicit Random(std::uint64_t seed = 1) : state_(seed) {}

  std::uint64_t bits() {  // splitmix64 (Steele, Lea, Flood 2014)
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  double fraction() { return double(bits() >> 11) * 0x1p-53; }  // in [0, 1)
  double between(double low, double high) { return low + (high - low) * fraction(); }
  int whole(int low, int high) { return low + int(bits() % std::uint64_t(high - low + 1)); }  // both included
  sudar::Vec3d in_cube(double half = 1) { return {between(-half, half), between(-half, half), between(-half, half)}; }
  sudar::Vec3d direction() {
    for (;;) {
      const sudar::Vec3d v = in_cube();
      const double l = length(v);
      if (l > 0.01 && l < 1) return v / l;
    }
  }
  sudar::Quatd rotation() {
    for (;;) {
      const sudar::Quatd q{between(-1, 1), between(-1, 1), between(-1, 1), between(-1, 1)};
      const double l = length_squared(q);
      if (l > 0.01 && l < 1) return normalize(q);
    }
  }

 private:
  std::uint64_t state_;
};

}
