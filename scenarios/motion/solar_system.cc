// The sun and its planets, in millions of kilometres and 10²⁴ kg, so that floats suffice; planets are drawn larger than
// they are. A step is six hours: simulated time runs two million times faster than the step's own (thesis (3.4), k).
// Started with the mean velocity of the step that leads there, v₀ = (x₀ − x₋₁)/h, an orbit keeps its radius; started
// with the velocity of the moment it swings by ω h / 2.
#include "thesis.h"

using namespace sudar;

struct SolarSystem : Scenario {
  static constexpr double day = 86400, year = 365.25 * day;
  static constexpr double seconds = 10 * year;
  static constexpr double picture = 0.4 * year;
  static constexpr const char* about = "the planets' orbits; time runs two million times faster";
  struct Planet {
    const char* name;
    double orbit, mass, drawn;  // 10⁹ m, 10²⁴ kg, 10⁹ m; NASA planetary fact sheet
  };
  static constexpr Planet data[] = {{"Mercury", 57.909, 0.33010, 8},  {"Venus", 108.210, 4.8673, 14},
                                    {"Earth", 149.598, 5.9722, 14},   {"Mars", 227.956, 0.64169, 11},
                                    {"Jupiter", 778.479, 1898.1, 40}, {"Saturn", 1432.041, 568.32, 35},
                                    {"Uranus", 2867.043, 86.811, 25}, {"Neptune", 4514.953, 102.41, 25}};
  static constexpr double sun_mass = 1988500, g = 6.6743e-14;  // of (10⁹ m)³ / (10²⁴ kg s²)
  int count = 8;
  bool fixed_sun = false, staggered = true;
  Body sun;
  std::vector<Body> planets;
  std::vector<double> angle, heading;  // gone round so far; where it is now, rad
  double swing = 0;                    // largest relative change of a distance from the sun

  void params(Params& p) override {
    p("planets", count, 1, int(std::size(data))), p("fixed_sun", fixed_sun, "the sun does not move");
    p("staggered", staggered, "start with the mean velocity of the step before");
  }
  void state(State& s) override {
    s("sun", sun), s("planets", planets), s("angle", angle), s("heading", heading), s("swing", swing);
  }
  void config(Config& c) override {
    c = thesis_config();
    c.time_factor = Real(0.25 * day / c.dt);
    c.sleep = false;  // 30 km/s are 3·10⁻⁵ in these units
  }

  double rate(int i) const {
    const double mass = sun_mass + (fixed_sun ? 0 : data[i].mass);
    return sqrt(g * mass / data[i].orbit) / data[i].orbit;
  }
  void build(World& w) override {
    w.add(NBody{.gravitational_constant = Real(g)});
    sun = w.add({.shape = sphere(30),
                 .mass = Real(sun_mass),
                 .motion = fixed_sun ? Motion::fixed : Motion::dynamic,
                 .name = "Sun"});
    const double h = w.config().dt * w.config().time_factor;
    Vec3d momentum;
    for (int i = 0; i < count; ++i) {
      const double start = 2.4 * i, orbit = data[i].orbit, omega = rate(i);
      // In steps of h, x₋₁ − 2x₀ + x₁ = −h² ω² x₀ keeps to a circle if it turns by φ a step, sin(φ/2) = ωh/2. The chord
      // from x₋₁ to x₀ is half a step behind, and has the speed of the circle.
      const double ahead = start - (staggered ? sudar::asin(omega * h / 2) : 0);
      const Vec3d v{-orbit * omega * sudar::sin(ahead), 0, -orbit * omega * sudar::cos(ahead)};
      momentum += v * data[i].mass;
      planets.push_back(w.add({.shape = sphere(Real(data[i].drawn)),
                               .at = {orbit * sudar::cos(start), 0, -orbit * sudar::sin(start)},
                               .velocity = convert<Real>(v),
                               .mass = Real(data[i].mass),
                               .name = data[i].name}));
      angle.push_back(0), heading.push_back(direction(w, i));
    }
    if (!fixed_sun) w.set_velocity(sun, convert<Real>(momentum / -sun_mass), {});
  }

  double direction(const World& w, int i) const {
    const Pos p = w[planets[std::size_t(i)]].center(), s = w[sun].center();
    return sudar::atan2(-(p.z - s.z), p.x - s.x);
  }
  void observe(const World& w, Check& c) override {
    for (int i = 0; i < count; ++i) {
      const std::size_t k = std::size_t(i);
      const double now = direction(w, i), off = now - heading[k];
      angle[k] += off - 2 * pi * std::round(off / (2 * pi));
      heading[k] = now;
      const double distance = horizontal_distance(w[planets[k]].center(), w[sun].center());
      swing = max(swing, abs(distance / data[i].orbit - 1));
    }
    c.below("largest change of a distance from the sun", swing, expected_swing());
  }
  // A lone orbit, well started, is a circle but for rounding, here over 1000 orbits; otherwise ω h / 2, and neighbours.
  double expected_swing() const {
    if (count > 1 || !fixed_sun || !staggered) return 0.02;
    return sizeof(Real) == 4 ? 1e-4 : 1e-6;
  }
  void check(const World& w, Check& c) override {
    for (int i = 0; i < min(count, 4); ++i) {
      const double period = 2 * pi / rate(i) / day;
      c.near(std::string(data[i].name) + ": a turn takes", 2 * pi / angle[std::size_t(i)] * w.time() / day, period,
             (count == 1 ? 1e-4 : 2e-3) * period, "days");  // together they disturb each other
    }
  }
  std::optional<Camera> camera() const override { return Camera{{60, 170, 480}, {0, -10, 0}}; }
};
SUDAR_SCENARIO(SolarSystem, "Motion/Solar system")
