#include "collision/broad/tree.h"

#include "base/room.h"
#include "collision/broad/search.h"

namespace sudar::inline SUDAR_PRECISION {

// Brings the trees up to date with one proxy.
void Tree::follow(std::uint32_t i, const Proxy& proxy) {
  Place& place = places_[i];
  const bool stays = place.leaf != BoxTree::none && proxy.present && proxy.fixed == place.fixed;
  if (stays) {
    trees_[place.fixed].move(place.leaf, proxy.box);
    return;
  }
  if (place.leaf != BoxTree::none) trees_[place.fixed].remove(place.leaf);
  place = {};
  if (proxy.present) place = {trees_[proxy.fixed].add(proxy.box, i), proxy.fixed};
}

void Tree::update(std::span<const Proxy> proxies, std::span<const std::uint32_t> changed, std::vector<ProxyPair>& out) {
  make_room(places_, proxies.size());
  for (const std::uint32_t i : changed) follow(i, proxies[i]);
  for (BoxTree& tree : trees_) tree.settle();
  search_pairs(proxies, changed, marks_, out, [&](std::uint32_t i, auto visit) {
    trees_[0].search(proxies[i].box, visit);
    if (!proxies[i].fixed) trees_[1].search(proxies[i].box, visit);
  });
}

void Tree::search(std::span<const Proxy>, const Box& box, std::vector<std::uint32_t>& out) const {
  for (const BoxTree& tree : trees_) tree.search(box, [&](std::uint32_t i) { out.push_back(i); });
}

void Tree::cast(std::span<const Proxy>, BoxRay& ray, const std::function<void(std::uint32_t)>& visit) const {
  for (const BoxTree& tree : trees_) tree.cast(ray, visit);
}

void Tree::inner_boxes(std::vector<Box>& out) const {
  for (const BoxTree& tree : trees_) tree.inner_boxes(out);
}

}
