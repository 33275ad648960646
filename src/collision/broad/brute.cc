#include "collision/broad/brute.h"

#include <algorithm>

namespace sudar::inline SUDAR_PRECISION {

void Brute::update(std::span<const Proxy> proxies, std::span<const std::uint32_t> changed,
                   std::vector<ProxyPair>& out) {
  const auto first = std::ptrdiff_t(out.size());
  for (const std::uint32_t i : changed) {
    if (!proxies[i].present) continue;
    for (std::uint32_t j = 0; j < proxies.size(); ++j) {
      if (j == i || !may_pair(proxies[i], proxies[j])) continue;
      // Two changed proxies meet twice: the smaller one reports.
      if (j < i && std::binary_search(changed.begin(), changed.end(), j)) continue;
      out.push_back({std::min(i, j), std::max(i, j)});
    }
  }
  std::sort(out.begin() + first, out.end());
}

}
