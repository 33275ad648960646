// What each broad phase costs, as CSV: against the number of proxies, the spread of their sizes and the share of them
// that moves, and in a lattice like a stack of boxes.
//   bench_broad_phase [KIND…] > docs/broad_phase.csv     then tools/broad_phase_plot.py draws it
// Cubes drift in straight lines and turn back. As in a world, a proxy changes when its cube leaves its enlarged box,
// which of those that move about one in seven does in each update. Processor time, mean over the updates of a run, the
// better of two runs.
#include "collision/broad/broad.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <ctime>

namespace {

using namespace sudar;

class Random {  // splitmix64 (Steele, Lea, Flood 2014)
 public:
  double between(double low, double high) {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return low + (high - low) * double((z ^ (z >> 31)) >> 11) * 0x1p-53;
  }

 private:
  std::uint64_t state_ = 1;
};

struct Scene {
  const char* plot;
  std::size_t n;
  double spread = 4;     // largest size / smallest; sizes are log-uniform about 1
  double moving = 1;     // share
  bool lattice = false;  // side by side, trembling; else anywhere in a cube of which they fill a tenth
};

class Swarm {
 public:
  explicit Swarm(const Scene& s) {
    double volume = 0;
    for (std::size_t i = 0; i < s.n; ++i) {
      size_.push_back(s.lattice ? 1 : std::pow(s.spread, random_.between(-0.5, 0.5)));
      volume += size_.back() * size_.back() * size_.back();
    }
    half_ = s.lattice ? 0.1 : 0.5 * std::cbrt(10 * volume);
    const auto edge = std::size_t(std::ceil(std::cbrt(double(s.n))));
    for (std::size_t i = 0; i < s.n; ++i) {
      home_.push_back(s.lattice ? Pos{double(i % edge), double(i / edge % edge), double(i / edge / edge)} : Pos{});
      at_.push_back(home_[i] + Vec3d{random_.between(-half_, half_), random_.between(-half_, half_),
                                     random_.between(-half_, half_)});
      const double speed = random_.between(0, 1) < s.moving ? 0.01 * size_[i] : 0;
      way_.push_back(speed * Vec3d{random_.between(-1, 1), random_.between(-1, 1), random_.between(-1, 1)});
      proxies.push_back({cube(i, 1.1), {}, true, false});
      changed.push_back(std::uint32_t(i));
      at_[i] = at_[i] + random_.between(0, 5) * way_[i];  // else all would change in the same updates
    }
  }

  void move() {
    changed.clear();
    for (std::size_t i = 0; i < at_.size(); ++i) {
      at_[i] = at_[i] + way_[i];
      for (int k = 0; k < 3; ++k) {
        const double out = at_[i][k] - home_[i][k];
        if (std::abs(out) > half_ && out * way_[i][k] > 0) way_[i][k] *= -1;
      }
      if (contains(proxies[i].box, cube(i, 1))) continue;
      proxies[i].box = cube(i, 1.1);
      changed.push_back(std::uint32_t(i));
    }
  }

  std::vector<Proxy> proxies;
  std::vector<std::uint32_t> changed;

 private:
  Box cube(std::size_t i, double scale) const {
    const double h = 0.5 * scale * size_[i];
    return {at_[i] - Vec3d{h, h, h}, at_[i] + Vec3d{h, h, h}};
  }

  Random random_;
  double half_ = 0;  // how far from home
  std::vector<double> size_;
  std::vector<Pos> home_, at_;
  std::vector<Vec3d> way_;
};

double seconds_of_processor() { return double(std::clock()) / CLOCKS_PER_SEC; }

struct Cost {
  double first = 0, update = 0;      // µs
  double changed = 0, reported = 0;  // per update
};

Cost run(Broad kind, const Scene& scene) {
  constexpr int warm_up = 10;
  const int updates = scene.n <= 10000 ? 60 : 20;
  Swarm swarm(scene);
  const auto broad = make_broad_phase(kind);
  std::vector<ProxyPair> pairs;
  Cost cost;
  for (int i = 0; i < warm_up + updates; ++i) {
    pairs.clear();
    const double start = seconds_of_processor();
    broad->update(swarm.proxies, swarm.changed, pairs);
    const double taken = 1e6 * (seconds_of_processor() - start);
    if (i == 0) cost.first = taken;
    if (i >= warm_up) {
      cost.update += taken / updates;
      cost.changed += double(swarm.changed.size()) / updates;
      cost.reported += double(pairs.size()) / updates;
    }
    swarm.move();
  }
  return cost;
}

void measure(Broad kind, const Scene& scene) {
  const Cost a = run(kind, scene), b = run(kind, scene);
  std::printf("%s,%s,%zu,%g,%g,%.0f,%.0f,%.1f,%.1f\n", scene.plot, names(kind)[int(kind)], scene.n, scene.spread,
              scene.moving, a.changed, a.reported, std::min(a.first, b.first), std::min(a.update, b.update));
  std::fflush(stdout);
}

}

int main(int argc, char** argv) {  // arguments: the kinds to measure; none: all
  std::printf("plot,broad,n,spread,moving,changed,pairs,first_us,update_us\n");
  for (const char* const* name = names(Broad{}); *name != nullptr; ++name) {
    if (argc > 1 && std::none_of(argv + 1, argv + argc, [&](const char* a) { return !std::strcmp(a, *name); }))
      continue;
    const auto kind = Broad(name - names(Broad{}));
    for (const std::size_t n : {100u, 316u, 1000u, 3162u, 10000u, 31623u, 100000u}) {
      if (kind == Broad::brute && n > 31623) continue;  // minutes
      measure(kind, {.plot = "n", .n = n});
      measure(kind, {.plot = "lattice", .n = n, .spread = 1, .lattice = true});
    }
    for (double spread = 1; spread <= 1e7; spread *= 10)
      measure(kind, {.plot = "spread", .n = 10000, .spread = spread});
    for (const double moving : {0.001, 0.01, 0.1, 1.0}) measure(kind, {.plot = "moving", .n = 31623, .moving = moving});
  }
}
