#include "collision/narrow/pairs.h"

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
void collide_placed(const Geometry& ga, const Pose& a, const Geometry& gb, const Pose& b, Real margin,
                    AxisCache& cache, Manifold& out) {
  if (ga.kind == ShapeKind::half_space) {
    const Pose at = foot(a, b.p);
    collide({&ga, {{}, a.q}}, {&gb, {b.p - at.p, b.q}}, margin, cache, out);
    const Vec3 shift = at.p - a.p;
    for (int i = 0; i < out.count; ++i) out.points[std::size_t(i)].at += shift;
  } else {
    const Pos at = gb.kind == ShapeKind::half_space ? foot(b, a.p).p : b.p;
    collide({&ga, {{}, a.q}}, {&gb, {at - a.p, b.q}}, margin, cache, out);
  }
}

void merge_pairs(std::vector<PairRow>& rows, std::span<const ProxyPair> found) {
  const auto by_key = [](const PairRow& a, const PairRow& b) { return a.key < b.key; };
  const std::size_t old = rows.size();
  std::size_t at = 0;
  for (const ProxyPair& key : found) {
    while (at < old && rows[at].key < key) ++at;
    if (at < old && rows[at].key == key) continue;
    PairRow row{};
    row.key = key;
    rows.push_back(row);
  }
  std::inplace_merge(rows.begin(), rows.begin() + std::ptrdiff_t(old), rows.end(), by_key);
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

void end_pairs(std::vector<PairRow>& rows, std::span<const Proxy> proxies, std::span<const PlaneProxy> planes,
               std::vector<EndedPair>& ended) {
  erase_pairs(rows, ended, [&](const ProxyPair& key) {
    if (const PlaneProxy* p = find(planes, key.a)) return !may_pair(*p, proxies[key.a], proxies[key.b]);
    if (const PlaneProxy* p = find(planes, key.b)) return !may_pair(*p, proxies[key.b], proxies[key.a]);
    return !may_pair(proxies[key.a], proxies[key.b]);
  });
}

void collide_pairs(std::span<PairRow> rows, std::span<const std::uint32_t> which,
                   std::span<const Geometry* const> geometry, std::span<const Pose> pose, Real margin) {
  for (const std::uint32_t i : which) {
    PairRow& row = rows[i];
    const auto [a, b] = row.key;
    const Manifold old = row.manifold;
    collide_placed(*geometry[a], pose[a], *geometry[b], pose[b], margin, row.cache, row.manifold);
    match(old, row.manifold);
    const bool touched = (old.bits & Manifold::touching) != 0, touches = row.manifold.count > 0;
    if (touches) row.manifold.bits |= Manifold::touching;
    if (touches && !touched) row.manifold.bits |= Manifold::began;
    if (!touches && touched) row.manifold.bits |= Manifold::ended;
  }
}

}
