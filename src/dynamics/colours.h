// Colouring of contacts: contacts of one colour share no body that answers impulses, so they may be solved side by side
// in any order. Each contact in turn takes the lowest colour that is free on its bodies. Colours depend on the bodies of
// its own island alone, and decide the order of solving: between moving bodies first, those that hold to what stands last.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

namespace sudar {

class Colours {
 public:
  // `sides(k)`: the two bodies of contact k, 0 for one that does not answer. Bodies are numbers below `bodies`.
  template <class Sides>
  void assign(std::uint32_t count, std::uint32_t bodies, Sides sides) {
    used_.assign(bodies, {});
    colour_.resize(count);
    std::array<std::uint32_t, colours + 1> sizes{};
    for (std::uint32_t k = 0; k < count; ++k) {
      const auto [a, b] = sides(k);
      std::uint64_t Used::*kind = a != 0 && b != 0 ? &Used::moving : &Used::still;
      const std::uint64_t taken = (a != 0 ? used_[a].*kind : 0) | (b != 0 ? used_[b].*kind : 0);
      const auto free = std::uint32_t(std::countr_one(taken));
      if (free < half) {
        if (a != 0) used_[a].*kind |= std::uint64_t(1) << free;
        if (b != 0) used_[b].*kind |= std::uint64_t(1) << free;
        colour_[k] = free + (kind == &Used::still ? half : 0) + 1;
      } else {
        colour_[k] = crowded;
      }
      ++sizes[colour_[k]];
    }
    std::uint32_t first = 0;
    for (std::uint32_t c = 0; c <= colours; ++c) {
      first_[c] = first;
      first += sizes[c];
    }
    first_[colours + 1] = first;
    order_.resize(count);
    std::array<std::uint32_t, colours + 1> next;
    std::copy_n(first_.begin(), next.size(), next.begin());
    for (std::uint32_t k = 0; k < count; ++k) order_[next[colour_[k]]++] = k;
  }

  // visit(contact, group, lane) in the order of solving: groups of at most `lanes` that share no body. Inside a colour,
  // where the order does not matter, contacts of class(k) 0 come first, then 1, then 2: most groups are of one class.
  template <class Class, class Visit>
  void each_group(std::uint32_t lanes, Class class_of, Visit visit) const {
    std::uint32_t group = 0;
    for (std::uint32_t colour = 0; colour <= colours; ++colour) {
      if (of(colour).empty()) continue;
      const bool sorted = colour != crowded;
      const std::uint32_t most = sorted ? lanes : 1;
      std::uint32_t lane = 0;
      for (int c = 0; c < (sorted ? 3 : 1); ++c) {
        for (const std::uint32_t k : of(colour)) {
          if (sorted && class_of(k) != c) continue;
          if (lane == most) lane = 0, ++group;
          visit(k, group, lane++);
        }
      }
      ++group;
    }
  }

  static constexpr std::uint32_t half = 64, colours = 2 * half;
  static constexpr std::uint32_t crowded = 0;  // what found no colour: one after the other, first
  // The contacts of a colour, ascending.
  std::span<const std::uint32_t> of(std::uint32_t colour) const {
    return std::span(order_).subspan(first_[colour], first_[colour + 1] - first_[colour]);
  }

 private:
  struct Used {
    std::uint64_t moving = 0, still = 0;  // bits of colours among contacts of moving bodies, and with what stands
  };
  std::vector<Used> used_;
  std::vector<std::uint32_t> colour_, order_;
  std::array<std::uint32_t, colours + 2> first_{};
};

}
