#include "collision/narrow/reduce.h"

namespace sudar::inline SUDAR_PRECISION {
namespace {

constexpr Real better = Real(1.001);  // see the header

// The index of the largest value, earlier ones preferred; -1 if none is above `least`.
template <class Value>
int largest(std::span<const ManifoldPoint> candidates, Real least, Value value) {
  int best = -1;
  Real best_value = least;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const Real v = value(candidates[i]);
    if (v > best_value) {
      best = int(i);
      best_value = v * better;
    }
  }
  return best;
}

const ManifoldPoint& deepest(std::span<const ManifoldPoint> candidates, Real tie) {
  Real lowest = candidates[0].separation;
  for (const ManifoldPoint& p : candidates) lowest = min(lowest, p.separation);
  // A direction that no edge or diagonal of an ordinary shape is perpendicular to.
  constexpr Vec3 direction{Real(0.4823), Real(0.3719), Real(0.7931)};
  const ManifoldPoint* best = nullptr;
  for (const ManifoldPoint& p : candidates) {
    if (p.separation <= lowest + tie && (!best || dot(direction, p.at - best->at) > 0)) best = &p;
  }
  return *best;
}

bool is_new(const ManifoldPoint& p, const Manifold& kept, Real merge) {
  for (int i = 0; i < kept.count; ++i) {
    if (length_squared(p.at - kept.points[std::size_t(i)].at) <= square(merge)) return false;
  }
  return true;
}

void keep(const ManifoldPoint& p, Real merge, Manifold& out) {
  if (is_new(p, out, merge)) out.points[std::size_t(out.count++)] = p;
}

}

void reduce(std::span<const ManifoldPoint> candidates, const Vec3& normal, Real tie, Real merge, Manifold& out) {
  out.count = 0;
  if (candidates.size() <= 4) {
    for (const ManifoldPoint& p : candidates) keep(p, merge, out);
    return;
  }
  const ManifoldPoint& first = deepest(candidates, tie);
  keep(first, merge, out);
  const int far = largest(candidates, square(merge), [&](auto& p) { return length_squared(p.at - first.at); });
  if (far < 0) return;
  const ManifoldPoint& second = candidates[std::size_t(far)];
  keep(second, merge, out);
  const Vec3 across = cross(normal, second.at - first.at);
  const Real least = merge * length(across);
  for (const Real side : {Real(1), Real(-1)}) {
    const int i = largest(candidates, least, [&](auto& p) { return side * dot(across, p.at - first.at); });
    if (i >= 0) keep(candidates[std::size_t(i)], merge, out);
  }
}

}
