// Levels of a contact graph: 0 for what does not move, and for every other body one more than the lowest it touches. A
// pile is then solved from the ground up (shock propagation; Guendelman, Bridson, Fedkiw 2003).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dynamics/bodies.h"

namespace sudar::inline SUDAR_PRECISION {

inline constexpr std::uint32_t no_level = 0xffffffffu;  // hangs in the air: touches nothing that leads to the ground

// By body slot. `Contact` has the body slots a and b.
template <class Contact>
std::vector<std::uint32_t> contact_levels(std::span<const Contact> contacts, const Bodies& bodies) {
  std::vector<std::uint32_t> level(bodies.size(), no_level);
  for (std::uint32_t i = 0; i < bodies.size(); ++i) {
    if (!bodies.dynamic(i)) level[i] = 0;
  }
  for (std::uint32_t reached = 0;; ++reached) {
    bool grew = false;
    for (const Contact& c : contacts) {
      for (const auto& [from, to] : {std::pair{c.a, c.b}, std::pair{c.b, c.a}}) {
        if (level[from] != reached || level[to] != no_level) continue;
        level[to] = reached + 1;
        grew = true;
      }
    }
    if (!grew) return level;
  }
}

}
