#include "world/crowds.h"

#include <bit>

namespace sudar::inline SUDAR_PRECISION {

namespace {

constexpr std::uint32_t few = 8;
constexpr Real deep_share = Real(0.9);  // of the distance at which two balls touch

class Crowds {
 public:
  Crowds(const World::Impl& w, std::span<const ProxyPair> pairs) : w_(w), pairs_(pairs) {}

  // Whether there is one. A glance first, at the partners of greater number: there rarely are so many.
  bool find() {
    std::uint32_t partners = 0, of = no_body;
    const bool many = std::ranges::any_of(pairs_, [&](const ProxyPair& p) {
      if (p.a != of) of = p.a, partners = 0;
      return both_move(p) && ++partners > few;
    });
    if (!many) return false;
    inner_.assign(w_.bodies.shapes.size(), -1);
    deep_in_.assign(w_.bodies.shapes.size(), 0);
    for (const ProxyPair& p : pairs_) {
      if (both_move(p) && deep(p)) ++deep_in_[p.a], ++deep_in_[p.b];
    }
    return std::ranges::any_of(pairs_, [&](const ProxyPair& p) { return crowded(p); });
  }

  // By pair: whether it is one of those that are too many.
  std::vector<std::uint8_t> too_many() const {
    std::vector<std::uint32_t> before(w_.bodies.shapes.size(), 0);  // partners of smaller number
    for (const ProxyPair& p : pairs_) before[p.b] += crowded(p) ? 1 : 0;
    // Whether shape i, whose own place is that after `before`, keeps its n-th partner.
    const auto keeps = [&](std::uint32_t i, std::uint32_t n) {
      return std::has_single_bit(n < before[i] ? before[i] - n : n - before[i] + 1);
    };
    std::vector<std::uint32_t> passed(w_.bodies.shapes.size(), 0);  // of the partners, which come in ascending order
    std::vector<std::uint8_t> marks(pairs_.size(), 0);
    for (std::size_t k = 0; k < pairs_.size(); ++k) {
      const ProxyPair& p = pairs_[k];
      if (!crowded(p)) continue;
      const bool by_a = keeps(p.a, passed[p.a]++), by_b = keeps(p.b, passed[p.b]++);
      marks[k] = by_a || by_b ? 0 : 1;
    }
    return marks;
  }

 private:
  bool both_move(const ProxyPair& p) const { return w_.bodies.dynamic(body(p.a)) && w_.bodies.dynamic(body(p.b)); }
  bool crowded(const ProxyPair& p) const { return deep_in_[p.a] > few && deep_in_[p.b] > few; }

  bool deep(const ProxyPair& p) {
    const Real reach = deep_share * (inner(p.a) + inner(p.b));
    return length_squared(center(p.a) - center(p.b)) < square(reach);
  }
  std::uint32_t body(std::uint32_t s) const { return w_.bodies.shapes.body[s]; }
  Pos center(std::uint32_t s) const { return w_.bodies.center_pose(body(s)).point(w_.bodies.shapes.center[s]); }
  Real inner(std::uint32_t i) {
    if (inner_[i] < 0) inner_[i] = inner_radius(w_.geometry_of(i));
    return inner_[i];
  }

  const World::Impl& w_;
  std::span<const ProxyPair> pairs_;
  std::vector<Real> inner_;             // by shape, m; below 0: not asked yet
  std::vector<std::uint32_t> deep_in_;  // by shape: how many others
};

}

void thin_crowds(World::Impl& w, std::vector<std::uint32_t>& pairs) {
  std::vector<ProxyPair> keys;
  keys.reserve(pairs.size());
  for (const std::uint32_t p : pairs) keys.push_back({w.pairs.watches()[p].a, w.pairs.watches()[p].b});
  Crowds crowds(w, keys);
  if (!crowds.find()) return;
  const std::vector<std::uint8_t> too_many = crowds.too_many();
  std::size_t left = 0;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (too_many[k] == 0) {
      pairs[left++] = pairs[k];
      continue;
    }
    Manifold& manifold = w.pairs[pairs[k]].manifold;
    const bool touched = (manifold.bits & Manifold::touching) != 0;
    manifold.count = 0;
    manifold.bits = touched ? std::uint32_t(Manifold::ended) : 0;
    w.looked_at[pairs[k]] = touched ? 1 : 0;
  }
  pairs.resize(left);
}

}
