#include "collision/broad/end_points.h"

#include <algorithm>

namespace sudar::inline SUDAR_PRECISION {

double EndPointSweep::target(int axis, const EndPoint& e) const {
  if (roles_[e.proxy()] != Role::moves) return e.value;
  const Box& box = proxies_[e.proxy()].box;
  return e.upper() ? box.high[axis] : box.low[axis];
}

bool EndPointSweep::overlapping(const ProxyPair& p) const {
  const Proxy &a = proxies_[p.a], &b = proxies_[p.b];
  return a.present && b.present && !(a.fixed && b.fixed) && overlap(a.box, b.box) && !of_one_owner(a, b);
}

void EndPointSweep::meet(const EndPoint& a, const EndPoint& b) {
  const ProxyPair pair{std::min(a.proxy(), b.proxy()), std::max(a.proxy(), b.proxy())};
  if (overlapping(pair)) met_.push_back(pair);
}

void EndPointSweep::assign_roles(std::span<const std::uint32_t> changed) {
  listed_.resize(max(listed_.size(), proxies_.size()));
  roles_.assign(proxies_.size(), Role::rests);
  for (const std::uint32_t i : changed) {
    const Proxy& p = proxies_[i];
    using enum Listed::Kind;
    const Listed now{!p.present ? no : p.fixed ? fixed : moving, p.owner};
    roles_[i] = now == listed_[i] ? Role::moves : Role::enters_or_leaves;
    listed_[i] = now;
  }
}

void EndPointSweep::remove_ends() {
  for (Axis& axis : axes_) {
    std::erase_if(axis, [&](const EndPoint& e) { return roles_[e.proxy()] == Role::enters_or_leaves; });
  }
}

void EndPointSweep::enter_ends(std::span<const std::uint32_t> changed) {
  for (int k = 0; k < 3; ++k) {
    Axis& axis = axes_[std::size_t(k)];
    const auto old = std::ptrdiff_t(axis.size());
    for (const std::uint32_t i : changed) {
      const Proxy& p = proxies_[i];
      if (roles_[i] != Role::enters_or_leaves || !p.present) continue;
      axis.push_back({p.box.low[k], 2 * i});
      axis.push_back({p.box.high[k], 2 * i + 1});
    }
    std::sort(axis.begin() + old, axis.end(), before);
    std::inplace_merge(axis.begin(), axis.begin() + old, axis.end(), before);
  }
}

// The axis on which the fewest pairs of intervals overlap.
const EndPointSweep::Axis& EndPointSweep::sparsest_axis() const {
  std::size_t best = 0, fewest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    std::size_t open = 0, overlaps = 0;
    for (const EndPoint& e : axes_[k]) {
      if (e.upper())
        --open;
      else
        overlaps += open++;
    }
    if (k == 0 || overlaps < fewest) best = k, fewest = overlaps;
  }
  return axes_[best];
}

// Finds the pairs of what entered, with each other and with the rest.
void EndPointSweep::sweep_for_entered() {
  struct Open {
    Box box;
    std::uint32_t proxy;
  };
  std::vector<Open> old, entered;  // whose intervals hold the point where the sweep is
  std::vector<std::uint32_t> place(proxies_.size());
  for (const EndPoint& e : sparsest_axis()) {
    const std::uint32_t i = e.proxy();
    const bool enters = roles_[i] == Role::enters_or_leaves;
    std::vector<Open>& own = enters ? entered : old;
    if (e.upper()) {
      own[place[i]] = own.back();
      place[own.back().proxy] = place[i];
      own.pop_back();
      continue;
    }
    const Open open{proxies_[i].box, i};
    const auto meet_all = [&](const std::vector<Open>& others) {
      for (const Open& other : others) {
        if (overlap(open.box, other.box)) meet({0, 2 * i}, {0, 2 * other.proxy});
      }
    };
    meet_all(entered);
    if (enters) meet_all(old);
    place[i] = std::uint32_t(own.size());
    own.push_back(open);
  }
}

// Drops from the table what ended, adds what was met.
void EndPointSweep::keep_table() {
  std::erase_if(table_, [&](const ProxyPair& p) {
    return (roles_[p.a] != Role::rests || roles_[p.b] != Role::rests) && !overlapping(p);
  });
  if (met_.empty()) return;
  std::sort(met_.begin(), met_.end());
  met_.erase(std::unique(met_.begin(), met_.end()), met_.end());
  std::vector<ProxyPair> both;
  both.reserve(table_.size() + met_.size());
  std::set_union(table_.begin(), table_.end(), met_.begin(), met_.end(), std::back_inserter(both));
  table_.swap(both);
  met_.clear();
}

void EndPointSweep::update(std::span<const Proxy> proxies, std::span<const std::uint32_t> changed,
                           std::vector<ProxyPair>& out) {
  proxies_ = proxies;
  assign_roles(changed);
  if (!sort(axes_)) {
    for (const std::uint32_t i : changed) roles_[i] = Role::enters_or_leaves;
  }
  if (std::find(roles_.begin(), roles_.end(), Role::enters_or_leaves) != roles_.end()) {
    remove_ends();
    enter_ends(changed);
    sweep_for_entered();
  }
  keep_table();
  for (const ProxyPair& p : table_) {
    const bool reports = roles_[p.a] != Role::rests || roles_[p.b] != Role::rests;
    if (reports && may_touch(proxies[p.a].filter, proxies[p.b].filter)) out.push_back(p);
  }
  proxies_ = {};
}

}
