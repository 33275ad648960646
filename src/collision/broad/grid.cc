#include "collision/broad/grid.h"

#include "collision/broad/search.h"

#include <cstring>

namespace sudar::inline SUDAR_PRECISION {

namespace {

// Edges from 10⁻¹² m up; finer ones would gain nothing. Above the coarsest, doubles end.
constexpr std::int32_t finest_level = -40, coarsest_level = 1000;
constexpr double most_cells = 0x1p30;  // from the origin
// How many cells a member may reach beyond its cell: half a one, and what the rounding of its centre to 2⁻²² of a cell
// adds.
constexpr double reach = 0.5 + 0x1p-20;

double power_of_two(std::int32_t k) {
  const std::uint64_t bits = std::uint64_t(k + 1023) << 52;
  double x;
  std::memcpy(&x, &bits, sizeof x);
  return x;
}

// The smallest k with 2^k > x, for x ≥ 0 and finite.
std::int32_t level_above(double x) {
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  return std::int32_t(bits >> 52) - 1022;
}

double absolute(double x) { return x < 0 ? -x : x; }

std::int32_t floored(double x) {
  const auto whole = std::int32_t(x);
  return whole - (double(whole) > x);
}

// The level and cell of a box; false if it has none.
bool locate(const Box& box, CellKey& key) {
  std::int32_t level = finest_level;
  Pos center;
  for (int k = 0; k < 3; ++k) {
    const double size = box.high[k] - box.low[k];
    center[k] = 0.5 * box.low[k] + 0.5 * box.high[k];
    if (!std::isfinite(size) || !std::isfinite(center[k])) return false;
    level = max(level, max(level_above(size), level_above(absolute(center[k]) / most_cells)));
  }
  if (level > coarsest_level) return false;
  const double scale = power_of_two(-level);
  key = {floored(center.x * scale), floored(center.y * scale), floored(center.z * scale), level};
  return true;
}

}

void Grid::follow(std::uint32_t i, const Proxy& proxy) {
  CellKey key;
  const bool has_cell = proxy.present && locate(proxy.box, key);
  const std::uint32_t cell = places_[i].cell;
  if (has_cell && cell != no_cell && cell != in_list && cells_[cell].key == key) return;
  leave(i);
  if (has_cell) {
    enter(i, key);
  } else if (proxy.present) {
    places_[i].cell = in_list;
    list_.push_back(i);
  }
}

void Grid::enter(std::uint32_t proxy, const CellKey& key) {
  Place& place = places_[proxy];
  place.cell = cells_.make(key);
  Cell& cell = cells_[place.cell];
  place.next = cell.first_member;
  if (place.next != no_member) places_[place.next].previous = proxy;
  cell.first_member = proxy;
  ++members_[std::size_t(key.level - finest_level)];
}

void Grid::leave(std::uint32_t proxy) {
  const Place place = places_[proxy];
  places_[proxy] = {};
  if (place.cell == no_cell) return;
  if (place.cell == in_list) {
    std::erase(list_, proxy);
    return;
  }
  --members_[std::size_t(cells_[place.cell].key.level - finest_level)];
  if (place.next != no_member) places_[place.next].previous = place.previous;
  if (place.previous != no_member) {
    places_[place.previous].next = place.next;
  } else {
    cells_[place.cell].first_member = place.next;
    cells_.drop(place.cell);
  }
}

template <class Visit>
void Grid::visit_members(const Cell& cell, Visit visit) const {
  for (std::uint32_t m = cell.first_member; m != no_member; m = places_[m].next) visit(m);
}

// The members of all cells below that come near the box.
template <class Visit>
void Grid::visit_below(const Cell& cell, const Box& box, Visit visit) const {
  const double scale = power_of_two(1 - cell.key.level);
  const auto near = [&](double low, double high, std::int32_t x) {
    return low * scale <= x + (1 + reach) && high * scale >= x - reach;
  };
  for (const std::uint32_t c : cell.children) {
    if (c == no_cell) continue;
    const Cell& child = cells_[c];
    const CellKey& at = child.key;
    if (!near(box.low.x, box.high.x, at.x) || !near(box.low.y, box.high.y, at.y) ||
        !near(box.low.z, box.high.z, at.z)) {
      continue;
    }
    visit_members(child, visit);
    visit_below(child, box, visit);
  }
}

// The members of the level's cells that come near the box, and on demand of the cells below those.
template <class Visit>
void Grid::visit_level(std::int32_t level, const Box& box, bool below, Visit visit) const {
  const double scale = power_of_two(-level);
  std::int32_t low[3], high[3];
  for (int k = 0; k < 3; ++k) {
    low[k] = floored(box.low[k] * scale - reach);
    high[k] = floored(box.high[k] * scale + reach);
  }
  for (std::int32_t x = low[0]; x <= high[0]; ++x) {
    for (std::int32_t y = low[1]; y <= high[1]; ++y) {
      for (std::int32_t z = low[2]; z <= high[2]; ++z) {
        const std::uint32_t c = cells_.find({x, y, z, level});
        if (c == no_cell) continue;
        visit_members(cells_[c], visit);
        if (below) visit_below(cells_[c], box, visit);
      }
    }
  }
}

template <class Visit>
void Grid::search(std::uint32_t proxy, const Box& box, Visit visit) const {
  const std::uint32_t own = places_[proxy].cell;
  if (own == in_list) {
    for (std::uint32_t j = 0; j < places_.size(); ++j) visit(j);
    return;
  }
  for (const std::uint32_t j : list_) visit(j);
  const std::int32_t level = cells_[own].key.level;
  visit_level(level, box, true, visit);
  for (std::int32_t coarser = level + 1; coarser <= cells_.coarsest(); ++coarser) {
    if (members_[std::size_t(coarser - finest_level)] > 0) visit_level(coarser, box, false, visit);
  }
}

void Grid::update(std::span<const Proxy> proxies, std::span<const std::uint32_t> changed, std::vector<ProxyPair>& out) {
  places_.resize(max(places_.size(), proxies.size()));
  members_.resize(std::size_t(coarsest_level - finest_level + 1), 0);
  for (const std::uint32_t i : changed) follow(i, proxies[i]);
  std::vector<std::uint8_t> marks;
  search_pairs(proxies, changed, marks, out, [&](std::uint32_t i, auto visit) { search(i, proxies[i].box, visit); });
}

void Grid::inner_boxes(std::vector<Box>& out) const {
  for (const Cell& cell : cells_.all()) {
    if (cell.first_member == no_member) continue;
    const double edge = power_of_two(cell.key.level);
    const Pos low{cell.key.x * edge, cell.key.y * edge, cell.key.z * edge};
    out.push_back({low, low + Vec3d{edge, edge, edge}});
  }
}

}
