// The pair table: one row for each pair of shapes whose fat boxes overlap, sorted by key. It keeps what a pair must
// remember from step to step; whoever solves contacts hangs its own data on `row`.
//
// A step goes: merge_pairs (what the broad phase and find_plane_pairs found) → end_pairs → collide_pairs → the owner
// walks the rows in order and looks at the manifolds' bits. The table is a plain vector, saved and hashed as bytes.
#pragma once

#include <algorithm>

#include "collision/broad/broad.h"
#include "collision/narrow/collide.h"

namespace sudar::inline SUDAR_PRECISION {

constexpr std::uint32_t no_row = 0xffffffffu;

struct PairRow {
  ProxyPair key;
  AxisCache cache;
  std::uint32_t row = no_row;  // the owner's
  Manifold manifold;           // points relative to the position of proxy key.a, world axes; normal from b to a
};
static_assert(sizeof(PairRow) == sizeof(Manifold) + 24 && std::is_trivially_copyable_v<PairRow>, "no padding");

// A half space among the proxies; its proxy is not `present` in the broad phase. Always fixed.
struct PlaneProxy {
  std::uint32_t proxy;
  Vec3 normal;  // world axes
  Pos point;    // on the surface
};

// A pair that is gone although its row had something of the owner.
struct EndedPair {
  ProxyPair key;
  std::uint32_t row;
};

// Adds a row for each pair that has none. `found` is sorted.
void merge_pairs(std::vector<PairRow>& rows, std::span<const ProxyPair> found);

// Erases the rows whose key `gone` accepts; appends those with an owner's row to `ended`, in key order.
template <class Gone>
void erase_pairs(std::vector<PairRow>& rows, std::vector<EndedPair>& ended, Gone gone) {
  const auto kept = std::remove_if(rows.begin(), rows.end(), [&](const PairRow& r) {
    if (!gone(r.key)) return false;
    if (r.row != no_row) ended.push_back({r.key, r.row});
    return true;
  });
  rows.erase(kept, rows.end());
}

// Whether a half space pairs with a proxy: filters, and the box reaches below its surface (touching counts). The boxes
// are fat, so that the collision margin is in them.
bool may_pair(const PlaneProxy& plane, const Proxy& plane_proxy, const Proxy& other);

// The pairs of half spaces of which at least one side is in `changed` (ascending), sorted, appended to `out`.
// `planes` ascending by proxy.
void find_plane_pairs(std::span<const PlaneProxy> planes, std::span<const Proxy> proxies,
                      std::span<const std::uint32_t> changed, std::vector<ProxyPair>& out);

// Erases the rows that would not begin now: the same tests as in the broad phase and find_plane_pairs.
void end_pairs(std::vector<PairRow>& rows, std::span<const Proxy> proxies, std::span<const PlaneProxy> planes,
               std::vector<EndedPair>& ended);

// Two bodies' shapes where they are: points relative to a's position, world axes.
void collide_placed(const Geometry& of_a, const Pose& a, const Geometry& of_b, const Pose& b, Real margin,
                    AxisCache& cache, Manifold& out);

// Collides the rows numbered in `which`: manifold, matches, bits. Rows are independent of each other, so parts of
// `which` may run in parallel. Geometry and pose (of the shape's frame) by proxy.
void collide_pairs(std::span<PairRow> rows, std::span<const std::uint32_t> which,
                   std::span<const Geometry* const> geometry, std::span<const Pose> pose, Real margin);

}
