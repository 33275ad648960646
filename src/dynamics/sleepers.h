// Islands that sleep. Bodies that fell asleep together wake together: each such island is a ring, so that from any of its
// bodies all others are found without a look at those that do not belong to it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include <sudar/base.h>

namespace sudar::inline SUDAR_PRECISION {

// A function of who sleeps with whom; by body slot.
class Sleepers {
 public:
  void clear() { next_.clear(), islands_.clear(); }
  void add(std::span<const std::uint32_t> island) {
    for (std::size_t k = 0; k < island.size(); ++k) {
      if (island[k] >= next_.size()) next_.resize(std::size_t(island[k]) + 1);
      next_[island[k]] = island[(k + 1) % island.size()];
    }
    islands_.push_back(island.front());
  }
  // visit(body) for each body that fell asleep with this one; it may wake them.
  template <class Visit>
  void each_with(std::uint32_t body, Visit visit) const {
    std::uint32_t i = body;
    do {
      const std::uint32_t next = next_[i];
      visit(i);
      i = next;
    } while (i != body);
  }
  // One body of every island; asleep(body) tells islands that woke since, which are forgotten.
  template <class Asleep>
  std::vector<std::uint32_t> one_of_each(Asleep asleep) {
    std::sort(islands_.begin(), islands_.end());
    islands_.erase(std::unique(islands_.begin(), islands_.end()), islands_.end());
    std::erase_if(islands_, [&](std::uint32_t i) { return !asleep(i); });
    return islands_;
  }
  bool none() const { return islands_.empty(); }

 private:
  std::vector<std::uint32_t> next_, islands_;
};

}
