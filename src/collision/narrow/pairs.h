// The pair table: one row for each pair of shapes whose fat boxes overlap. It keeps what a pair must remember from step
// to step; whoever solves contacts hangs its own data on `row`. A pair with a mesh has a row for each triangle near the
// other shape, its parts, besides that of the whole, which is never collided.
//
// A row stays where it is as long as the pair lives, and hangs on both its proxies, so nothing ever looks through all
// rows: pairs begin where the broad phase and find_plane_pairs found them, end where one of their proxies changed, and
// only the active ones, those that can change, are collided. In what order rows lie depends on history; whatever can
// change a bit is done in the order of keys.
#pragma once

#include <algorithm>
#include <tuple>

#include "base/links.h"
#include "collision/broad/broad.h"
#include "collision/narrow/collide.h"

namespace sudar::inline SUDAR_PRECISION {

constexpr std::uint32_t no_row = 0xffffffffu;
constexpr std::uint32_t no_part = 0xffffffffu;  // the pair as a whole

struct PairRow {
  ProxyPair key;
  std::uint32_t part = no_part;    // the triangle
  std::uint32_t touching = 0;    // parts of this whole that do
  AxisCache cache;
  std::uint32_t row = no_row;  // the owner's
  Manifold manifold;           // points relative to the position of proxy key.a, world axes; normal from b to a

  // Rows in their order: by key, parts before their whole.
  auto order() const { return std::tuple(key.a, key.b, part); }
};
template <class V, Like<PairRow> T>
void describe(V& v, T& d) {
  v("key", d.key, any), v("part", d.part, any), v("touching", d.touching, any), v("cache", d.cache, any);
  v("row", d.row, any), v("manifold", d.manifold, any);
}
static_assert(sizeof(PairRow) == sizeof(Manifold) + 32 && std::is_trivially_copyable_v<PairRow>, "no padding");

// A half space among the proxies; its proxy is not `present` in the broad phase. Always fixed.
struct PlaneProxy {
  std::uint32_t proxy;
  Vec3 normal;  // world axes
  Pos point;    // on the surface
};

// How long a pair that does not touch need not be looked at: its shapes are apart until their ways, summed over both, are
// this long. State: a look finds an axis, from which the next one begins (AxisCache).
struct PairWatch {
  std::uint32_t a = 0, b = 0;  // proxies
  double until = -1;           // m; negative: look now
  bool rests(double way, double margin) const { return way + margin < until; }
};

class PairTable {
 public:
  static constexpr std::uint32_t none = 0xffffffffu;

  void reserve(std::uint32_t proxies) { links_.reserve(proxies); }
  std::uint32_t find(const ProxyPair&, std::uint32_t part = no_part) const;  // none: there is no such pair
  std::uint32_t add(const ProxyPair&, std::uint32_t part = no_part);         // there is none yet
  // Its number is not used again before the next settle().
  void remove(std::uint32_t pair);
  void clear();

  PairRow& operator[](std::uint32_t pair) { return rows_[pair]; }
  const PairRow& operator[](std::uint32_t pair) const { return rows_[pair]; }
  std::span<PairWatch> watches() { return watches_; }  // by number
  std::span<const PairWatch> watches() const { return watches_; }
  std::span<PairRow> rows() { return rows_; }  // by number; some are not in use
  // All pairs, by key: for saving and looking.
  std::vector<std::uint32_t> sorted() const;
  // visit(pair) for each pair of the proxy; it may be removed.
  template <class Visit>
  void each(std::uint32_t proxy, Visit visit) const {
    links_.each(proxy, visit);
  }

  // From now on it can change.
  void activate(std::uint32_t pair);
  // Active pairs by key, without those that can_change(key) refuses.
  template <class CanChange>
  const std::vector<std::uint32_t>& settle(CanChange can_change) {
    merge();
    std::erase_if(active_, [&](std::uint32_t p) {
      if (alive(p) && can_change(rows_[p].key)) return false;
      is_active_[p] = 0;
      return true;
    });
    for (const std::uint32_t p : removed_) free_.push_back(p);
    removed_.clear();
    return active_;
  }
  // Those that were activated since, by key; and everything active.
  std::vector<std::uint32_t> take_activated();
  const std::vector<std::uint32_t>& active() const { return active_; }

 private:
  bool alive(std::uint32_t pair) const { return rows_[pair].key.a != none; }
  bool before(std::uint32_t p, std::uint32_t q) const { return rows_[p].order() < rows_[q].order(); }
  void merge();

  std::vector<PairRow> rows_;
  std::vector<PairWatch> watches_;
  std::vector<std::uint8_t> is_active_;
  std::vector<std::uint32_t> free_, removed_;
  std::vector<std::uint32_t> active_;     // by key
  std::vector<std::uint32_t> activated_;  // not among them yet
  Links links_;                           // by proxy
};

// Whether a half space pairs with a proxy: filters, and the box reaches below its surface (touching counts). The boxes
// are fat, so that the collision margin is in them.
bool may_pair(const PlaneProxy& plane, const Proxy& plane_proxy, const Proxy& other);

// The pairs of half spaces of which at least one side is in `changed` (ascending), sorted, appended to `out`.
// `planes` ascending by proxy.
void find_plane_pairs(std::span<const PlaneProxy> planes, std::span<const Proxy> proxies,
                      std::span<const std::uint32_t> changed, std::vector<ProxyPair>& out);

// Whether the pair would begin now: the same tests as in the broad phase and find_plane_pairs.
bool goes_on(const ProxyPair&, std::span<const Proxy> proxies, std::span<const PlaneProxy> planes);

// Two bodies' shapes where they are, or a triangle (`part`) of one and the other: points relative to a's position, world axes.
// Returns how far they are apart at least, where they have no point in common, else 0.
Real collide_placed(const Geometry& of_a, const Pose& a, const Geometry& of_b, const Pose& b, std::uint32_t part,
                    Reach, AxisCache& cache, Manifold& out);

// Collides one row: manifold, matches, bits. Returns how far the shapes are apart at least, if they do not touch and did
// not before, else −1.
Real collide_pair(PairRow&, const Geometry& of_a, const Pose& a, const Geometry& of_b, const Pose& b, Reach);

// Collides the rows numbered in `which`: manifold, matches, bits. Rows are independent of each other, so parts of
// `which` may run in parallel. Geometry and pose (of the shape's frame) by proxy.
void collide_pairs(std::span<PairRow> rows, std::span<const std::uint32_t> which,
                   std::span<const Geometry* const> geometry, std::span<const Pose> pose, Real margin);

}
