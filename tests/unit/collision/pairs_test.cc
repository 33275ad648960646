// The pair table against a model that forgets nothing and is told everything: bodies come, go and move at random.
#include "collision/narrow/pairs.h"

#include "support.h"

#include <gtest/gtest.h>

#include <cstring>
#include <map>
#include <set>

namespace sudar::test {
namespace {

constexpr double margin = 0.05;

struct Model {
  Random random{1};
  std::vector<Shape> shapes{box({1, 1, 1}), sphere(Real(0.5)), capsule(Real(0.3), 1), half_space()};
  std::vector<Proxy> proxies;
  std::vector<const Geometry*> geometry;
  std::vector<Pose> pose;
  std::vector<PlaneProxy> planes;
  std::vector<std::uint32_t> changed;
  PairTable table;
  std::unique_ptr<BroadPhase> broad = make_broad_phase(Broad::brute);

  void put(std::uint32_t i, const Pose& at) {
    pose[i] = at;
    proxies[i].box = bounds(*geometry[i], at, Real(margin));
    changed.push_back(i);
  }
  Pose somewhere() { return {Pos{} + random.in_box(1.5), random.turn()}; }
  void add() {
    const auto i = std::uint32_t(proxies.size());
    const Shape& shape = shapes[std::size_t(random.below(3))];
    proxies.emplace_back();
    proxies[i].present = true;
    proxies[i].fixed = random.below(5) == 0;
    pose.emplace_back();
    geometry.push_back(&shape.geometry());
    put(i, somewhere());
  }
  void add_plane(const Pose& at) {
    const auto i = std::uint32_t(proxies.size());
    proxies.emplace_back();
    proxies[i].fixed = true;
    pose.push_back(at);
    geometry.push_back(&shapes[3].geometry());
    planes.push_back({i, rotate(at.q, {0, 1, 0}), at.p});
    changed.push_back(i);
  }
  bool is_plane(std::uint32_t i) const { return geometry[i]->kind == ShapeKind::half_space; }

  // Every pair that must have a row.
  std::set<ProxyPair> expected() const {
    std::set<ProxyPair> keys;
    for (std::uint32_t a = 0; a < proxies.size(); ++a) {
      for (std::uint32_t b = a + 1; b < proxies.size(); ++b) {
        const std::uint32_t plane = is_plane(a) ? a : b, other = is_plane(a) ? b : a;
        if (is_plane(plane)) {
          if (!proxies[other].present || proxies[other].fixed) continue;
          const Box& box = proxies[other].box;
          const Vec3 n = rotate(pose[plane].q, {0, 1, 0});
          bool below = false;  // some corner
          for (int c = 0; c < 8; ++c) {
            const Pos corner{(c & 1 ? box.low : box.high).x, (c & 2 ? box.low : box.high).y,
                             (c & 4 ? box.low : box.high).z};
            below |= double(n.x) * (corner.x - pose[plane].p.x) + double(n.y) * (corner.y - pose[plane].p.y) +
                         double(n.z) * (corner.z - pose[plane].p.z) <=
                     0;
          }
          if (below) keys.insert({a, b});
        } else if (may_pair(proxies[a], proxies[b])) {
          keys.insert({a, b});
        }
      }
    }
    return keys;
  }

  // The rows of pairs that are gone, by key.
  std::vector<PairRow> update() {
    std::ranges::sort(changed);
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
    std::vector<ProxyPair> found;
    broad->update(proxies, changed, found);
    find_plane_pairs(planes, proxies, changed, found);
    for (const ProxyPair& key : found) {
      if (table.find(key) == PairTable::none) table.activate(table.add(key));
    }
    std::vector<std::uint32_t> gone;
    for (const std::uint32_t i : changed) {
      table.each(i, [&](std::uint32_t p) {
        if (!goes_on(table[p].key, proxies, planes) && std::ranges::find(gone, p) == gone.end()) gone.push_back(p);
      });
    }
    std::vector<PairRow> ended;
    for (const std::uint32_t p : gone) ended.push_back(table[p]), table.remove(p);
    std::ranges::sort(ended, {}, &PairRow::key);
    changed.clear();
    return ended;
  }
  PairRow& row(std::size_t n) { return table[table.sorted()[n]]; }
};

TEST(Pairs, FollowTheModel) {
  Model m;
  m.add();
  m.add_plane({{0, -1, 0}, {}});
  m.add();
  m.add_plane({{-1, 0, 0}, turned({0, 0, 1}, -1)});
  std::map<ProxyPair, std::uint32_t> owned;  // the owner's rows by key
  std::uint32_t next_row = 0;
  int began = 0, ended_bits = 0, matched = 0;
  for (int step = 0; step < 400; ++step) {
    SCOPED_TRACE(step);
    if (m.proxies.size() < 25) m.add();
    for (std::uint32_t i = 0; i < m.proxies.size(); ++i) {
      if (m.is_plane(i) || !m.proxies[i].present) continue;
      const int what = m.random.below(60);
      if (what == 0) {
        m.put(i, m.somewhere());
      } else if (what == 1) {
        m.proxies[i].present = false;
        m.changed.push_back(i);
      } else if (what < 20) {
        m.put(i, {m.pose[i].p + m.random.in_box(0.02), m.pose[i].q * turned(m.random.direction(), 0.01)});
      }
    }
    for (std::uint32_t i = 0; i < m.proxies.size(); ++i) {
      if (!m.is_plane(i) && !m.proxies[i].present && m.random.below(10) == 0) {
        m.proxies[i].present = true;
        m.put(i, m.somewhere());
      }
    }

    for (const PairRow& e : m.update()) {
      if (e.row == no_row) continue;
      ASSERT_EQ(owned.at(e.key), e.row);
      owned.erase(e.key);
    }
    const auto expected = m.expected();
    const std::vector<std::uint32_t> all = m.table.sorted();
    const auto key = [&](std::uint32_t p) { return m.table[p].key; };
    ASSERT_TRUE(std::ranges::equal(all, expected, {}, key));
    // Everything active is in order, and what was not activated again is not.
    ASSERT_EQ(m.table.settle([](const ProxyPair&) { return true; }), all);

    std::vector<PairRow> before;
    for (const std::uint32_t p : all) before.push_back(m.table[p]);
    collide_pairs(m.table.rows(), all, m.geometry, m.pose, Real(margin));
    for (std::size_t i = 0; i < all.size(); ++i) {
      PairRow& row = m.table[all[i]];
      const auto [a, b] = row.key;
      const bool now = row.manifold.count > 0, had = before[i].manifold.count > 0;
      ASSERT_EQ((row.manifold.bits & Manifold::touching) != 0, now);
      ASSERT_EQ((row.manifold.bits & Manifold::began) != 0, now && !had);
      ASSERT_EQ((row.manifold.bits & Manifold::ended) != 0, !now && had);
      AxisCache cold;
      Manifold fresh;
      collide({m.geometry[a], {{}, m.pose[a].q}}, {m.geometry[b], {m.pose[b].p - m.pose[a].p, m.pose[b].q}},
              Real(margin), cold, fresh);
      ASSERT_EQ(fresh.count, row.manifold.count);
      for (int k = 0; k < fresh.count; ++k) {
        const ManifoldPoint &p = row.manifold.points[std::size_t(k)], &q = fresh.points[std::size_t(k)];
        EXPECT_NEAR(length(p.at - q.at), 0, 1e-5);
        EXPECT_NEAR(p.separation, q.separation, 1e-5);
        int same = -1;
        for (int j = 0; j < before[i].manifold.count; ++j) {
          if (before[i].manifold.points[std::size_t(j)].feature == p.feature) same = j;
        }
        ASSERT_EQ(p.match, same);
        matched += same >= 0;
      }
      if (row.manifold.bits & Manifold::began) {
        ++began;
        ASSERT_EQ(row.row, no_row);
        row.row = owned[row.key] = next_row++;
      }
      if (row.manifold.bits & Manifold::ended) {
        ++ended_bits;
        ASSERT_EQ(owned.erase(row.key), 1u);
        row.row = no_row;
      }
    }
    ASSERT_EQ(std::size_t(std::ranges::count_if(all, [&](auto p) { return m.table[p].row != no_row; })), owned.size());
  }
  EXPECT_GT(began, 100);
  EXPECT_GT(ended_bits, 50);
  EXPECT_GT(matched, 1000);
}

TEST(Pairs, TheActiveOnesAreInTheOrderOfKeys) {
  PairTable table;
  const auto keys = [&](const std::vector<std::uint32_t>& pairs) {
    std::vector<ProxyPair> out;
    for (const std::uint32_t p : pairs) out.push_back(table[p].key);
    return out;
  };
  const auto all = [](const ProxyPair&) { return true; };
  const std::uint32_t late = table.add({3, 4}), early = table.add({1, 2}), never = table.add({2, 3});
  table.activate(late), table.activate(early), table.activate(late);
  EXPECT_EQ(keys(table.settle(all)), (std::vector<ProxyPair>{{1, 2}, {3, 4}}));
  table.activate(never);
  EXPECT_EQ(keys(table.take_activated()), (std::vector<ProxyPair>{{2, 3}}));
  EXPECT_EQ(keys(table.active()), (std::vector<ProxyPair>{{1, 2}, {2, 3}, {3, 4}}));
  EXPECT_TRUE(table.take_activated().empty());
  table.remove(early);
  EXPECT_EQ(table.find({1, 2}), PairTable::none);
  const std::uint32_t other = table.add({5, 6});  // not in the place of what may still be listed
  EXPECT_NE(other, early);
  table.activate(other);
  EXPECT_EQ(keys(table.settle([](const ProxyPair& key) { return key.a != 2; })), (std::vector<ProxyPair>{{3, 4}, {5, 6}}));
  EXPECT_EQ(table.add({7, 8}), early);
  EXPECT_EQ(keys(table.sorted()), (std::vector<ProxyPair>{{2, 3}, {3, 4}, {5, 6}, {7, 8}}));
}

TEST(Pairs, OnlyTheChosenRowsAreCollided) {
  Model m;
  m.add(), m.add(), m.add();
  for (std::uint32_t i = 0; i < 3; ++i) m.put(i, {{0.1 * i, 0, 0}, {}}), m.proxies[i].fixed = false;
  m.update();
  ASSERT_EQ(m.table.sorted().size(), 3u);
  collide_pairs(m.table.rows(), std::vector<std::uint32_t>{m.table.sorted()[1]}, m.geometry, m.pose, Real(margin));
  EXPECT_EQ(m.row(0).manifold.count, 0);
  EXPECT_GT(m.row(1).manifold.count, 0);
  EXPECT_EQ(m.row(2).manifold.count, 0);
}

// Story: a floor placed at the origin and a box 100 km away. In float the floor's height there would be off by
// millimetres on a slope.
TEST(Pairs, FloorIsExactFarFromItsOrigin) {
  Model m;
  const Quat slope = turned({0, 0, 1}, -0.5);
  m.add_plane({{}, slope});
  const Quatd q = normalize(Quatd{slope.x, slope.y, slope.z, slope.w});
  const Vec3d along = rotate(q, Vec3d{1, 0, 0}), up = rotate(q, Vec3d{0, 1, 0});
  m.add();
  m.geometry[1] = &m.shapes[1].geometry();
  m.proxies[1].fixed = false;
  m.put(1, {Pos{} + along * 1e5 + up * 0.49, {}});
  m.update();
  ASSERT_EQ(m.table.sorted().size(), 1u);
  collide_pairs(m.table.rows(), m.table.sorted(), m.geometry, m.pose, Real(margin));
  ASSERT_EQ(m.row(0).manifold.count, 1);
  EXPECT_NEAR(m.row(0).manifold.points[0].separation, -0.01, 1e-6);
}

}
}
