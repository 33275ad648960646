#include "collision/broad/brute.h"

#include "collision/broad/search.h"

namespace sudar::inline SUDAR_PRECISION {

void Brute::update(std::span<const Proxy> proxies, std::span<const std::uint32_t> changed,
                   std::vector<ProxyPair>& out) {
  std::vector<std::uint8_t> marks;
  search_pairs(proxies, changed, marks, out, [&](std::uint32_t, auto visit) {
    for (std::uint32_t j = 0; j < proxies.size(); ++j) visit(j);
  });
}

}
