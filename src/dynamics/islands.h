// Islands: bodies that hang together through contacts and joints. Fixed and kinematic bodies join nothing.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <sudar/base.h>

#include "base/room.h"

namespace sudar::inline SUDAR_PRECISION {

// Union–find over body slots. The root of an island is its smallest slot, whatever the order of the unions, so the order
// of islands does not depend on that of contacts.
class Unions {
 public:
  // Makes each of `bodies` an island of its own; others mean nothing until they are given here.
  void reset(std::uint32_t slots, std::span<const std::uint32_t> bodies) {
    make_room(parent_, slots);
    for (const std::uint32_t i : bodies) parent_[i] = i;
  }
  std::uint32_t root(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void unite(std::uint32_t a, std::uint32_t b) {
    a = root(a), b = root(b);
    if (a < b) parent_[b] = a;
    else parent_[a] = b;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

struct Island {
  struct Part {
    std::uint32_t first = 0, count = 0;
    template <class T>
    std::span<T> of(std::span<T> all) const { return all.subspan(first, count); }
  };
  Part bodies, contacts, joints, near;  // of the lists in which everything is island after island
  bool linked = false;            // touches or hangs on something, be it the floor
};

// Puts `numbers`, each of which belongs to island(number), into the order of their islands and keeps their order inside.
// `part` names the Part of an Island.
template <class IslandOf>
void sort_by_island(std::vector<Island>& islands, Island::Part Island::*part, std::span<const std::uint32_t> numbers,
                    IslandOf island, std::vector<std::uint32_t>& out) {
  for (Island& i : islands) (i.*part) = {};
  for (const std::uint32_t n : numbers) ++(islands[island(n)].*part).count;
  std::uint32_t first = 0;
  for (Island& i : islands) {
    (i.*part).first = first;
    first += (i.*part).count;
    (i.*part).count = 0;
  }
  out.resize(numbers.size());
  for (const std::uint32_t n : numbers) {
    Island::Part& p = islands[island(n)].*part;
    out[p.first + p.count++] = n;
  }
}

}
