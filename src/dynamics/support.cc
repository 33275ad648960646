#include "dynamics/support.h"

#include <algorithm>

namespace sudar::inline SUDAR_PRECISION {

namespace {

// Points of support in the horizontal plane, and how much each carries.
struct Foot {
  Real x, y;
  Real load;
  bool on;
};

// The smallest loads that add up to `load` about (x, y), as far as pushing alone can: what would have to pull is left
// out, three times. Least norm: load = α + β x + γ y. Returns how far from (x, y) they end up.
Real distribute(std::span<Foot> feet, Real load, Real x, Real y) {
  for (int round = 0; round < 3; ++round) {
    Real n = 0, mx = 0, my = 0;
    for (const Foot& f : feet) {
      if (f.on) n += 1, mx += f.x, my += f.y;
    }
    if (n == 0) break;
    mx /= n, my /= n;
    Real xx = 0, xy = 0, yy = 0;
    for (const Foot& f : feet) {
      if (f.on) xx += square(f.x - mx), xy += (f.x - mx) * (f.y - my), yy += square(f.y - my);
    }
    // Feet in a line, or a single one, hold no moment about it: a thousandth of the spread stands for what is missing.
    const Real room = Real(1e-3) * (xx + yy);
    const Real a = xx + room, b = yy + room, det = a * b - xy * xy;
    const Real dx = load * (x - mx), dy = load * (y - my);
    const Real beta = det > 0 ? (b * dx - xy * dy) / det : Real(0);
    const Real gamma = det > 0 ? (a * dy - xy * dx) / det : Real(0);
    bool pulled = false;
    Real sum = 0;
    for (Foot& f : feet) {
      if (!f.on) continue;
      f.load = load / n + beta * (f.x - mx) + gamma * (f.y - my);
      if (f.load <= 0) f.load = 0, f.on = false, pulled = true;
      sum += f.load;
    }
    if (!pulled) break;
    for (Foot& f : feet) {
      if (f.on && sum > 0) f.load *= load / sum;
    }
  }
  Real mx = 0, my = 0;
  for (const Foot& f : feet) mx += f.load * f.x, my += f.load * f.y;
  return sqrt(square(mx / load - x) + square(my / load - y));
}

}

// From the ground up: who stands on it, or on who does.
void SupportLoads::ground(std::span<const Support> supports) {
  grounded_.assign(carried_.size(), 0);
  for (std::size_t n = order_.size(); n-- > 0;) {
    const std::uint32_t i = order_[n];
    for (std::uint32_t k = first_[i]; k < first_[i + 1]; ++k) {
      const std::uint32_t lower = supports[list_[k]].lower;
      if (lower == 0 || grounded_[lower] != 0) grounded_[i] = 1;
    }
  }
}

void SupportLoads::solve(std::span<Support> supports, std::span<const std::uint32_t> which,
                         std::span<const Real> weight, std::span<const double> height, std::span<const Real> radius,
                         const Vec3& up) {
  constexpr Real tilting = Real(0.05);
  carried_.assign(weight.size(), {});
  first_.assign(weight.size() + 1, 0);
  for (const Support& s : supports) ++first_[s.upper + 1];
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  list_.resize(supports.size());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::uint32_t k = 0; k < supports.size(); ++k) list_[next[supports[k].upper]++] = k;
  order_.assign(which.begin(), which.end());
  std::ranges::stable_sort(order_, [&](std::uint32_t i, std::uint32_t j) { return height[i] > height[j]; });
  ground(supports);
  const Vec3 e1 = any_perpendicular(up), e2 = cross(up, e1);
  std::vector<Foot> feet;
  for (const std::uint32_t i : order_) {
    const std::span<const std::uint32_t> own = std::span(list_).subspan(first_[i], first_[i + 1] - first_[i]);
    if (own.empty()) continue;
    const Real load = carried_[i].load + weight[i];
    if (!(load > 0)) continue;
    const Vec3 centre = carried_[i].moment / load;
    feet.clear();
    for (const std::uint32_t k : own) {
      const Support& s = supports[k];
      if (s.lower != 0 && !grounded_[s.lower]) continue;
      for (std::size_t p = 0; p < s.count; ++p) {
        if (s.carries[p]) feet.push_back({dot(s.arm_upper[p], e1), dot(s.arm_upper[p], e2), 0, true});
      }
    }
    if (distribute(feet, load, dot(centre, e1), dot(centre, e2)) > tilting * radius[i]) continue;  // it topples
    std::size_t foot = 0;
    for (const std::uint32_t k : own) {
      Support& s = supports[k];
      if (s.lower != 0 && !grounded_[s.lower]) continue;
      for (std::size_t p = 0; p < s.count; ++p) {
        if (!s.carries[p]) continue;
        const Real l = feet[foot++].load;
        s.load[p] = l / s.steepness;
        if (s.lower == 0) continue;
        carried_[s.lower].load += l;
        carried_[s.lower].moment += s.arm_lower[p] * l;
      }
    }
  }
}

}
