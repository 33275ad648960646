// The default broad phase: two hierarchies of bounding boxes (box_tree.h), one for what is fixed and one for the rest,
// searched around every changed proxy. O(changed · (log n + what it overlaps)); what rests costs nothing.
//
// Two trees, because two fixed proxies never pair: a fixed proxy that changes searches the moving tree alone, and a
// terrain of many fixed proxies is never rebuilt for the sake of what moves over it. The boxes are already enlarged by
// their owner, so that a leaf moves once in many steps.
//
// The first of its kind for moving bodies was Volino & Magnenat-Thalmann's and van den Bergen's refitted trees (1994,
// 1997); the idea of enlarged boxes with insertion by cost comes from Presson's Bullet dynamic tree (2008).
#pragma once

#include "collision/broad/box_tree.h"

#include <array>

namespace sudar::inline SUDAR_PRECISION {

class Tree final : public BroadPhase {
 public:
  void update(std::span<const Proxy> proxies, std::span<const std::uint32_t> changed,
              std::vector<ProxyPair>& out) override;
  void search(std::span<const Proxy> proxies, const Box& box, std::vector<std::uint32_t>& out) const override;
  void cast(std::span<const Proxy> proxies, BoxRay& ray,
            const std::function<void(std::uint32_t)>& visit) const override;
  void inner_boxes(std::vector<Box>& out) const override;

 private:
  struct Place {
    std::uint32_t leaf = BoxTree::none;  // none: not present
    bool fixed = false;                  // in which tree
  };
  void follow(std::uint32_t i, const Proxy&);

  std::array<BoxTree, 2> trees_;  // of what moves, of what is fixed
  std::vector<Place> places_;     // by proxy
  std::vector<std::uint8_t> marks_;
};

}
