// Rays through the broad phase against rays at every body, while bodies come, move and go.
#include <sudar/world.h>

#include "broad_kinds.h"
#include "unit/random.h"
#include "unit/worlds.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace sudar;
using namespace sudar_test;

namespace {

World field(Broad kind) {
  Config c;
  c.broad = kind;
  return World(c);
}

// What each body alone answers, by a world in which it is the only one.
std::vector<RayHit> one_by_one(const World& w, const Pos& from, const Vec3& direction, Real reach, const RayQuery& q) {
  std::vector<RayHit> hits;
  for (const Body b : w.bodies()) {
    World alone;
    alone.add({.shape = w[b].shape(), .at = w[b].pose().p, .turn = w[b].pose().q, .motion = Motion::fixed});
    for (RayHit hit : alone.ray_cast(from, direction, reach, q)) {
      hit.body = b;
      hits.push_back(hit);
    }
  }
  std::stable_sort(hits.begin(), hits.end(), [](auto& p, auto& q) { return p.distance < q.distance; });
  if (!q.all && hits.size() > 1) hits.resize(1);
  return hits;
}

TEST(Ray, MeetsWhatEveryBodyAloneAnswers) {
  const Shape shapes[] = {sphere(Real(0.6)), box({1, 0.5, 2}), capsule(Real(0.3), 1), cone(Real(0.5), 1)};
  for (const Broad kind : broad_kinds()) {
    SCOPED_TRACE(name_of(kind));
    World w = field(kind);
    w.add({.shape = half_space(), .at = {0, -4, 0}, .motion = Motion::fixed});
    Random random(3);
    std::vector<Body> bodies;
    for (int step = 0; step < 12; ++step) {
      for (int k = 0; k < 5; ++k) {
        bodies.push_back(w.add({.shape = shapes[k % 4], .at = Pos{} + random.in_cube(4),
                                .velocity = convert<Real>(random.in_cube(3)), .filter = {1, 2, 0}}));  // they fly through each other
      }
      if (step % 3 == 2) w.remove(bodies[std::size_t(step)]);
      if (step % 4 == 1) w.place(bodies[0], {Pos{} + random.in_cube(4), {}});
      if (step % 2 == 0) w.step();
      if (step == 6) w.load(w.save());
      for (int ray = 0; ray < 20; ++ray) {
        const Pos from = Pos{} + random.in_cube(5);
        const RayQuery query{.from_inside = ray % 2 == 1, .all = ray % 4 < 2};
        const Vec3 direction = convert<Real>(random.direction());
        const Real reach = ray % 5 == 0 ? Real(3) : std::numeric_limits<Real>::infinity();
        const auto expected = one_by_one(w, from, direction, reach, query);
        const auto hits = w.ray_cast(from, direction, reach, query);
        ASSERT_EQ(hits.size(), expected.size());
        for (std::size_t k = 0; k < hits.size(); ++k) {
          EXPECT_NEAR(hits[k].distance, expected[k].distance, 1e-5);
          EXPECT_NEAR(length(hits[k].normal - expected[k].normal), 0, 1e-4);
          EXPECT_NEAR(length(hits[k].at - (from + direction * hits[k].distance)), 0, 1e-5);
        }
      }
    }
  }
}

TEST(Ray, StartsInsideOnlyIfAsked) {
  World w;
  const Body outer = w.add({.shape = box({4, 4, 4}), .motion = Motion::fixed});
  const Body inner = w.add({.shape = sphere(Real(0.5)), .at = {1.5, 0, 0}, .motion = Motion::fixed});
  const auto plain = w.ray_cast({0, 0, 0}, {1, 0, 0}, 10, {});
  ASSERT_EQ(plain.size(), 1u);
  EXPECT_EQ(plain[0].body, inner);
  const auto all = w.ray_cast({0, 0, 0}, {1, 0, 0}, 10, {.from_inside = true, .all = true});
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].body, outer);
  EXPECT_EQ(all[0].distance, 0);
  EXPECT_EQ(all[0].normal, (Vec3{-1, 0, 0}));
  EXPECT_EQ(all[1].body, inner);
  EXPECT_NEAR(all[1].distance, 1, 1e-6);
  EXPECT_TRUE(w.ray_cast({0, 0, 0}, {0, 1, 0}, 10, {}).empty());
}

TEST(Ray, PassesThroughWhatItsFilterDoesNotTouch) {
  World w;
  w.add({.shape = sphere(1), .at = {3, 0, 0}, .filter = {2, 0xffffffffu, 0}, .motion = Motion::fixed});
  const Body far = w.add({.shape = sphere(1), .at = {9, 0, 0}, .filter = {4, 0xffffffffu, 0}, .motion = Motion::fixed});
  const auto hits = w.ray_cast({0, 0, 0}, {1, 0, 0}, 20, {.filter = {1, 4, 0}});
  ASSERT_EQ(hits.size(), 1u);
  EXPECT_EQ(hits[0].body, far);
}

TEST(Ray, ChangesNoBit) {
  World plain = field(Broad::tree), asked = field(Broad::tree);
  for (World* w : {&plain, &asked}) {
    w->add(Gravity{});
    add_floor(*w);
    for (int k = 0; k < 10; ++k) w->add(cube({0.1 * k, 0.6 + 1.1 * k, 0}));
  }
  for (int i = 0; i < 60; ++i) {
    asked.ray_cast({0, 20, 0}, {0, -1, 0}, 100);
    if (i == 5) plain.add(cube({3, 1, 0})), asked.add(cube({3, 1, 0})), asked.ray_cast({3, 9, 0}, {0, -1, 0}, 100);
    plain.step(), asked.step();
    ASSERT_EQ(plain.hash(), asked.hash()) << i;
  }
}

}
