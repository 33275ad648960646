#include "collision/broad/cells.h"

#include <algorithm>

namespace sudar::inline SUDAR_PRECISION {

namespace {

// Mixes all bits (the finalizer of MurmurHash3, Appleby 2011), so that neighbours do not share probes.
std::size_t hash(const CellKey& k) {
  std::uint64_t h = std::uint64_t(std::uint32_t(k.x)) | std::uint64_t(std::uint32_t(k.y)) << 32;
  h ^= (std::uint64_t(std::uint32_t(k.z)) << 16 ^ std::uint64_t(std::uint32_t(k.level)) << 56) * 0x9e3779b97f4a7c15u;
  h = (h ^ h >> 33) * 0xff51afd7ed558ccdu;
  h = (h ^ h >> 33) * 0xc4ceb9fe1a85ec53u;
  return std::size_t(h ^ h >> 33);
}

}

// Where the key is, or the empty slot where it would be.
std::size_t Cells::slot_of(const CellKey& key) const {
  const std::size_t mask = table_.size() - 1;
  std::size_t s = hash(key) & mask;
  while (table_[s] != no_cell && !(cells_[table_[s]].key == key)) s = (s + 1) & mask;
  return s;
}

std::uint32_t Cells::find(const CellKey& key) const { return table_.empty() ? no_cell : table_[slot_of(key)]; }

void Cells::enter(std::uint32_t cell) { table_[slot_of(cells_[cell].key)] = cell; }

std::uint32_t Cells::add(const CellKey& key) {
  if (2 * ++used_ > table_.size()) {  // at most half full
    const std::vector<std::uint32_t> old = std::move(table_);
    table_.assign(std::max<std::size_t>(64, 2 * old.size()), no_cell);
    for (const std::uint32_t cell : old) {
      if (cell != no_cell) enter(cell);
    }
  }
  if (free_.empty()) {
    free_.push_back(std::uint32_t(cells_.size()));
    cells_.emplace_back();
  }
  const std::uint32_t cell = free_.back();
  free_.pop_back();
  cells_[cell] = {};
  cells_[cell].key = key;
  enter(cell);
  return cell;
}

std::uint32_t Cells::make(const CellKey& key) {
  if (used_ == 0) coarsest_ = key.level;
  if (key.level > coarsest_) raise(key.level);
  if (const std::uint32_t found = find(key); found != no_cell) return found;
  const std::uint32_t made = add(key);
  for (std::uint32_t cell = made; cells_[cell].key.level < coarsest_;) {
    const CellKey above = cells_[cell].key.parent();
    const unsigned octant = cells_[cell].key.octant();
    std::uint32_t parent = find(above);
    const bool was_there = parent != no_cell;
    if (!was_there) parent = add(above);
    cells_[cell].parent = parent;
    cells_[parent].children[octant] = cell;
    if (was_there) break;
    cell = parent;
  }
  return made;
}

// Gives every cell without a parent its ancestors up to a level that is coarser than all so far.
void Cells::raise(std::int32_t level) {
  while (coarsest_ < level) {
    const std::int32_t before = coarsest_++;
    for (std::uint32_t cell = 0, n = std::uint32_t(cells_.size()); cell < n; ++cell) {
      const CellKey key = cells_[cell].key;
      if (key.level != before || find(key) != cell) continue;
      const std::uint32_t parent = make(key.parent());
      cells_[cell].parent = parent;
      cells_[parent].children[key.octant()] = cell;
    }
  }
}

void Cells::drop(std::uint32_t cell) {
  const auto empty = [&](const Cell& c) {
    return c.first_member == no_member &&
           std::all_of(c.children.begin(), c.children.end(), [](std::uint32_t child) { return child == no_cell; });
  };
  while (cell != no_cell && empty(cells_[cell])) {
    const std::size_t mask = table_.size() - 1;
    std::size_t hole = slot_of(cells_[cell].key);
    for (std::size_t s = (hole + 1) & mask; table_[s] != no_cell; s = (s + 1) & mask) {
      const std::size_t home = hash(cells_[table_[s]].key) & mask;
      if (((s - home) & mask) < ((s - hole) & mask)) continue;  // it may not stand before its home
      table_[hole] = table_[s];
      hole = s;
    }
    table_[hole] = no_cell;
    --used_;
    const std::uint32_t parent = cells_[cell].parent;
    if (parent != no_cell) cells_[parent].children[cells_[cell].key.octant()] = no_cell;
    cells_[cell] = {};
    free_.push_back(cell);
    cell = parent;
  }
}

}
