// Structures that stand by their shape: an arch, a hanging chain, houses of cards.
#include <algorithm>
#include <cmath>

#include "verify/cases/cases.h"
#include "verify/numerics.h"
#include "verify/scene.h"

namespace sudar::verify {

namespace {

// V24. A half circle of stones with radial joints; the middle radius is 1. It stands when a line of thrust fits into
// it.
struct Arch {
  int stones;  // even
  double thickness;
  Vec3d corner(int joint, bool outer) const {
    const double angle = pi * joint / stones, r = 1 + (outer ? thickness : -thickness) / 2;
    return {-r * std::cos(angle), r * std::sin(angle), 0};
  }
  std::array<Vec3d, 4> section(int i) const {
    return {corner(i, false), corner(i, true), corner(i + 1, true), corner(i + 1, false)};
  }
  // Area, and its moment about the y axis, of the stone between joints i and i + 1.
  std::pair<double, double> weight(int i) const {
    double area = 0, moment = 0;
    const std::array<Vec3d, 4> s = section(i);
    for (std::size_t k = 0; k < 4; ++k) {
      const Vec3d a = s[k], b = s[(k + 1) % 4];
      const double part = (a.x * b.y - a.y * b.x) / 2;
      area += part, moment += part * (a.x + b.x) / 3;
    }
    return {std::fabs(area), area < 0 ? -moment : moment};
  }
  // By symmetry the crown carries a level thrust H at the height m/H. What stands between joint and crown is in
  // equilibrium when the force of the joint, (H, W), acts at the radius s with s (W cos θ + H sin θ) = m − Σ x W; the
  // joint bears it when s is within the thickness: two linear inequalities a joint in H and m.
  bool stands() const {
    std::vector<Vector> a;
    Vector b;
    double area = 0, moment = 0;
    for (int joint = stones / 2; joint >= 0; --joint) {
      const double angle = pi * joint / stones, weighs = area * std::cos(angle);
      for (const double sign : {1.0, -1.0}) {
        const double s = 1 + sign * thickness / 2;  // m − moment ≤ s (…) outside, ≥ inside
        a.push_back({-sign * s * std::sin(angle), sign});
        b.push_back(sign * (s * weighs + moment));
      }
      if (joint == 0) break;
      const auto [stone, arm] = weight(joint - 1);
      area += stone, moment += arm;
    }
    return feasible(a, b);
  }
};

double least_thickness(int stones) {
  double low = 0.01, high = 0.4;
  for (int i = 0; i < 30; ++i) {
    const double middle = (low + high) / 2;
    (Arch{stones, middle}.stands() ? high : low) = middle;
  }
  return (low + high) / 2;
}

bool arch_stands(Run& run, int stones, double thickness) {
  const Arch arch{stones, thickness};
  World w(with_small_slop(run.config()));
  add_gravity(run, w);
  const Material m = material(2);
  add_ground(w, m);
  Body crown;
  for (int i = 0; i < stones; ++i) {
    std::vector<Vec3> points;
    for (const Vec3d& p : arch.section(i)) {
      for (const double z : {-0.25, 0.25}) points.push_back(convert<Real>(Vec3d{p.x, p.y, z}));
    }
    const Body stone = w.add({.shape = hull(points), .material = m});
    if (i == stones / 2) crown = stone;
  }
  const double start = w[crown].center().y;
  run.until(w, 10);
  return w[crown].center().y > start - 0.1;
}

// A chain of rods that hangs in its own shape: tan θ = V/H, and H so that the span is right. It starts there, so any
// give of a joint shows as sag.
void hanging_chain(Run& run) {
  const int n = int(run["rods"]);
  const double span = run["span"], l = 4.0 / n, weight = standard_gravity / n;
  const auto reach = [&](double pull) {
    double x = 0;
    for (int i = 0; i < n; ++i) x += l / std::sqrt(1 + square(weight * (i - (n - 1) / 2.0) / pull));
    return x - span;
  };
  const double pull = root(reach, 1e-3, 1e3);
  World w(run.config());
  add_gravity(run, w);
  Pos at{-span / 2, 0, 0};
  Body before;
  std::vector<Joint> joints;
  double sag = 0;
  for (int i = 0; i < n; ++i) {
    const double angle = std::atan(weight * (i - (n - 1) / 2.0) / pull);
    const Vec3d along{std::cos(angle), std::sin(angle), 0};
    if (i < n / 2) sag -= l * along.y;
    BodyDef rod = thin_rod(l, weight / standard_gravity);
    rod.at = at + along * (l / 2), rod.turn = axis_angle(Vec3{0, 0, 1}, Real(angle));
    const Body now = w.add(rod);
    joints.push_back(w.join(Ball{.a = before, .b = now, .at = at}));
    at = at + along * l;
    before = now;
  }
  joints.push_back(w.join(Ball{.a = before, .at = at}));
  Plot& plot = run.plot("The chain of rods", "x [m]", "y [m]");
  for (const Joint j : joints) plot.theory.emplace_back(w[j].anchor_b().x, w[j].anchor_b().y);
  run.until(w, 5);
  for (const Joint j : joints) plot.simulation.emplace_back(w[j].anchor_b().x, w[j].anchor_b().y);
  const Joint lowest = joints[std::size_t(n / 2)];
  run.relative("chain of rods: sag", "m", sag, -w[lowest].anchor_b().y, 0.005);
  run.relative("chain of rods: level pull", "N", pull, std::fabs(double(w[lowest].load().force.x)), 0.005);
}

void arch(Run& run) {
  const int stones = 2 * int(run["stones"] / 2);
  const double least = least_thickness(stones), share = run.without("thickness") ? 0.8 : 1.15;
  run.check("least thickness / radius of 200 stones, by Milankovitch", "1", 0.1075, least_thickness(200), 0.0005);
  run.holds("stands with 1.15 of the least thickness", arch_stands(run, stones, share * least));
  run.holds("falls with 0.85", !arch_stands(run, stones, 0.85 * least));
  hanging_chain(run);
}

// V46. Cards of unit length that lean on each other, and what lies on them.
class CardHouse {
 public:
  static constexpr double length = 1, thickness = 0.01;
  // The friction is that of the floor; what rubs on cards does not slip.
  CardHouse(Run& run, double half_angle, double friction)
      : world_(with_small_slop(run.config())), half_(half_angle), cards_(material(2)) {
    add_gravity(run, world_);
    add_ground(world_, material(square(friction) / 2));  // mixed geometrically
  }
  // Two cards whose upper inner edges meet at x, and whose feet stand at height y. Gives the height of the meeting.
  double lean(double x, double y) {
    double top = 0;
    for (const double side : {-1.0, 1.0}) {
      const Quat turn = axis_angle(Vec3{0, 0, 1}, Real(side * half_));
      const Quatd q = convert<double>(turn);
      const Vec3d up = rotate(q, Vec3d{-side * thickness / 2, length / 2, 0});
      const Vec3d low = rotate(q, Vec3d{side * thickness / 2, -length / 2, 0});
      add({.shape = box({Real(thickness), Real(length), 1}), .at = {x - up.x, y - low.y, 0}, .turn = turn});
      // The outer upper edge is the higher one.
      top = y - low.y + rotate(q, Vec3d{side * thickness / 2, length / 2, 0}).y;
    }
    return top;
  }
  // A level card on top. Gives the height of its upper side.
  double cover(double y) {
    add({.shape = box({Real(spread() * 2 + 0.2), Real(thickness), 1}), .at = {0, y + thickness / 2, 0}});
    return y + thickness;
  }
  // Between two meetings: the inner feet must not reach each other, for they would hold what friction does not.
  double spread() const { return 2 * length * std::sin(half_) + 0.5; }
  bool stands(Run& run, const std::string& name) {
    std::vector<double> heights;
    for (const Body b : cards) heights.push_back(world_[b].center().y);
    Plot& plot = run.plot(name, "t [s]", "height of the highest card [m]");
    const std::size_t top = cards.size() - 1;
    run.until(world_, 5, [&] { plot.simulation.emplace_back(world_.time(), world_[cards[top]].center().y); });
    plot.theory = {{0, heights[top]}, {5, heights[top]}};
    for (std::size_t i = 0; i < cards.size(); ++i) {
      if (world_[cards[i]].center().y < heights[i] - 0.03) return false;
    }
    return true;
  }

 private:
  void add(BodyDef def) {
    def.mass = Real(0.1), def.material = cards_;
    cards.push_back(world_.add(def));
  }
  World world_;
  double half_;
  Material cards_;
  std::vector<Body> cards;
};

bool cards_stand(Run& run, double half, double friction) {
  CardHouse house(run, half, friction);
  house.lean(0, 0);
  return house.stands(run, "One storey, μ = " + std::to_string(friction));
}

bool two_storeys_stand(Run& run, double half, double friction) {
  CardHouse house(run, half, friction);
  double top = 0;
  for (const double side : {-0.5, 0.5}) top = house.lean(side * house.spread(), 0);
  house.lean(0, house.cover(top));
  return house.stands(run, "Two storeys, μ = " + std::to_string(friction));
}

void cards(Run& run) {
  const double half = run["half angle"] * pi / 180, one = std::tan(half) / 2, two = std::tan(half) * 1.25 / 1.75;
  run.holds("stands with 1.1 of the friction", cards_stand(run, half, 1.1 * run.with("friction", one)));
  run.holds("slides with 0.9", !cards_stand(run, half, 0.9 * one));
  run.holds("two storeys: stand with 1.1 of the friction",
            two_storeys_stand(run, half, 1.1 * run.with("friction", two)));
  run.holds("two storeys: slide with 0.9", !two_storeys_stand(run, half, 0.9 * two));
}

}

std::vector<Case> arches() {
  return {
      {.id = "V24",
       .title = "Arch and hanging chain",
       .group = "Structures",
       .formula = "least thickness 0.1075 R of a half circle; tan θᵢ = Vᵢ/H",
       .source = "Milankovitch 1907; the line of thrust as linear inequalities; statics of a chain of rods",
       .parameters = {{"stones", 16, 6, 60, whole_number},
                      {"rods", 20, 2, 100, whole_number},
                      {"span", 3, 1, 3.9, "m"}},
       .sets = {{"twelve stones", {{"stones", 12}, {"span", 2}}}},
       .run = arch,
       .without = {"thickness", "impulses", "gravity"}},
      {.id = "V46",
       .title = "House of cards",
       .group = "Structures",
       .formula = "μ ≥ ½ tan of half the angle; under a second storey μ ≥ 1.25/1.75 tan",
       .source = "torques about the feet",
       .parameters = {{"half angle", 15, 5, 40, "°"}},
       .sets = {{"10°", {{"half angle", 10}}}, {"20°", {{"half angle", 20}}}},
       .run = cards,
       .without = {"friction", "gravity"}},
  };
}

}
