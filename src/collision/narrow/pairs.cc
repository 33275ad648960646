#include "collision/narrow/pairs.h"

#include "collision/narrow/mesh.h"

namespace sudar::inline SUDAR_PRECISION {
namespace {

const PlaneProxy* find(std::span<const PlaneProxy> planes, std::uint32_t proxy) {
  const auto at = std::lower_bound(planes.begin(), planes.end(), proxy,
                                   [](const PlaneProxy& p, std::uint32_t number) { return p.proxy < number; });
  return at != planes.end() && at->proxy == proxy ? &*at : nullptr;
}

// A half space looks the same from anywhere on its surface: its pose, moved to the foot of `near`.
Pose foot(const Pose& plane, const Pos& near) {
  const Vec3d n = rotate(normalize(Quatd{plane.q.x, plane.q.y, plane.q.z, plane.q.w}), Vec3d{0, 1, 0});
  const Vec3d d{near.x - plane.p.x, near.y - plane.p.y, near.z - plane.p.z};
  return {plane.p + (d - n * dot(d, n)), plane.q};
}

void match(const Manifold& old, Manifold& now) {
  for (int i = 0; i < now.count; ++i) {
    ManifoldPoint& point = now.points[std::size_t(i)];
    for (int j = 0; j < old.count; ++j) {
      if (old.points[std::size_t(j)].feature == point.feature) point.match = j;
    }
  }
}

}

// Both poses relative to that of a, except that a half space is taken at its foot, in double: far from its origin a
// separation keeps its digits.
Real collide_placed(const Geometry& ga, const Pose& a, const Geometry& gb, const Pose& b, std::uint32_t part,
                    Reach reach, AxisCache& cache, Manifold& out) {
  if (ga.kind == ShapeKind::mesh) {
    return collide_triangle({&ga, {{}, a.q}}, part, {&gb, {b.p - a.p, b.q}}, reach, cache, out);
  }
  if (gb.kind == ShapeKind::mesh) {
    const Real apart = collide_triangle({&gb, {b.p - a.p, b.q}}, part, {&ga, {{}, a.q}}, reach, cache, out);
    out.normal = -out.normal;
    return apart;
  }
  if (ga.kind == ShapeKind::half_space) {
    const Pose at = foot(a, b.p);
    const Real apart = collide({&ga, {{}, a.q}}, {&gb, {b.p - at.p, b.q}}, reach, cache, out);
    const Vec3 shift = at.p - a.p;
    for (int i = 0; i < out.count; ++i) out.points[std::size_t(i)].at += shift;
    return apart;
  } else {
    const Pos at = gb.kind == ShapeKind::half_space ? foot(b, a.p).p : b.p;
    return collide({&ga, {{}, a.q}}, {&gb, {at - a.p, b.q}}, reach, cache, out);
  }
}

std::uint32_t PairTable::find(const ProxyPair& key, std::uint32_t part) const {
  const std::uint32_t fewer = links_.count(key.a) < links_.count(key.b) ? key.a : key.b;
  std::uint32_t found = none;
  links_.each(fewer, [&](std::uint32_t p) {
    if (rows_[p].key == key && rows_[p].part == part) found = p;
  });
  return found;
}

std::uint32_t PairTable::add(const ProxyPair& key, std::uint32_t part) {
  std::uint32_t pair = std::uint32_t(rows_.size());
  if (free_.empty()) {
    rows_.emplace_back(), watches_.emplace_back(), is_active_.push_back(0);
  } else {
    pair = free_.back();
    free_.pop_back();
    rows_[pair] = PairRow{};
  }
  rows_[pair].key = key, rows_[pair].part = part;
  watches_[pair] = {key.a, key.b};
  links_.add(pair, key.a, key.b);
  return pair;
}

void PairTable::remove(std::uint32_t pair) {
  links_.remove(pair);
  rows_[pair].key = {none, none};
  removed_.push_back(pair);
}

void PairTable::clear() { *this = {}; }

std::vector<std::uint32_t> PairTable::sorted() const {
  std::vector<std::uint32_t> all;
  for (std::uint32_t p = 0; p < rows_.size(); ++p) {
    if (alive(p)) all.push_back(p);
  }
  std::ranges::sort(all, [&](std::uint32_t p, std::uint32_t q) { return before(p, q); });
  return all;
}

void PairTable::activate(std::uint32_t pair) {
  if (is_active_[pair] != 0) return;
  is_active_[pair] = 1;
  activated_.push_back(pair);
}

std::vector<std::uint32_t> PairTable::take_activated() {
  std::vector<std::uint32_t> taken = activated_;
  std::erase_if(taken, [&](std::uint32_t p) { return !alive(p); });
  std::ranges::sort(taken, [&](std::uint32_t p, std::uint32_t q) { return before(p, q); });
  merge();
  return taken;
}

// Removed pairs sort last, and the next settle() drops them.
void PairTable::merge() {
  const auto by_key = [&](std::uint32_t p, std::uint32_t q) { return before(p, q); };
  std::erase_if(active_, [&](std::uint32_t p) {
    if (alive(p)) return false;
    is_active_[p] = 0;
    return true;
  });
  std::ranges::sort(activated_, by_key);
  const auto middle = std::ptrdiff_t(active_.size());
  active_.insert(active_.end(), activated_.begin(), activated_.end());
  std::inplace_merge(active_.begin(), active_.begin() + middle, active_.end(), by_key);
  activated_.clear();
}

bool may_pair(const PlaneProxy& plane, const Proxy& plane_proxy, const Proxy& other) {
  if (!other.present || other.fixed || !may_touch(plane_proxy.filter, other.filter)) return false;
  double height = 0;  // of the box's corner farthest down the normal
  for (int i = 0; i < 3; ++i) {
    const double n = double(plane.normal[i]);
    height += n * ((n > 0 ? other.box.low : other.box.high)[i] - plane.point[i]);
  }
  return height <= 0;
}

void find_plane_pairs(std::span<const PlaneProxy> planes, std::span<const Proxy> proxies,
                      std::span<const std::uint32_t> changed, std::vector<ProxyPair>& out) {
  const auto first = std::ptrdiff_t(out.size());
  const auto look = [&](const PlaneProxy& plane, std::uint32_t i) {
    if (!may_pair(plane, proxies[plane.proxy], proxies[i])) return;
    out.push_back({std::min(plane.proxy, i), std::max(plane.proxy, i)});
  };
  for (const PlaneProxy& plane : planes) {
    if (std::binary_search(changed.begin(), changed.end(), plane.proxy)) {
      for (std::uint32_t i = 0; i < proxies.size(); ++i) look(plane, i);
    } else {
      for (const std::uint32_t i : changed) look(plane, i);
    }
  }
  std::sort(out.begin() + first, out.end());
}

bool goes_on(const ProxyPair& key, std::span<const Proxy> proxies, std::span<const PlaneProxy> planes) {
  if (const PlaneProxy* p = find(planes, key.a)) return may_pair(*p, proxies[key.a], proxies[key.b]);
  if (const PlaneProxy* p = find(planes, key.b)) return may_pair(*p, proxies[key.b], proxies[key.a]);
  return may_pair(proxies[key.a], proxies[key.b]);
}

Real collide_pair(PairRow& row, const Geometry& of_a, const Pose& a, const Geometry& of_b, const Pose& b, Reach reach) {
  const Manifold old = row.manifold;
  const Real apart = collide_placed(of_a, a, of_b, b, row.part, reach, row.cache, row.manifold);
  match(old, row.manifold);
  const bool touched = (old.bits & Manifold::touching) != 0, touches = row.manifold.count > 0;
  if (touches) row.manifold.bits |= Manifold::touching;
  if (touches && !touched) row.manifold.bits |= Manifold::began;
  if (!touches && touched) row.manifold.bits |= Manifold::ended;
  return touches || touched ? Real(-1) : apart;
}

void collide_pairs(std::span<PairRow> rows, std::span<const std::uint32_t> which,
                   std::span<const Geometry* const> geometry, std::span<const Pose> pose, Real margin) {
  for (const std::uint32_t i : which) {
    const auto [a, b] = rows[i].key;
    collide_pair(rows[i], *geometry[a], pose[a], *geometry[b], pose[b], margin);
  }
}

}
