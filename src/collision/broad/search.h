// What the broad phases that search around every changed proxy share: the rule by which each pair is reported once.
#pragma once

#include "collision/broad/broad.h"

#include <algorithm>

namespace sudar::inline SUDAR_PRECISION {

// Does what BroadPhase::update promises. `around(i, visit)` calls visit(j) once for every proxy j whose box might
// overlap that of i; others, and i itself, do no harm. `marks`: memory, all 0 between calls.
template <class Around>
void search_pairs(std::span<const Proxy> proxies, std::span<const std::uint32_t> changed,
                  std::vector<std::uint8_t>& marks, std::vector<ProxyPair>& out, Around around) {
  const auto first = std::ptrdiff_t(out.size());
  if (marks.size() < proxies.size()) marks.resize(proxies.size());
  for (const std::uint32_t i : changed) marks[i] = 1;
  for (const std::uint32_t i : changed) {
    const Proxy& proxy = proxies[i];
    if (!proxy.present) continue;
    around(i, [&](std::uint32_t j) {
      // Two changed proxies meet twice: the smaller one reports.
      if (j == i || (j < i && marks[j] != 0) || !may_pair(proxy, proxies[j])) return;
      out.push_back({std::min(i, j), std::max(i, j)});
    });
  }
  for (const std::uint32_t i : changed) marks[i] = 0;
  std::sort(out.begin() + first, out.end());
}

}
