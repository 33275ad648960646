// Levels of a contact graph: 0 for what does not move, and for every other body one more than the lowest it touches. A
// pile is then solved from the ground up (shock propagation; Guendelman, Bridson, Fedkiw 2003).
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace sudar::inline SUDAR_PRECISION {

inline constexpr std::uint32_t no_level = 0xffffffffu;  // hangs in the air: touches nothing that leads to the ground

// By body. `Contact` names its bodies a and b; answers(body): impulses move it.
template <class Contact, class Answers>
std::vector<std::uint32_t> contact_levels(std::span<const Contact> contacts, Answers answers) {
  std::uint32_t bodies = 0;
  for (const Contact& c : contacts) bodies = std::max({bodies, c.a + 1, c.b + 1});
  std::vector<std::uint32_t> level(bodies, no_level);
  for (const Contact& c : contacts) {
    for (const std::uint32_t body : {c.a, c.b}) {
      if (!answers(body)) level[body] = 0;
    }
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
