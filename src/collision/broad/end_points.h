// Sweep and prune: what its two kinds (sweep.h, kinetic_sweep.h) share, that is all but how they sort.
//
// On each axis the ends of all boxes stand in order. Two boxes overlap if their intervals overlap on all three axes, so
// a pair can begin only when the lower end of one passes the upper end of the other somewhere; since bodies move little
// from step to step, few ends pass each other, and putting the lists in order finds them all (Baraff 1992; Cohen, Lin,
// Manocha, Ponamgi 1995, "I-COLLIDE"). A pair that is met so is tested with all of its new box at once; the pairs that
// overlap are remembered in a sorted table, from which those that ended are dropped by the same test. So no count of
// axes is kept per pair, and however the lists were sorted, only the set of passings matters.
//
// What enters (new, or there were too many passings: a large jump) is not sorted in from the end, which costs O(n)
// each: all that enter are merged into the lists at once, then one sweep along the axis with the fewest overlaps finds
// theirs.
//
// O(n + passings + pairs) per update. Passings are the weakness: in a pile most boxes overlap on the vertical axis with
// thousands of others, and each trembling passes many ends without any pair beginning.
#pragma once

#include "collision/broad/broad.h"

#include <array>

namespace sudar::inline SUDAR_PRECISION {

struct EndPoint {
  double value;
  std::uint32_t id;  // 2 · proxy, and 1 more for the upper end
  std::uint32_t proxy() const { return id / 2; }
  bool upper() const { return id % 2 != 0; }
};

// The order along an axis. At equal values lower ends stand first, so that boxes that touch overlap.
inline bool before(const EndPoint& a, const EndPoint& b) {
  return a.value < b.value || (a.value == b.value && !a.upper() && b.upper());
}

class EndPointSweep : public BroadPhase {
 public:
  void update(std::span<const Proxy> proxies, std::span<const std::uint32_t> changed,
              std::vector<ProxyPair>& out) final;

 protected:
  using Axis = std::vector<EndPoint>;

  // Gives the end points of moved proxies their new values (target) and puts the axes in order; calls meet whenever a
  // lower end comes to stand before an upper one. May return false when entering what moved anew would cost less: then
  // the order of that does not matter.
  virtual bool sort(std::array<Axis, 3>& axes) = 0;
  double target(int axis, const EndPoint&) const;
  void meet(const EndPoint& a, const EndPoint& b);

 private:
  enum class Role : std::uint8_t { rests, moves, enters_or_leaves };
  // As what a proxy is known.
  struct Listed {
    enum class Kind : std::uint8_t { no, moving, fixed } kind = Kind::no;
    std::uint32_t owner = Proxy::nobody;
    bool operator==(const Listed&) const = default;
  };

  void assign_roles(std::span<const std::uint32_t> changed);
  void remove_ends();
  void enter_ends(std::span<const std::uint32_t> changed);
  void sweep_for_entered();
  const Axis& sparsest_axis() const;
  bool overlapping(const ProxyPair&) const;
  void keep_table();

  std::array<Axis, 3> axes_;
  std::vector<Listed> listed_;    // by proxy
  std::vector<ProxyPair> table_;  // overlapping, not both fixed or of one owner, whatever their filters; sorted

  // During an update:
  std::span<const Proxy> proxies_;
  std::vector<Role> roles_;     // by proxy
  std::vector<ProxyPair> met_;  // overlapping, perhaps in the table already or more than once
};

}
