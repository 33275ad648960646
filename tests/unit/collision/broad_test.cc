// Every broad phase finds the pairs that brute force finds, whatever the history: each test is one kind of history.
#include "collision/broad/broad.h"

#include "support.h"

#include <gtest/gtest.h>

#include <limits>

namespace sudar::test {
namespace {

Box box_at(const Pos& center, const Vec3d& size) { return {center - 0.5 * size, center + 0.5 * size}; }

// A population of proxies that changes; what changes is noted until the next comparison.
class Population {
 public:
  explicit Population(Broad kind, std::uint64_t seed) : random(seed), tested_(make_broad_phase(kind)) {}

  Random random;
  std::vector<Proxy> proxies;

  std::uint32_t add(const Box& box) {
    proxies.push_back({box, {}, true, random.below(5) == 0});
    changed_.push_back(std::uint32_t(proxies.size() - 1));
    return changed_.back();
  }
  Proxy& change(std::uint32_t i) {
    changed_.push_back(i);
    return proxies[i];
  }
  std::uint32_t any() { return std::uint32_t(random.below(int(proxies.size()))); }

  // Both kinds update; returns the number of pairs.
  std::size_t compare() {
    std::sort(changed_.begin(), changed_.end());
    changed_.erase(std::unique(changed_.begin(), changed_.end()), changed_.end());
    std::vector<ProxyPair> found{{7, 9}}, expected{{7, 9}};  // what is there stays
    tested_->update(proxies, changed_, found);
    brute_->update(proxies, changed_, expected);
    EXPECT_EQ(found, expected) << changed_.size() << " of " << proxies.size() << " changed";
    changed_.clear();
    return expected.size() - 1;
  }

 private:
  std::unique_ptr<BroadPhase> tested_, brute_ = make_broad_phase(Broad::brute);
  std::vector<std::uint32_t> changed_;
};

class Kinds : public testing::TestWithParam<Broad> {};

double log_uniform(Random& random, double low, double high) {
  return std::exp(random.uniform(std::log(low), std::log(high)));
}

// Boxes of one size that drift; each step a third of them moves.
TEST_P(Kinds, Drift) {
  Population p(GetParam(), 1);
  std::vector<Vec3d> velocity;
  for (int i = 0; i < 300; ++i) {
    p.add(box_at(Pos{} + wide(p.random.in_box(6)), {1, 1, 1}));
    velocity.push_back(0.05 * wide(p.random.direction()));
  }
  std::size_t pairs = 0;
  for (int step = 0; step < 400; ++step) {
    pairs += p.compare();
    for (std::uint32_t i = 0; i < 300; ++i) {
      if (p.random.below(3) > 0) continue;
      Box& box = p.change(i).box;
      box = {box.low + velocity[i], box.high + velocity[i]};
      for (int k = 0; k < 3; ++k) {
        if (std::abs(box.low[k]) > 6 && box.low[k] * velocity[i][k] > 0) velocity[i][k] *= -1;
      }
    }
  }
  EXPECT_GT(pairs, 10000u);
}

// Corners on a coarse grid of whole numbers: boxes coincide, touch and are flat.
TEST_P(Kinds, CoincidentTouchingAndFlat) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Population p(GetParam(), seed);
    const auto random_box = [&] {
      Box b;
      for (int k = 0; k < 3; ++k) b.low[k] = p.random.below(12), b.high[k] = b.low[k] + p.random.below(4);
      return b;
    };
    for (int i = 0; i < 60; ++i) p.add(random_box());
    for (int step = 0; step < 60; ++step) {
      p.compare();
      for (int m = p.random.below(20); m > 0; --m) p.change(p.any()).box = random_box();
      for (int m = p.random.below(3); m > 0; --m) p.add(p.proxies[p.any()].box);
      Proxy& back = p.change(p.any());  // a face exactly on another one's
      const Box& front = p.proxies[p.any()].box;
      back.box = {front.high, front.high + Vec3d{1, 1, 1}};
    }
    if (HasFailure()) return;
  }
}

// Everything that a history can hold at once; sizes from 1e-3 to 1e4.
TEST_P(Kinds, Anything) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Population p(GetParam(), seed);
    const double world = log_uniform(p.random, 1, 1e5);
    const auto random_box = [&] {
      const double size = log_uniform(p.random, 1e-3, 1e4);
      const Vec3d shape{p.random.uniform(), p.random.uniform(), p.random.uniform()};
      return box_at(Pos{} + world * wide(p.random.in_box(1)), size * shape);
    };
    for (int i = 0; i < 100; ++i) p.add(random_box());
    for (int step = 0; step < 120; ++step) {
      p.compare();
      for (int m = p.random.below(p.random.below(5) == 0 ? 200 : 20); m > 0; --m) {
        Proxy& proxy = p.change(p.any());
        Box& box = proxy.box;
        const Vec3d size = {box.high.x - box.low.x, box.high.y - box.low.y, box.high.z - box.low.z};
        const Vec3d way = scale(size, wide(p.random.in_box(0.3)));
        switch (p.random.below(12)) {
          case 0:
            box = random_box();
            break;  // a jump
          case 1:
            box = p.proxies[p.any()].box;
            break;  // coincident
          case 2:
            proxy.present = false;
            break;  // removal
          case 3:
            proxy.present = true, box = random_box();
            break;  // insertion where one was removed
          case 4:
            proxy.fixed = !proxy.fixed;
            break;
          case 5:
            proxy.filter = {1u << p.random.below(3), std::uint32_t(p.random.below(8)), p.random.below(3) - 1};
            break;
          case 6:
            break;  // told as changed, but is not
          case 7:
            box = {box.low - 3.0 * size, box.high + 3.0 * size};
            break;  // growth
          case 8:
            box = box_at(box.low, {});
            break;  // a point
          default:
            box = {box.low + way, box.high + way};
            break;  // motion
        }
      }
      if (p.random.below(3) == 0) p.add(random_box());
    }
    if (HasFailure()) return;
  }
}

// Boxes far out, beyond every scale and without an end, among common ones.
TEST_P(Kinds, HugeFarAndInfinite) {
  constexpr double inf = std::numeric_limits<double>::infinity(), most = std::numeric_limits<double>::max();
  Population p(GetParam(), 5);
  const auto random_box = [&]() -> Box {
    const Vec3d at = wide(p.random.in_box(3));
    switch (p.random.below(10)) {
      case 0:
        return box_at(Pos{} + 1e9 * at, {1, 1, 1});
      case 1:
        return box_at(Pos{} + 1e200 * at, {1e-3, 1e-3, 1e-3});
      case 2:
        return box_at(Pos{} + 1e200 * at, {1e200, 1e199, 1e200});
      case 3:
        return {{-inf, at.y, -inf}, {inf, at.y + 0.1, inf}};
      case 4:
        return {{-most, -most, at.z}, {most, most, inf}};
      case 5:
        return {{-inf, -inf, -inf}, {inf, inf, inf}};
      case 6:
        return box_at(Pos{} + 1e-300 * at, {1e-300, 1e-310, 0});
      default:
        return box_at(Pos{} + at, {1, 1, 1});
    }
  };
  for (int i = 0; i < 60; ++i) p.add(random_box());
  for (int step = 0; step < 400; ++step) {
    p.compare();
    for (int m = p.random.below(8); m > 0; --m) p.change(p.any()).box = random_box();
    if (p.random.below(8) == 0) p.change(p.any()).present ^= true;
  }
}

// Nobody, one, all gone, all back.
TEST_P(Kinds, EmptyAndRefilled) {
  Population p(GetParam(), 1);
  EXPECT_EQ(p.compare(), 0u);
  p.add(box_at({}, {1, 1, 1}));
  EXPECT_EQ(p.compare(), 0u);
  EXPECT_EQ(p.compare(), 0u);  // nothing changed
  for (int i = 0; i < 50; ++i) p.add(box_at(Pos{} + wide(p.random.in_box(2)), {1, 1, 1}));
  EXPECT_GT(p.compare(), 0u);
  for (std::uint32_t i = 0; i < 51; ++i) p.change(i).present = false;
  EXPECT_EQ(p.compare(), 0u);
  EXPECT_EQ(p.compare(), 0u);
  for (std::uint32_t i = 0; i < 51; ++i) p.change(i).present = true;
  EXPECT_GT(p.compare(), 0u);
}

// A thousand boxes: rain on a wide floor, everything changes in every step.
TEST_P(Kinds, Rain) {
  Population p(GetParam(), 9);
  p.proxies.push_back({box_at({0, -1, 0}, {1000, 2, 1000}), {}, true, true});
  p.change(0);
  for (int i = 0; i < 1000; ++i) p.add(box_at(Pos{0, 20, 0} + wide(p.random.in_box(20)), {1, 2, 1}));
  std::size_t pairs = 0;
  for (int step = 0; step < 60; ++step) {
    pairs += p.compare();
    for (std::uint32_t i = 1; i <= 1000; ++i) {
      Box& box = p.change(i).box;
      const double fall = std::min(box.low.y + 0.5, 0.7);
      box = {box.low - Vec3d{0, fall, 0}, box.high - Vec3d{0, fall, 0}};
    }
  }
  EXPECT_GT(pairs, 5000u);
}

// Everything jumps at once, further than sorting can follow; small motions in between.
TEST_P(Kinds, EverythingJumps) {
  Population p(GetParam(), 4);
  const auto random_box = [&] { return box_at(Pos{} + wide(p.random.in_box(20)), {2, 2, 2}); };
  for (int i = 0; i < 2000; ++i) p.add(random_box());
  for (int step = 0; step < 12; ++step) {
    EXPECT_GT(p.compare(), step % 3 == 0 ? 1000u : 10u);
    for (std::uint32_t i = 0; i < 2000; ++i) {
      if (step % 3 == 2) {
        p.change(i).box = random_box();
      } else if (i % 5 == 0) {
        Box& box = p.change(i).box;
        box = {box.low + Vec3d{0.1, 0, 0}, box.high + Vec3d{0.1, 0, 0}};
      }
    }
  }
}

// The picture of a structure of boxes shows all that is in it; the other kinds have none.
TEST_P(Kinds, InnerBoxes) {
  const auto broad = make_broad_phase(GetParam());
  Random random(3);
  std::vector<Proxy> proxies;
  std::vector<std::uint32_t> changed;
  for (std::uint32_t i = 0; i < 40; ++i) {
    proxies.push_back({box_at(Pos{} + wide(random.in_box(5)), {1, 1, 1}), {}, true, i < 20});
    changed.push_back(i);
  }
  std::vector<ProxyPair> pairs;
  broad->update(proxies, changed, pairs);
  std::vector<Box> boxes;
  broad->inner_boxes(boxes);
  const bool has_boxes = GetParam() == Broad::grid || GetParam() == Broad::tree;
  EXPECT_EQ(!boxes.empty(), has_boxes);
  for (const Proxy& p : proxies) {
    const Pos center = p.box.low + Vec3d{0.5, 0.5, 0.5};
    const auto holds = [&](const Box& box) { return contains(box, Box{center, center}); };
    EXPECT_EQ(std::any_of(boxes.begin(), boxes.end(), holds), has_boxes);
  }
}

INSTANTIATE_TEST_SUITE_P(Broad, Kinds, testing::Values(Broad::grid, Broad::sweep, Broad::kinetic_sweep, Broad::tree),
                         [](const auto& info) { return names(Broad{})[int(info.param)]; });

}
}
