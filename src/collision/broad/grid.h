// Spatial hashing, thesis (3.26), with cells of many sizes: each proxy is a member of the one cell that holds its
// centre, on the level whose cells are between one and two times as large as its box. So a box reaches at most half a
// cell beyond its cell, and who may overlap it is found
// - on its own level and on each coarser one that has members, in the at most 3³ cells around it;
// - on finer levels, in the cells below those of its own level ("loose" octree: Ulrich, Game Programming Gems 2000).
// O(changed · (levels in use + neighbours)), for sizes from 10⁻³ to 10⁴ side by side; nothing has to be tuned, and
// nothing depends on the size of the world. With one size for all it is the plain hash grid of the thesis.
//
// The idea of one level per size is Mirtich's (1996, "Impulse-based dynamic simulation of rigid body systems", 2.4) and
// Overmars's (1992); Mirtich enters a box into all cells that it touches on all levels, which makes large boxes dear.
// Rejected: one cell size fitted to the scene (a plate of 200 m and a marble meet in one scene); a large box walking
// through all fine cells that it covers (10²¹ of them in the worst case).
//
// Cell coordinates are 32-bit: a box further than 2³⁰ of its cells from the origin moves to a coarser level. What is
// beyond 2¹⁰⁰⁰ or has an infinite box is kept in a list that everyone tests.
#pragma once

#include "collision/broad/broad.h"
#include "collision/broad/cells.h"

namespace sudar::inline SUDAR_PRECISION {

class Grid final : public BroadPhase {
 public:
  void update(std::span<const Proxy> proxies, std::span<const std::uint32_t> changed,
              std::vector<ProxyPair>& out) override;
  void inner_boxes(std::vector<Box>& out) const override;

 private:
  // Where a proxy is kept: in a cell, in the list of the immeasurable (in_list), or nowhere (no_cell).
  struct Place {
    std::uint32_t cell = no_cell;
    std::uint32_t next = no_member, previous = no_member;  // members of the same cell
  };
  static constexpr std::uint32_t in_list = no_cell - 1;

  void follow(std::uint32_t i, const Proxy&);
  void enter(std::uint32_t proxy, const CellKey&);
  void leave(std::uint32_t proxy);
  template <class Visit>
  void visit_members(const Cell&, Visit) const;
  template <class Visit>
  void visit_below(const Cell&, const Box&, Visit) const;
  template <class Visit>
  void visit_level(std::int32_t level, const Box&, bool below, Visit) const;
  template <class Visit>
  void search(std::uint32_t proxy, const Box&, Visit) const;

  Cells cells_;
  std::vector<Place> places_;  // by proxy
  std::vector<std::uint32_t> list_;
  std::vector<std::uint32_t> members_;  // how many, by level − finest_level
};

}
