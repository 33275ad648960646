// Many balls between walls: an hourglass, a silo.
#include <algorithm>
#include <cmath>

#include "verify/cases/cases.h"
#include "verify/cases/grain_scene.h"
#include "verify/numerics.h"

namespace sudar::verify {

namespace {

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

double beverloo(double density, double hole) {  // grains a second
  return 0.58 * density * std::sqrt(standard_gravity) * std::pow(hole - 1.4, 2.5);
}

// The law holds while the bed is higher than twice the hole: longer is not measured.
Discharge discharge(Run& run, World& w, std::vector<Body> grains, double hole) {
  const double width = run["width"], density = double(grains.size()) / (width * width * top_of(w, grains)),
               begin = w.time(), least = 2 * hole * density * width * width;
  const double law = beverloo(density, hole), falls = std::sqrt(2 * 5 / standard_gravity);  // s, to where they count
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
    plot.theory.emplace_back(w.time() - begin, law * std::max(0.0, w.time() - begin - falls));
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
    if (hole == run["hole"]) got = flow, exact = beverloo(density, hole);
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

}

std::vector<Case> silos() {
  return {
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
       .bite = {.effort = Effort::full},
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
  };
}

}
