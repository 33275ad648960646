// What a broad phase costs, against the number of proxies and against the spread of their sizes, as CSV:
//   bench_broad_phase > broad_phase.csv
// Cubes in a larger cube, of which they fill a tenth, drift in straight lines and turn back at its walls. As in a
// world, a proxy changes when the cube leaves its enlarged box: about one in ten does in each update. Processor time,
// mean over the updates of a run. tools/broad_phase_plot.py draws it.
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

double seconds_of_processor() { return double(std::clock()) / CLOCKS_PER_SEC; }

class Swarm {
 public:
  // `spread`: largest size / smallest; sizes are log-uniform about 1.
  Swarm(std::size_t n, double spread) {
    double volume = 0;
    for (std::size_t i = 0; i < n; ++i) {
      size_.push_back(std::pow(spread, random_.between(-0.5, 0.5)));
      volume += size_.back() * size_.back() * size_.back();
    }
    half_ = 0.5 * std::cbrt(10 * volume);
    for (std::size_t i = 0; i < n; ++i) {
      at_.push_back({inside(), inside(), inside()});
      way_.push_back(0.01 * size_[i] * Vec3d{random_.between(-1, 1), random_.between(-1, 1), random_.between(-1, 1)});
      const Pos at = at_[i];
      proxies.push_back({cube(i, 1.1), {}, true, false});
      at_[i] = at + random_.between(0, 5) * way_[i];  // else all would change in the same updates
      changed.push_back(std::uint32_t(i));
    }
  }

  void move() {
    changed.clear();
    for (std::size_t i = 0; i < at_.size(); ++i) {
      at_[i] = at_[i] + way_[i];
      for (int k = 0; k < 3; ++k) {
        if (std::abs(at_[i][k]) > half_ && at_[i][k] * way_[i][k] > 0) way_[i][k] *= -1;
      }
      if (contains(proxies[i].box, cube(i, 1))) continue;
      proxies[i].box = cube(i, 1.1);
      changed.push_back(std::uint32_t(i));
    }
  }

  std::vector<Proxy> proxies;
  std::vector<std::uint32_t> changed;

 private:
  double inside() { return random_.between(-half_, half_); }
  Box cube(std::size_t i, double scale) const {
    const double h = 0.5 * scale * size_[i];
    return {at_[i] - Vec3d{h, h, h}, at_[i] + Vec3d{h, h, h}};
  }

  Random random_;
  double half_ = 0;
  std::vector<double> size_;
  std::vector<Pos> at_;
  std::vector<Vec3d> way_;
};

void measure(const char* plot, Broad kind, std::size_t n, double spread) {
  constexpr int warm_up = 10;
  const int updates = n <= 10000 ? 60 : 20;
  Swarm swarm(n, spread);
  const auto broad = make_broad_phase(kind);
  std::vector<ProxyPair> pairs;
  double first = 0, time = 0, changed = 0, reported = 0;
  for (int i = 0; i < warm_up + updates; ++i) {
    pairs.clear();
    const double start = seconds_of_processor();
    broad->update(swarm.proxies, swarm.changed, pairs);
    const double taken = seconds_of_processor() - start;
    if (i == 0) first = taken;
    if (i >= warm_up) time += taken, changed += double(swarm.changed.size()), reported += double(pairs.size());
    swarm.move();
  }
  std::printf("%s,%s,%zu,%g,%.0f,%.0f,%.1f,%.1f\n", plot, names(kind)[int(kind)], n, spread, changed / updates,
              reported / updates, 1e6 * first, 1e6 * time / updates);
  std::fflush(stdout);
}

}

int main(int argc, char** argv) {  // arguments: the kinds to measure; none: all
  std::printf("plot,broad,n,spread,changed,pairs,first_us,update_us\n");
  for (const char* const* name = names(Broad{}); *name != nullptr; ++name) {
    if (argc > 1 && std::none_of(argv + 1, argv + argc, [&](const char* a) { return !std::strcmp(a, *name); }))
      continue;
    const auto kind = Broad(name - names(Broad{}));
    for (const std::size_t n : {100u, 316u, 1000u, 3162u, 10000u, 31623u, 100000u}) {
      if (kind == Broad::brute && n > 31623) continue;  // minutes
      measure("n", kind, n, 4);
    }
    for (double spread = 1; spread <= 1e7; spread *= 10) measure("spread", kind, 10000, spread);
  }
}
