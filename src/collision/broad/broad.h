// The contract of the broad phases. All kinds give the same pairs; only their cost differs.
#pragma once

#include <sudar/definitions.h>

#include <memory>
#include <span>
#include <vector>

namespace sudar::inline SUDAR_PRECISION {

struct Proxy {
  Box box;  // enlarged by the owner, so that small motions change nothing
  Filter filter;
  bool present = false;  // in use, and not a half space
  bool fixed = false;    // two fixed proxies never pair
};

struct ProxyPair {
  std::uint32_t a, b;  // a < b
  constexpr auto operator<=>(const ProxyPair&) const = default;
};

constexpr bool may_touch(const Filter& a, const Filter& b) {
  if (a.group == b.group && a.group != 0) return a.group > 0;
  return (a.category & b.mask) != 0 && (b.category & a.mask) != 0;
}

// Whether two proxies pair: the one test by which pairs begin (every broad phase) and end (narrow/pairs.h).
constexpr bool may_pair(const Proxy& a, const Proxy& b) {
  return a.present && b.present && !(a.fixed && b.fixed) && overlap(a.box, b.box) && may_touch(a.filter, b.filter);
}

class BroadPhase {
 public:
  virtual ~BroadPhase() = default;
  // `changed`: the proxies whose entry is new, moved or gone since the last call, ascending. Appends every overlapping
  // pair of which at least one side is in `changed`: sorted, each once, closed boxes (touching counts), filtered, never
  // both fixed.
  virtual void update(std::span<const Proxy> proxies, std::span<const std::uint32_t> changed,
                      std::vector<ProxyPair>& out) = 0;
  // Appends the proxies whose boxes, as they were at the last update, overlap the box; others do no harm, each once. In
  // no particular order.
  virtual void search(std::span<const Proxy> proxies, const Box& box, std::vector<std::uint32_t>& out) const {
    for (std::uint32_t i = 0; i < proxies.size(); ++i) {
      if (proxies[i].present && overlap(proxies[i].box, box)) out.push_back(i);
    }
  }
  // For pictures: appends the boxes that the inner structure is made of (cells with members, inner nodes), if it is of
  // boxes.
  virtual void inner_boxes(std::vector<Box>&) const {}
};

std::unique_ptr<BroadPhase> make_broad_phase(Broad kind);

}
