// The cells of a hierarchical grid: cubes of edge 2^level on the lattice of their level, found by a hash of their
// coordinates. A cell exists while it has members or a cell of the level below it has, and each has all its ancestors
// up to the coarsest level so far, so that from a cell one comes to everything below it without meeting empty space.
//
// The table is open addressing with linear probing; a removed entry is filled by shifting back those behind it (Knuth,
// vol. 3, 6.4 algorithm R), so that no tombstones pile up under moving bodies. Nothing iterates over it.
#pragma once

#include <sudar/base.h>

#include <array>
#include <vector>

namespace sudar::inline SUDAR_PRECISION {

struct CellKey {
  std::int32_t x, y, z, level;
  bool operator==(const CellKey&) const = default;
  CellKey parent() const { return {x >> 1, y >> 1, z >> 1, level + 1}; }
  unsigned octant() const { return unsigned(x & 1) | unsigned(y & 1) << 1 | unsigned(z & 1) << 2; }  // in the parent
};

constexpr std::uint32_t no_cell = 0xffffffffu, no_member = 0xffffffffu;

struct Cell {
  CellKey key;
  std::uint32_t first_member = no_member;  // of a list that the user keeps
  std::uint32_t parent = no_cell;
  std::array<std::uint32_t, 8> children = {no_cell, no_cell, no_cell, no_cell, no_cell, no_cell, no_cell, no_cell};
};

class Cells {
 public:
  std::uint32_t find(const CellKey&) const;  // no_cell: there is none
  std::uint32_t make(const CellKey&);        // finds it, or makes it and its ancestors
  void drop(std::uint32_t cell);             // removes it if it is empty, and so its ancestors
  Cell& operator[](std::uint32_t cell) { return cells_[cell]; }
  const Cell& operator[](std::uint32_t cell) const { return cells_[cell]; }
  std::int32_t coarsest() const { return coarsest_; }
  const std::vector<Cell>& all() const { return cells_; }  // unused ones have no members and no children

 private:
  std::size_t slot_of(const CellKey&) const;
  std::uint32_t add(const CellKey&);
  void enter(std::uint32_t cell);
  void raise(std::int32_t level);

  std::vector<Cell> cells_;
  std::vector<std::uint32_t> free_, table_;  // table_: cells or no_cell; its size is a power of two
  std::size_t used_ = 0;
  std::int32_t coarsest_ = 0;
};

}
