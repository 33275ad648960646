// Contacts in small groups whose members share no body that answers impulses, so that a processor works on all of them
// at once instead of waiting for one. Contacts that do share a body keep their order: the result has the same bits as
// contact by contact.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace sudar::inline SUDAR_PRECISION {

struct ContactGroup {
  static constexpr std::size_t most = 4;
  std::array<std::uint32_t, most> members;  // numbers in the list, ascending
  std::size_t count = 0;
};

// `sides(k)`: the two bodies of contact k, `still` for one that does not answer.
template <class Sides>
void group_contacts(std::uint32_t count, std::uint32_t still, Sides sides, std::vector<ContactGroup>& out) {
  constexpr std::uint32_t farthest = 16;  // looked ahead
  out.clear();
  std::vector<std::uint8_t> taken(count, 0);
  for (std::uint32_t first = 0; first < count; ++first) {
    if (taken[first] != 0) continue;
    std::array<std::uint32_t, 2 * farthest + 4> before;  // bodies of the members, and of those that are overtaken
    std::size_t known = 0;
    const auto meets = [&](std::uint32_t k) {
      for (const std::uint32_t body : sides(k)) {
        for (std::size_t n = 0; n < known; ++n) {
          if (body != still && before[n] == body) return true;
        }
      }
      return false;
    };
    ContactGroup group;
    for (std::uint32_t k = first; k < count && k <= first + farthest && group.count < ContactGroup::most; ++k) {
      if (taken[k] != 0) continue;
      if (!meets(k)) group.members[group.count++] = k, taken[k] = 1;
      for (const std::uint32_t body : sides(k)) before[known++] = body;
    }
    out.push_back(group);
  }
}

}
