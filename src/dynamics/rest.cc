#include "dynamics/rest.h"

#include <algorithm>

namespace sudar::inline SUDAR_PRECISION {

namespace {

constexpr Real shortest = Real(0.5);   // quiet time, s
constexpr Real near = Real(1e-5);      // what sleeps is as near to where it would come to rest, m and rad
constexpr Real slow = Real(3e-3);      // m/s, of every point
constexpr Real horizon = 5;            // s
constexpr Real farthest = Real(2e-6);  // in a quiet time, m and rad: noise of contacts that hold

// How far the body got since its quiet time began: of its centre, of its farthest point, and as an angle, the largest.
// An orientation's rounding can swallow a slow turn: there, that the spin changes tells that the body will go on.
Real reach(const Bodies& b, std::uint32_t i, Real length_unit) {
  const Real way = length(b.position[i] - b.quiet_from[i]) / length_unit;
  const Quat turn = b.orientation[i] * conjugate(b.quiet_orientation[i]);
  const Real angle = max(2 * length(Vec3{turn.x, turn.y, turn.z}), length(b.quiet_turn[i]));
  return max(way, angle * max(Real(1), b.radius[i] / length_unit));
}

}

void watch_rest(Bodies& b, std::span<const std::uint32_t> awake, Real length_unit, Real h) {
  for (const std::uint32_t i : awake) {
    const Real speed = max(length(b.velocity[i]), length(b.spin[i]) * b.radius[i]);
    b.slow_time[i] = speed <= slow * length_unit ? b.slow_time[i] + h : 0;
    if (b.quiet_time[i] > 0) {
      b.quiet_turn[i] += (b.spin[i] - b.quiet_spin[i]) * h;
      b.quiet_reach[i] = max(b.quiet_reach[i], reach(b, i, length_unit));
      b.quiet_time[i] += h;
    }
    if (b.quiet_time[i] > 0 && b.quiet_reach[i] <= farthest) continue;
    b.quiet_from[i] = b.position[i];
    b.quiet_orientation[i] = b.orientation[i];
    b.quiet_spin[i] = b.spin[i];
    b.quiet_turn[i] = {};
    b.quiet_reach[i] = 0;
    b.quiet_time[i] = h;
  }
}

void HeldByFaces::contact(std::uint32_t a, std::uint32_t b, const ContactImpulse& impulse, bool slipping) {
  const auto pressed = std::count_if(impulse.normal.begin(), impulse.normal.end(), [](Real n) { return n > 0; });
  if (pressed == 0) return;
  for (const std::uint32_t i : {a, b}) (pressed < 3 || slipping ? loose_ : pressed_)[i] = 1;
}

void HeldByFaces::joint(std::uint32_t a, std::uint32_t b) {
  for (const std::uint32_t i : {a, b}) {
    if (i != no_body) loose_[i] = 1;
  }
}

// Who gathers speed gets (t/T)² times as far in t as in T.
bool rests(const Bodies& b, std::uint32_t i, bool held) {
  if (held && b.slow_time[i] >= shortest) return true;
  const Real time = b.quiet_time[i];
  return time >= shortest && b.quiet_reach[i] * square(horizon) <= near * square(time);
}

}
