// Contacts two by two: each pair shares no body that answers, so that a processor works on both at once instead of waiting
// for one. Contacts that do share one keep their order, so the result has the same bits as contact by contact.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace sudar::inline SUDAR_PRECISION {

inline constexpr std::uint32_t no_contact = 0xffffffffu;

struct ContactPair {
  std::uint32_t first, second;  // numbers in the list; second: no_contact where none fits
};

// `sides(k)`: the two bodies of contact k, `still` for one that does not answer.
template <class Sides>
void pair_contacts(std::uint32_t count, std::uint32_t still, Sides sides, std::vector<ContactPair>& out) {
  constexpr std::uint32_t farthest = 12;  // looked ahead
  out.clear();
  std::vector<std::uint8_t> taken(count, 0);
  for (std::uint32_t first = 0; first < count; ++first) {
    if (taken[first] != 0) continue;
    std::uint32_t before[2 * farthest + 4];  // bodies of those that would be overtaken
    std::size_t known = 0;
    const auto meets = [&](std::uint32_t k) {
      for (const std::uint32_t body : sides(k)) {
        if (body == still) continue;
        for (std::size_t n = 0; n < known; ++n) {
          if (before[n] == body) return true;
        }
      }
      return false;
    };
    const auto note = [&](std::uint32_t k) {
      for (const std::uint32_t body : sides(k)) before[known++] = body;
    };
    note(first);
    std::uint32_t second = no_contact;
    for (std::uint32_t k = first + 1; k < count && k <= first + farthest; ++k) {
      if (taken[k] != 0) continue;
      if (!meets(k)) {
        second = k, taken[k] = 1;
        break;
      }
      note(k);
    }
    out.push_back({first, second});
  }
}

}
