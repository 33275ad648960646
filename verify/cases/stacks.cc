// Structures at rest: towers and their forces, overhangs, an arch, heavy on light, houses of cards.
#include <algorithm>
#include <cmath>

#include "verify/cases/cases.h"
#include "verify/numerics.h"
#include "verify/scene.h"

namespace sudar::verify {

namespace {

// The mean force that body a bears from body b, N, over the world's last second.
class MeanForce {
 public:
  void sample(const World& w, double h) {
    ++samples_;
    for (const Contact& c : w.contacts()) {
      for (int k = 0; k < c.count; ++k) {
        const double force = double(c.points[std::size_t(k)].normal_impulse) / h;
        sum_[{c.a, c.b}] += force;
        (c.points[std::size_t(k)].at.x < 0 ? left_ : right_)[{c.a, c.b}] += force;
      }
    }
  }
  using Pair = std::pair<Body, Body>;
  double between(Body a, Body b) const { return of(sum_, a, b); }
  double left(Body a, Body b) const { return of(left_, a, b); }
  double right(Body a, Body b) const { return of(right_, a, b); }

 private:
  double of(const std::map<Pair, double>& sums, Body a, Body b) const {
    const auto at = sums.find({std::max(a, b), std::min(a, b)}), other = sums.find({std::min(a, b), std::max(a, b)});
    return ((at != sums.end() ? at->second : 0) + (other != sums.end() ? other->second : 0)) / samples_;
  }
  std::map<Pair, double> sum_, left_, right_;
  double samples_ = 0;
};

// V22. What the contacts of a tower report; and the two edges under a cube whose centre of mass is off its middle.
void tower_forces(Run& run) {
  const double g = standard_gravity, m = run["mass"];
  const int n = int(run["cubes"]);
  World w(run.config());
  add_gravity(w, run.with("gravity", g));
  std::vector<Body> cubes{add_ground(w, material(0.6))};
  for (int i = 0; i < n; ++i) cubes.push_back(w.add({.shape = box({1, 1, 1}), .at = {0, i + 0.5, 0}, .mass = Real(m), .material = material(0.6)}));
  run.until(w, 2);
  MeanForce mean;
  run.until(w, 3, [&] { mean.sample(w, run.h()); });
  double worst = 0;
  Plot& plot = run.plot("Force under each cube", "cubes carried", "F [N]");
  for (int k = 1; k <= n; ++k) {
    const double got = mean.between(cubes[std::size_t(n - k)], cubes[std::size_t(n - k) + 1]);
    worst = std::max(worst, std::fabs(got / (k * m * g) - 1));
    plot.theory.emplace_back(k, k * m * g);
    plot.simulation.emplace_back(k, got);
  }
  run.relative("force under the tower", "N", n * m * g, mean.between(cubes[0], cubes[1]), 0.005);
  run.below("largest relative error of a contact", "1", worst, 0.005);

  const double off = run["offset"];
  World o(run.config());
  add_gravity(o, run.with("gravity", g));
  const Body ground = add_ground(o, material(0.6));
  const Body cube = o.add({.shape = box({1, 1, 1}), .at = {0, 0.5, 0}, .mass = Real(m), .center = Vec3{Real(off), 0, 0}, .material = material(0.6)});
  run.until(o, 2);
  MeanForce edges;
  run.until(o, 3, [&] { edges.sample(o, run.h()); });
  run.relative("cube off its middle: near edge", "N", (0.5 + off) * m * g, edges.right(cube, ground), 0.005);
  run.relative("cube off its middle: far edge", "N", (0.5 - off) * m * g, edges.left(cube, ground), 0.005);
}

// V23. Blocks that overhang by ½ Σ 1/k of their length just stand.
bool overhang_stands(const Run& run, int n, double share) {
  const double length = 1, height = 0.2;
  World w(run.config());
  add_gravity(w, standard_gravity);
  const Material m = material(0.6);
  w.add({.shape = box({4, 1, 1}), .at = {-2, -0.5, 0}, .material = m, .motion = Motion::fixed});  // its edge at x = 0
  double x = -length / 2;
  std::vector<Body> blocks;
  for (int i = 0; i < n; ++i) {  // from below: each sticks out by length/2k over the one below, k counted from above
    x += share * length / (2 * (n - i));
    blocks.push_back(w.add({.shape = box({Real(length), Real(height), 1}), .at = {x, (i + 0.5) * height, 0}, .mass = 1, .material = m}));
  }
  run.until(w, 10);
  return w[blocks.back()].center().y > (n - 0.5) * height - 0.05;
}

void overhang(Run& run) {
  const int n = int(run["blocks"]);
  run.holds("stands with 98 % of the overhang", overhang_stands(run, n, run.without("the right overhang") ? 1.05 : 0.98));
  run.holds("falls with 102 %", !overhang_stands(run, n, 1.02));
}

// V24. An arch of stones with radial joints stands when a line of thrust fits into it: linear inequalities.
struct Arch {
  int stones;
  double thickness;  // of the middle radius, which is 1
  Vec3d corner(int joint, bool outer) const {
    const double angle = pi * joint / stones, r = 1 + (outer ? thickness : -thickness) / 2;
    return {-r * std::cos(angle), r * std::sin(angle), 0};
  }
  std::array<Vec3d, 4> section(int i) const { return {corner(i, false), corner(i, true), corner(i + 1, true), corner(i + 1, false)}; }
  double area(int i) const {
    double sum = 0;
    for (std::size_t k = 0; k < 4; ++k) sum += cross(section(i)[k], section(i)[(k + 1) % 4]).z / 2;
    return std::fabs(sum);
  }
  Vec3d center(int i) const {
    Vec3d sum;
    double whole = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const Vec3d a = section(i)[k], b = section(i)[(k + 1) % 4];
      const double part = cross(a, b).z;
      sum += (a + b) * part, whole += part;
    }
    return sum / (3 * whole);
  }
  // Normal forces at both ends of each joint, at least 0, and shear of either sign, in equilibrium with the weights.
  bool stands() const {
    const std::size_t columns = std::size_t(stones + 1) * 4;
    std::vector<Vector> a;
    Vector b;
    for (int i = 0; i < stones; ++i) {
      Vector fx(columns, 0), fy(columns, 0), moment(columns, 0);
      for (const int side : {0, 1}) {  // the joint below the stone pushes it on, the one above pushes back
        const double angle = pi * (i + side) / stones, sign = side == 0 ? 1 : -1;
        const Vec3d normal{sign * std::sin(angle), sign * std::cos(angle), 0}, radial{-std::cos(angle), std::sin(angle), 0};
        for (std::size_t k = 0; k < 4; ++k) {
          const std::size_t column = std::size_t(i + side) * 4 + k;
          const Vec3d force = k < 2 ? normal : radial * (k == 2 ? sign : -sign), arm = corner(i + side, k == 1) - center(i);
          fx[column] += force.x, fy[column] += force.y, moment[column] += cross(arm, force).z;
        }
      }
      for (const double sign : {1.0, -1.0}) {
        for (const auto& [row, right] : {std::pair{fx, 0.0}, std::pair{fy, area(i)}, std::pair{moment, 0.0}}) {
          a.push_back(row);
          for (double& x : a.back()) x *= sign;
          b.push_back(sign * right + 1e-9);
        }
      }
    }
    return feasible(a, b);
  }
};

double least_thickness(int stones) {
  double low = 0.02, high = 0.4;
  for (int i = 0; i < 20; ++i) {
    const double middle = (low + high) / 2;
    (Arch{stones, middle}.stands() ? high : low) = middle;
  }
  return (low + high) / 2;
}

bool arch_stands(const Run& run, int stones, double thickness) {
  const Arch arch{stones, thickness};
  World w(run.config());
  add_gravity(w, run.with("gravity", standard_gravity));
  const Material m = material(2);
  add_ground(w, m);
  Body crown;
  for (int i = 0; i < stones; ++i) {
    std::vector<Vec3> points;
    for (const Vec3d& p : arch.section(i)) {
      for (const double z : {-0.25, 0.25}) points.push_back(convert<Real>(Vec3d{p.x, p.y, z}));
    }
    const Body stone = w.add({.shape = hull(points), .density = 1000, .material = m});
    if (i == stones / 2) crown = stone;
  }
  const double start = w[crown].center().y;
  run.until(w, 10);
  return w[crown].center().y > start - 0.1;
}

void arch(Run& run) {
  const int stones = int(run["stones"]);
  const double least = least_thickness(stones);
  run.check("least thickness of many stones / radius", "1", 0.1075, least_thickness(60), 0.001);
  run.holds("stands with 1.15 of the least thickness", arch_stands(run, stones, (run.without("thickness") ? 0.8 : 1.15) * least));
  run.holds("falls with 0.85", !arch_stands(run, stones, 0.85 * least));

  // A hanging chain of rods: tan θ = V/H, and H so that the span is right.
  const int n = int(run["rods"]);
  const double span = run["span"], l = 4.0 / n, weight = 0.4 * standard_gravity / n * 10.0 / 4;
  const auto reach = [&](double pull) {
    double x = 0;
    for (int i = 0; i < n; ++i) x += l / std::sqrt(1 + square(weight * (i - (n - 1) / 2.0) / pull));
    return x - span;
  };
  const double pull = root(reach, 1e-3, 1e3);
  double sag = 0;
  World w(run.config());
  add_gravity(w, standard_gravity);
  // Starts in its own shape, pushed down in the middle by nothing: any error of a joint shows as sag.
  Pos at{-span / 2, 0, 0};
  Body before;
  std::vector<Joint> joints;
  std::vector<Body> rods;
  for (int i = 0; i < n; ++i) {
    const double angle = std::atan(weight * (i - (n - 1) / 2.0) / pull);
    const Vec3d along{std::cos(angle), std::sin(angle), 0};
    sag += i < n / 2 ? -l * along.y : 0;
    BodyDef rod = thin_rod(l, weight / standard_gravity);
    rod.at = at + along * (l / 2), rod.turn = axis_angle(Vec3{0, 0, 1}, Real(angle));
    rod.filter.group = -1;
    const Body now = w.add(rod);
    joints.push_back(w.join(Ball{.a = before, .b = now, .at = at}));
    at = at + along * l;
    before = now;
    rods.push_back(now);
  }
  joints.push_back(w.join(Ball{.a = before, .at = at}));
  run.until(w, 5);
  const double lowest = w[joints[std::size_t(n / 2)]].anchor_b().y;
  run.relative("chain of rods: sag", "m", sag, -lowest, 0.005);
  run.relative("chain of rods: level pull", "N", pull, std::fabs(double(w[joints[std::size_t(n / 2)]].load().force.x)), 0.005);
}

// V43. A heavy cube on a light one.
void heavy_on_light(Run& run) {
  const double ratio = run["ratio"];
  Config c = run.config();
  c.impulse_2007.slop = Real(0.0005);
  World w(c);
  add_gravity(w, standard_gravity);
  const Material m = material(0.6);
  add_ground(w, m);
  const Body light = w.add({.shape = box({1, 1, 1}), .at = {0, 0.5, 0}, .mass = 1, .material = m});
  const Body heavy = w.add({.shape = box({1, 1, 1}), .at = {0, 1.5, 0}, .mass = Real(ratio), .material = m});
  Plot& plot = run.plot("Height of the heavy cube", "t [s]", "y [m]");
  run.until(w, 10, [&] { plot.simulation.emplace_back(w.time(), w[heavy].center().y); });
  plot.theory = {{0, 1.5}, {10, 1.5}};
  run.check("height of the light cube", "m", 0.5, w[light].center().y, 0.01);
  run.check("height of the heavy cube", "m", 1.5, w[heavy].center().y, 0.01);
}

// V45. Towers of cubes for 30 s.
void towers(Run& run) {
  const int n = int(run["cubes"]);
  Config c = run.config();
  c.impulse_2007.slop = Real(0.0005);
  World w(c);
  add_gravity(w, standard_gravity);
  const Material m = material(0.6);
  add_ground(w, m);
  Body top;
  for (int i = 0; i < n; ++i) top = w.add({.shape = box({1, 1, 1}), .at = {0, i + 0.5, 0}, .mass = 1, .material = m});
  Plot& plot = run.plot("Sinking of the top", "t [s]", "y − y₀ [m]");
  run.until(w, 30, [&] {
    if (w.steps() % 10 == 0) plot.simulation.emplace_back(w.time(), w[top].center().y - (n - 0.5));
  });
  plot.theory = {{0, 0}, {30, 0}};
  run.check("sinking of the top", "m", 0, w[top].center().y - (n - 0.5), 0.1);
}

// V46. Two cards that lean on each other stand when μ ≥ ½ tan of half the angle between them.
bool cards_stand(const Run& run, double half, double mu) {
  constexpr double length = 1, thickness = 0.01;
  Config c = run.config();
  c.impulse_2007.slop = Real(0.0005);
  World w(c);
  add_gravity(w, standard_gravity);
  add_ground(w, material(mu));
  std::vector<Body> cards;
  for (const double side : {-1.0, 1.0}) {
    // The card's upper inner edge is at the apex (0, y), its lower inner corner on the floor.
    const Quat turn = axis_angle(Vec3{0, 0, 1}, Real(side * half));
    const Vec3d inner{-side * thickness / 2, length / 2, 0}, up = rotate(convert<double>(turn), inner);
    const Vec3d low = rotate(convert<double>(turn), Vec3d{-side * thickness / 2, -length / 2, 0});
    cards.push_back(w.add({.shape = box({Real(thickness), Real(length), 1}), .at = {-up.x, -low.y, 0}, .turn = turn, .mass = Real(0.1), .material = material(mu)}));
  }
  const double start = w[cards[0]].center().y;
  run.until(w, 5);
  return w[cards[0]].center().y > start - 0.02;
}

void cards(Run& run) {
  const double half = run["half angle"] * pi / 180, mu = std::tan(half) / 2;
  run.holds("stands with 1.1 of the friction", cards_stand(run, half, 1.1 * run.with("friction", mu)));
  run.holds("slides with 0.9", !cards_stand(run, half, 0.9 * mu));
}

}

std::vector<Case> stacks() {
  return {
      {.id = "V22",
       .title = "Forces in a tower",
       .group = "Structures",
       .formula = "k m g under k cubes; edges (½ ± x/a) m g",
       .source = "statics",
       .parameters = {{"cubes", 10, 1, 30, "1"}, {"mass", 1, 0.01, 100, "kg"}, {"offset", 0.1, -0.4, 0.4, "m"}},
       .sets = {{"five, heavy", {{"cubes", 5}, {"mass", 20}, {"offset", 0.25}}}},
       .run = tower_forces,
       .without = "gravity",
       .others = "Rapier pins m g Δt to 1 %; Box3D reports twice as much"},
      {.id = "V23",
       .title = "Harmonic overhang",
       .group = "Structures",
       .formula = "½ Σ 1/k lengths",
       .source = "statics",
       .parameters = {{"blocks", 4, 2, 20, "1"}},
       .sets = {{"three", {{"blocks", 3}}}, {"five", {{"blocks", 5}}}, {"ten", {{"blocks", 10}}}},
       .run = overhang,
       .without = "the right overhang"},
      {.id = "V24",
       .title = "Arch and hanging chain",
       .group = "Structures",
       .formula = "least thickness 0.1075 R of a half circle; tan θᵢ = Vᵢ/H",
       .source = "Milankovitch 1907; the line of thrust as linear inequalities; statics of a chain of rods",
       .parameters = {{"stones", 16, 6, 60, "1"}, {"rods", 20, 2, 100, "1"}, {"span", 3, 1, 3.9, "m"}},
       .sets = {{"twelve stones", {{"stones", 12}, {"span", 2}}}},
       .run = arch,
       .without = "thickness"},
      {.id = "V43",
       .title = "Heavy cube on a light one",
       .group = "Structures",
       .formula = "heights ½ and ³⁄₂",
       .source = "statics",
       .parameters = {{"ratio", 10, 1, 1e7, "1"}},
       .sets = {{"100", {{"ratio", 100}}}, {"1000", {{"ratio", 1e3}}}, {"10⁴", {{"ratio", 1e4}}}, {"10⁶", {{"ratio", 1e6}}}},
       .run = heavy_on_light,
       .without = "impulses",
       .others = "10: all; 100: Box3D, Rapier 1.465, PhysX TGS 1.475, Havok 1.468; 1000: Box3D 1.16, MuJoCo 0.95; 10⁴: none"},
      {.id = "V45",
       .title = "Towers of cubes",
       .group = "Structures",
       .formula = "stands for 30 s, sinks by 0",
       .source = "statics",
       .parameters = {{"cubes", 10, 1, 200, "1"}},
       .sets = {{"25", {{"cubes", 25}}}, {"50", {{"cubes", 50}}}, {"100", {{"cubes", 100}}}},
       .run = towers,
       .without = "impulses",
       .effort = Effort::normal,
       .others = "Box3D, Rapier sink 0.026, 0.167, 0.68, 2.8 m; Jolt, Havok, Bullet, PhysX, MuJoCo fall at 25"},
      {.id = "V46",
       .title = "House of cards",
       .group = "Structures",
       .formula = "μ ≥ ½ tan of half the angle",
       .source = "torques about the feet",
       .parameters = {{"half angle", 15, 5, 40, "°"}},
       .sets = {{"10°", {{"half angle", 10}}}, {"20°", {{"half angle", 20}}}},
       .run = cards,
       .without = "friction"},
  };
}

}
