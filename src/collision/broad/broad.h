// The contract of the broad phases. All kinds give the same pairs; only their cost differs.
#pragma once

#include <sudar/definitions.h>

#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace sudar::inline SUDAR_PRECISION {

struct Proxy {
  Box box;  // enlarged by the owner, so that small motions change nothing
  Filter filter;
  bool present = false;  // in use, and not a half space
  bool fixed = false;    // two fixed proxies never pair
  std::uint32_t owner = nobody;  // neither do two of one owner
  static constexpr std::uint32_t nobody = 0xffffffffu;
};

struct ProxyPair {
  std::uint32_t a, b;  // a < b
  constexpr auto operator<=>(const ProxyPair&) const = default;
};
template <class V, Like<ProxyPair> T>
void describe(V& v, T& d) { v("a", d.a, any), v("b", d.b, any); }

constexpr bool may_touch(const Filter& a, const Filter& b) {
  if (a.group == b.group && a.group != 0) return a.group > 0;
  return (a.category & b.mask) != 0 && (b.category & a.mask) != 0;
}

constexpr bool of_one_owner(const Proxy& a, const Proxy& b) { return a.owner == b.owner && a.owner != Proxy::nobody; }

// Whether two proxies pair: the one test by which pairs begin (every broad phase) and end (narrow/pairs.h).
constexpr bool may_pair(const Proxy& a, const Proxy& b) {
  return a.present && b.present && !(a.fixed && b.fixed) && overlap(a.box, b.box) && may_touch(a.filter, b.filter) &&
         !of_one_owner(a, b);
}

// A ray's way through boxes: from + t · direction for t in 0…reach.
struct BoxRay {
  BoxRay(const Pos& from, const Vec3& direction, Real reach) : from(from), reach(double(reach)) {
    for (int i = 0; i < 3; ++i) inverse[i] = 1 / double(direction[i]);
  }
  Pos from;
  Vec3d inverse;  // 1 / direction, infinite where it is 0
  double reach;   // m
  // Where it enters the box (0: it starts inside), or infinity: it does not meet it. Slabs (Kay, Kajiya 1986); where the
  // ray runs within a box's side 0 · ∞ is not a number, and the comparisons let it count as inside.
  double enters(const Box& box) const {
    double near = 0, far = reach;
    for (int i = 0; i < 3; ++i) {
      const double a = (box.low[i] - from[i]) * inverse[i], b = (box.high[i] - from[i]) * inverse[i];
      const double first = a < b ? a : b, last = a < b ? b : a;
      if (first > near) near = first;
      if (last < far) far = last;
    }
    return near <= far ? near : infinite;
  }
};

class BroadPhase {
 public:
  virtual ~BroadPhase() = default;
  // `changed`: the proxies whose entry is new, moved or gone since the last call, ascending. Appends every overlapping
  // pair of which at least one side is in `changed`: sorted, each once, closed boxes (touching counts), filtered, never
  // both fixed or of one owner.
  virtual void update(std::span<const Proxy> proxies, std::span<const std::uint32_t> changed,
                      std::vector<ProxyPair>& out) = 0;
  // Appends the proxies whose boxes, as they were at the last update, overlap the box; others do no harm, each once. In
  // no particular order.
  virtual void search(std::span<const Proxy> proxies, const Box& box, std::vector<std::uint32_t>& out) const {
    for (std::uint32_t i = 0; i < proxies.size(); ++i) {
      if (proxies[i].present && overlap(proxies[i].box, box)) out.push_back(i);
    }
  }
  // visit(proxy) for those whose boxes, as they were at the last update, the ray meets; it may shorten ray.reach. Others do
  // no harm.
  virtual void cast(std::span<const Proxy> proxies, BoxRay& ray,
                    const std::function<void(std::uint32_t)>& visit) const {
    for (std::uint32_t i = 0; i < proxies.size(); ++i) {
      if (proxies[i].present && ray.enters(proxies[i].box) < infinite) visit(i);
    }
  }
  // For pictures: appends the boxes that the inner structure is made of (cells with members, inner nodes), if it is of
  // boxes.
  virtual void inner_boxes(std::vector<Box>&) const {}
};

std::unique_ptr<BroadPhase> make_broad_phase(Broad kind);

}
