// The reference broad phase, thesis (3.25): every changed proxy against every other one, O(n · changed). No state, so
// nothing to keep up to date and nothing to get wrong; the others must give its pairs.
#pragma once

#include "collision/broad/broad.h"

namespace sudar::inline SUDAR_PRECISION {

class Brute final : public BroadPhase {
 public:
  void update(std::span<const Proxy> proxies, std::span<const std::uint32_t> changed,
              std::vector<ProxyPair>& out) override;
};

}
