// Many balls that slide and shake: a slope, a shaken box.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "verify/cases/cases.h"
#include "verify/cases/grain_scene.h"
#include "verify/numerics.h"

namespace sudar::verify {

namespace {

// V47. A slice of grains between smooth walls, on a rough floor, loses its right side and slides out; the slope that
// stays is the angle of repose. (A heap of some hundred grains on a table is steeper by 10°: it is too low.)
std::vector<std::pair<double, double>> slope_that_stays(Run& run, std::uint32_t seed) {
  const double length = run["length"], thick = 3.3;
  World w(run.config());
  add_gravity(run, w);
  const Material m = material(run.with("friction", run["friction"])), smooth = material(0);
  for (const double side : {-1.0, 1.0})
    add_ground(w, smooth, {0, 0, -side * thick / 2}, axis_angle(Vec3{1, 0, 0}, Real(side * pi / 2)));
  add_ground(w, smooth, {}, axis_angle(Vec3{0, 0, 1}, Real(-pi / 2)));
  for (int i = 0; i < int(length); ++i) {
    for (int k = -1; k <= 1; ++k)
      w.add({.shape = sphere(0.5), .at = {i + 0.5, 0, 1.1 * k}, .material = m, .motion = Motion::fixed});
  }
  const Body gate = w.add({.shape = box({1, Real(2 * length), Real(thick)}),
                           .at = {length + 0.5, length, 0},
                           .material = smooth,
                           .motion = Motion::fixed});
  Random random{seed};
  const int columns = int(length / 1.2), layer = 2 * columns;
  std::vector<Body> grains;
  for (int i = 0; i < int(run["grains"]); ++i) {
    const double x = (i % columns + 0.5) * length / columns, z = i / columns % 2 == 0 ? -0.8 : 0.8;
    grains.push_back(add_grain(
        w, {x + random.between(-0.05, 0.05), 1.1 + 1.1 * double(i / layer), z + random.between(-0.2, 0.2)}, m));
  }
  run.until(w, 5);
  w.remove(gate);
  run.until(w, 17, [&] {
    std::erase_if(grains, [&](Body b) {
      if (w[b].center().y > -3) return false;
      w.remove(b);
      return true;
    });
  });
  // The highest grain in each stretch of a diameter, but for both ends.
  std::map<int, Pos> highest;
  for (const Body b : grains) {
    const Pos p = w[b].center();
    const auto [cell, first] = highest.try_emplace(int(p.x), p);
    if (!first && cell->second.y < p.y) cell->second = p;
  }
  std::vector<std::pair<double, double>> profile;
  for (const auto& [cell, p] : highest) {
    if (cell >= 1 && cell < int(length) - 2) profile.emplace_back(p.x, p.y);
  }
  return profile;
}

void angle_of_repose(Run& run) {
  Plot& plot = run.plot("Slopes", "x [d]", "height [d]");
  const double length = run["length"], fall = std::tan(22.5 * pi / 180);
  plot.theory = {{0, length * fall}, {length, 0}};
  // One slope differs from the next by 2°: the range is met by the mean of several, give or take twice its own error.
  const int seeds = run.setting().effort == Effort::full ? 12 : 4;
  std::vector<double> angles;
  for (int i = 0; i < seeds; ++i) {
    const auto profile = slope_that_stays(run, std::uint32_t(run["seed"]) + std::uint32_t(i));
    angles.push_back(std::atan(-slope(profile)) * 180 / pi);
    plot.simulation.insert(plot.simulation.end(), profile.begin(), profile.end());
  }
  const double mean = std::accumulate(angles.begin(), angles.end(), 0.0) / seeds;
  double squares = 0;
  for (const double angle : angles) squares += (angle - mean) * (angle - mean);
  const double error = std::sqrt(squares / (seeds - 1) / seeds);
  run.check("angle of repose, mean of " + std::to_string(seeds) + ", range 20 … 25", "°", 22.5, mean, 2.5 + 2 * error);
}

// V50. In a shaken box the largest ball comes up.
bool rises(Run& run, std::uint32_t seed, Plot& plot) {
  const double width = 6, big = 1.5, amplitude = 0.3,
               omega = std::sqrt(run.with("shaking", run["strength"]) * standard_gravity / amplitude);
  World w(run.config());
  add_gravity(run, w);
  const Material m = material(0.3, 0.2);
  add_shaft(w, width, m);
  const Body floor = w.add({.shape = box({Real(3 * width), 2, Real(3 * width)}),
                            .at = {0, -1, 0},
                            .material = m,
                            .motion = Motion::kinematic});
  Random random{seed};
  const Body nut = w.add({.shape = sphere(Real(big)),
                          .at = {random.between(-1, 1), big, random.between(-1, 1)},
                          .mass = Real(grain_mass * std::pow(2 * big, 3)),
                          .material = m});
  const std::vector<Body> grains = fill(w, int(run["grains"]), width, 2 * big, m, random);
  const double dt = w.config().dt;
  std::size_t below = 0;
  run.until(w, run["time"], [&] {
    const double t = w.time();
    w.set_velocity(floor, {0, Real(amplitude * (std::sin(omega * (t + dt)) - std::sin(omega * t)) / dt), 0}, {});
    below = std::size_t(
        std::count_if(grains.begin(), grains.end(), [&](Body b) { return w[b].center().y < w[nut].center().y; }));
    if (w.steps() % 20 == 0) plot.simulation.emplace_back(t, double(below) / double(grains.size()));
  });
  plot.theory = {{0, 0.5}, {run["time"], 0.5}};  // above it has risen
  return below > grains.size() / 2;
}

void brazil_nut(Run& run) {
  const int seeds = run.setting().effort == Effort::full ? 10 : 2;
  int risen = 0;
  for (int s = 0; s < seeds; ++s) {
    Plot& plot = run.plot("Share of the grains below the large one", "t [s]", "share");
    risen += rises(run, std::uint32_t(run["seed"]) + std::uint32_t(s), plot);
  }
  run.check("rises, of " + std::to_string(seeds) + " seeds", "1", seeds, risen, 0);
}

}

std::vector<Case> grains() {
  return {
      {.id = "V47",
       .title = "Angle of repose",
       .group = "Grains",
       .formula = "20° … 25° for balls with μ = 0.5 that nothing keeps from rolling",
       .source = "measured range, e.g. Zhou et al., Powder Technol. 125 (2002) 45",
       .parameters = {{"length", 14, 8, 100, "d"},
                      {"grains", 500, 50, 1e5, whole_number},
                      {"friction", 0.5, 0.1, 1, "1"},
                      {"seed", 1, 0, 1e9, whole_number}},
       .sets = {{"other seeds", {{"seed", 101}}}},
       .run = angle_of_repose,
       .without = {"friction"},
       .bite = {.effort = Effort::full},
       .effort = Effort::normal},
      {.id = "V50",
       .title = "Brazil nut",
       .group = "Grains",
       .formula = "the large ball rises, whatever the seed",
       .source = "Rosato et al., Phys. Rev. Lett. 58 (1987) 1038",
       .parameters = {{"grains", 150, 50, 5000, whole_number},
                      {"strength", 3, 1.2, 10, "g"},
                      {"time", 40, 1, 300, "s"},
                      {"seed", 1, 0, 1e9, whole_number}},
       .sets = {{"stronger", {{"strength", 5}}}},
       .run = brazil_nut,
       .without = {"shaking"},
       .bite = {.values = {{"grains", 100}, {"strength", 5}, {"time", 10}}},
       .effort = Effort::normal},
  };
}

}
