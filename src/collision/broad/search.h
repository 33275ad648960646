// What the broad phases that search around every changed proxy share: the rule by which each pair is reported once.
#pragma once

#include "collision/broad/broad.h"

#include <algorithm>

namespace sudar::inline SUDAR_PRECISION {

// 1 for each of `size` proxies that is in `changed`.
inline std::vector<std::uint8_t> mark(std::size_t size, std::span<const std::uint32_t> changed) {
  std::vector<std::uint8_t> marks(size, 0);
  for (const std::uint32_t i : changed) marks[i] = 1;
  return marks;
}

// Does what BroadPhase::update promises. `around(i, visit)` calls visit(j) once for every proxy j whose box might
// overlap that of i; others, and i itself, do no harm.
template <class Around>
void search_pairs(std::span<const Proxy> proxies, std::span<const std::uint32_t> changed, std::vector<ProxyPair>& out,
                  Around around) {
  const auto first = std::ptrdiff_t(out.size());
  const std::vector<std::uint8_t> marks = mark(proxies.size(), changed);
  for (const std::uint32_t i : changed) {
    const Proxy& proxy = proxies[i];
    if (!proxy.present) continue;
    around(i, [&](std::uint32_t j) {
      // Two changed proxies meet twice: the smaller one reports.
      if (j == i || (j < i && marks[j] != 0) || !may_pair(proxy, proxies[j])) return;
      out.push_back({std::min(i, j), std::max(i, j)});
    });
  }
  std::sort(out.begin() + first, out.end());
}

}
