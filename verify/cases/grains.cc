// Many balls: a heap, an hourglass, a silo, a shaken box. What is known of them is measured, not derived: ranges.
// Lengths are in diameters of a grain, which is 1 m: the laws have no length of their own.
#include <algorithm>
#include <cmath>

#include "verify/cases/cases.h"
#include "verify/numerics.h"
#include "verify/scene.h"

namespace sudar::verify {

namespace {

constexpr double grain_mass = 1;

// A shaft of width × width about the y axis, open above and below.
void add_shaft(World& w, double width, const Material& m) {
  for (int side = 0; side < 4; ++side) {
    const double angle = side * pi / 2;
    const Quat turn =
        axis_angle(Vec3{0, 1, 0}, Real(angle)) * axis_angle(Vec3{0, 0, 1}, Real(pi / 2));  // y to −x, and on
    add_ground(w, m, Pos{} - rotate(convert<double>(turn), Vec3d{0, width / 2, 0}), turn);
  }
}

Body add_grain(World& w, const Pos& at, const Material& m, const Vec3& velocity = {}) {
  return w.add({.shape = sphere(0.5), .at = at, .velocity = velocity, .mass = Real(grain_mass), .material = m});
}

// n grains in the shaft above y, loosely, each a little off its place.
std::vector<Body> fill(World& w, int n, double width, double y, const Material& m, Random& random) {
  const int side = int(width / 1.25);  // room to fall out of order
  const double pitch = width / side;
  std::vector<Body> grains;
  for (int i = 0; i < n; ++i) {
    const double wobble = (pitch - 1) / 2;
    const auto place = [&](int k) { return (k + 0.5) * pitch - width / 2 + random.between(-wobble, wobble); };
    grains.push_back(
        add_grain(w, {place(i % side), y + 0.55 + 1.1 * double(i / (side * side)), place(i / side % side)}, m));
  }
  return grains;
}

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
  double angle = 0;
  for (const std::uint32_t i : {0u, 1u}) {
    const auto profile = slope_that_stays(run, std::uint32_t(run["seed"]) + i);
    angle += std::atan(-slope(profile)) * 180 / pi / 2;
    plot.simulation.insert(plot.simulation.end(), profile.begin(), profile.end());
  }
  run.check("angle of repose, mean of two, range 20 … 25", "°", 22.5, angle, 2.5);
}

// V48. What runs out of a round hole: W = 0.58 ρ √g (D − 1.4 d)^⁵⁄₂, whatever the filling (Beverloo).
struct Discharge {
  double flow, density;  // grains a second; grains in a volume of d³
};

// The height under which 99 of 100 grains lie.
double top_of(const World& w, const std::vector<Body>& grains) {
  std::vector<double> heights;
  for (const Body b : grains) heights.push_back(w[b].center().y);
  std::sort(heights.begin(), heights.end());
  return heights[heights.size() * 99 / 100] + 0.5;
}

// A floor with a round hole: sixteen slabs around it, which reach below the walls.
void add_floor(World& w, double hole, double outer, const Material& m) {
  constexpr int parts = 16;
  for (int i = 0; i < parts; ++i) {
    std::vector<Vec3> corners;
    for (const int k : {i, i + 1}) {
      const double angle = 2 * pi * k / parts, inner = hole / 2 / std::cos(pi / parts);
      for (const double r : {inner, outer}) {
        for (const double y : {-1.0, 0.0})
          corners.push_back(convert<Real>(Vec3d{r * std::cos(angle), y, r * std::sin(angle)}));
      }
    }
    w.add({.shape = hull(corners), .material = m, .motion = Motion::fixed});
  }
}

// The law holds while the bed is higher than twice the hole: longer is not measured.
Discharge discharge(Run& run, World& w, std::vector<Body> grains, double hole) {
  const double width = run["width"], density = double(grains.size()) / (width * width * top_of(w, grains)),
               begin = w.time(), least = 2 * hole * density * width * width;
  std::vector<std::pair<double, double>> out;
  double gone = 0;
  Plot& plot = run.plot("Grains that ran out of a hole of " + std::to_string(int(hole)) + " d", "t [s]", "n");
  run.until(w, begin + 5, [&] {
    std::erase_if(grains, [&](Body b) {
      if (w[b].center().y > -5) return false;
      w.remove(b);
      ++gone;
      return true;
    });
    plot.simulation.emplace_back(w.time() - begin, gone);
    plot.theory.emplace_back(w.time() - begin, 0.58 * density * std::sqrt(standard_gravity) *
                                                   std::pow(hole - 1.4, 2.5) * (w.time() - begin));
    if (w.time() > begin + 1 && double(grains.size()) > least) out.emplace_back(w.time(), gone);
  });
  return {slope(out), density};
}

void hourglass(Run& run) {
  const double width = run["width"];
  World w(run.config());
  add_gravity(run, w);
  const Material m = material(run["friction"]);
  add_shaft(w, width, m);
  const Body plug =
      w.add({.shape = box({Real(width), 1, Real(width)}), .at = {0, -0.5, 0}, .material = m, .motion = Motion::fixed});
  Random random{std::uint32_t(run["seed"])};
  const std::vector<Body> grains = fill(w, int(run["grains"]), width, 0, m, random);
  run.until(w, 4);
  const Bytes filled = w.save();
  std::vector<std::pair<double, double>> logs;
  double got = 0, exact = 0;
  for (const double hole : {run["hole"] - 1, run["hole"], run["hole"] + 1}) {
    w.load(filled);
    add_floor(w, hole, width, m);
    if (!run.without("hole")) w.remove(plug);
    const auto [flow, density] = discharge(run, w, grains, hole);
    logs.emplace_back(std::log(hole - 1.4), std::log(std::max(flow, 1e-9)));
    if (hole == run["hole"])
      got = flow, exact = 0.58 * density * std::sqrt(standard_gravity) * std::pow(hole - 1.4, 2.5);
  }
  run.relative("grains a second", "1/s", exact, got, 0.1);
  run.check("exponent of D − 1.4 d", "1", 2.5, slope(logs), 0.1);
}

// V49. The walls of a silo bear part of the weight: p = ρ g λ (1 − e^(−z/λ)), λ = D/4μK (Janssen), K between 0.4 and
// 0.8.
struct SiloFloor {
  double pressure, depth, density;  // Pa, m, kg/m³
};

SiloFloor silo_floor(Run& run, int n) {
  const double width = run["width"];
  World w(run.config());
  add_gravity(run, w);
  const Material m = material(run.with("friction", run["friction"]));
  add_shaft(w, width, m);
  // The floor sinks slowly, so that the walls carry what they can.
  const double sinks = 0.05;
  const Body floor = w.add({.shape = box({Real(2 * width), 2, Real(2 * width)}),
                            .at = {0, -1, 0},
                            .velocity = {0, Real(-sinks), 0},
                            .material = m,
                            .motion = Motion::kinematic});
  Random random{std::uint32_t(run["seed"])};
  const std::vector<Body> grains = fill(w, n, width, 0, m, random);
  double force = 0, samples = 0, settled = 6;
  run.until(w, settled + 4, [&] {
    if (w.time() < settled) return;
    ++samples;
    for (const Contact& c : w.contacts()) {
      if (c.a != floor && c.b != floor) continue;
      for (int k = 0; k < c.count; ++k)
        force += double(c.points[std::size_t(k)].normal_impulse) * std::fabs(double(c.normal.y)) / run.h();
    }
  });
  const double depth = top_of(w, grains) - (w[floor].center().y + 1);
  return {force / samples / (width * width), depth, n * grain_mass / (width * width * depth)};
}

double janssen(double friction, double width, double k, const SiloFloor& f) {
  const double lambda = width / (4 * friction * k);
  return f.density * standard_gravity * lambda * (1 - std::exp(-f.depth / lambda));
}

void silo(Run& run) {
  const int n = int(run["grains"]);
  const SiloFloor full = silo_floor(run, n), half = silo_floor(run, n / 2);
  const auto off = [&](double k) { return janssen(run["friction"], run["width"], k, full) - full.pressure; };
  const double fitted = off(0.05) > 0 && off(5) < 0 ? root(off, 0.05, 5) : std::nan("");
  run.check("K fitted to the pressure, range 0.4 … 0.8", "1", 0.6, fitted, 0.2);
  run.check("pressure under the full silo / under the half (weight alone: 2)", "1",
            janssen(run["friction"], run["width"], 0.6, full) / janssen(run["friction"], run["width"], 0.6, half),
            full.pressure / half.pressure, 0.3);
  Plot& plot = run.plot("Pressure on the floor", "depth [d]", "p [Pa]");
  for (int i = 0; i <= 50; ++i) {
    const double z = full.depth * i / 50;
    plot.theory.emplace_back(z, janssen(run["friction"], run["width"], 0.6, {0, z, full.density}));
  }
  plot.simulation = {{half.depth, half.pressure}, {full.depth, full.pressure}};
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
       .sets = {{"other seeds", {{"seed", 3}}}},
       .run = angle_of_repose,
       .without = {"friction"},
       .bite = {.effort = Effort::full},
       .effort = Effort::normal},
      {.id = "V48",
       .title = "Hourglass",
       .group = "Grains",
       .formula = "W = 0.58 ρ √g (D − 1.4 d)^⁵⁄₂ with a bed higher than 2 D",
       .source = "Beverloo et al., Chem. Eng. Sci. 15 (1961) 260",
       .parameters = {{"hole", 7, 4, 12, "d"},
                      {"width", 14, 8, 40, "d"},
                      {"grains", 4500, 100, 1e5, whole_number},
                      {"friction", 0.5, 0, 1, "1"},
                      {"seed", 1, 0, 1e9, whole_number}},
       .sets = {{"another seed", {{"seed", 2}}}},
       .run = hourglass,
       .without = {"hole", "gravity"},
       .bite = {.values = {{"grains", 1500}, {"width", 10}, {"hole", 5}}, .effort = Effort::full},
       .effort = Effort::full},
      {.id = "V49",
       .title = "Silo",
       .group = "Grains",
       .formula = "p = ρ g λ (1 − e^(−z/λ)), λ = D/4μK, K = 0.4 … 0.8",
       .source = "Janssen 1895; a square shaft has the same λ",
       .parameters = {{"width", 6, 3, 20, "d"},
                      {"grains", 600, 50, 1e5, whole_number},
                      {"friction", 0.5, 0.1, 1, "1"},
                      {"seed", 1, 0, 1e9, whole_number}},
       .sets = {{"another seed", {{"seed", 2}}}},
       .run = silo,
       .without = {"friction", "gravity"},
       .bite = {.values = {{"grains", 120}}},
       .effort = Effort::normal},
      {.id = "V50",
       .title = "Brazil nut",
       .group = "Grains",
       .formula = "the large ball rises, whatever the seed",
       .source = "Rosato et al., Phys. Rev. Lett. 58 (1987) 1038",
       .parameters = {{"grains", 150, 50, 5000, whole_number},
                      {"strength", 3, 1.2, 10, "g"},
                      {"time", 25, 1, 300, "s"},
                      {"seed", 1, 0, 1e9, whole_number}},
       .sets = {{"stronger", {{"strength", 5}}}},
       .run = brazil_nut,
       .without = {"shaking"},
       .bite = {.values = {{"grains", 100}, {"strength", 5}, {"time", 10}}},
       .effort = Effort::normal},
  };
}

}
