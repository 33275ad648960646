// Islands: bodies that hang together through contacts and joints. Fixed and kinematic bodies join nothing.
#pragma once

#include <cstdint>
#include <vector>

#include <sudar/base.h>

namespace sudar::inline SUDAR_PRECISION {

// Union–find over body slots. The root of an island is its smallest slot, whatever the order of the unions, so island
// numbers do not depend on the order of contacts.
class Islands {
 public:
  void reset(std::uint32_t bodies) {
    parent_.resize(bodies);
    linked_.assign(bodies, 0);
    for (std::uint32_t i = 0; i < bodies; ++i) parent_[i] = i;
  }
  std::uint32_t root(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void unite(std::uint32_t a, std::uint32_t b) {
    link(a), link(b);
    a = root(a), b = root(b);
    if (a < b) parent_[b] = a;
    else parent_[a] = b;
  }
  // A body that touches or hangs on something that joins nothing (the floor, the world) is linked all the same.
  void link(std::uint32_t i) { linked_[i] = 1; }
  bool linked(std::uint32_t i) const { return linked_[i] != 0; }

 private:
  std::vector<std::uint32_t> parent_;
  std::vector<std::uint8_t> linked_;
};

}
