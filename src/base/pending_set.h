// A set of numbers, ascending, that grows by single numbers and is brought in order when somebody looks: what a step
// walks instead of looking at everything that there is.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include <sudar/base.h>

namespace sudar::inline SUDAR_PRECISION {

class PendingSet {
 public:
  void add(std::uint32_t i) {
    grown_ |= !numbers_.empty() && numbers_.back() >= i;
    numbers_.push_back(i);
  }
  void clear() { numbers_.clear(), grown_ = false; }
  // Without what does not belong any more.
  template <class Belongs>
  const std::vector<std::uint32_t>& settle(Belongs belongs) {
    std::erase_if(numbers_, [&](std::uint32_t i) { return !belongs(i); });
    if (std::exchange(grown_, false)) {
      std::sort(numbers_.begin(), numbers_.end());
      numbers_.erase(std::unique(numbers_.begin(), numbers_.end()), numbers_.end());
    }
    return numbers_;
  }

 private:
  std::vector<std::uint32_t> numbers_;
  bool grown_ = false;  // out of order
};

}
