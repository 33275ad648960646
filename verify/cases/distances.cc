// Distances between shapes, and how deep they overlap.
#include <sudar/distance.h>

#include <algorithm>
#include <cmath>

#include "verify/cases/cases.h"
#include "verify/numerics.h"
#include "verify/scene.h"

namespace sudar::verify {

namespace {

// A box anywhere, in double.
struct Placed {
  Vec3d half;
  Vec3d at;
  Quatd turn;
  Vec3d axis(int i) const { return rotate(turn, Vec3d{i == 0 ? 1.0 : 0.0, i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0}); }
  Vec3d corner(int i) const {
    return at + rotate(turn, Vec3d{i & 1 ? half.x : -half.x, i & 2 ? half.y : -half.y, i & 4 ? half.z : -half.z});
  }
  double to(const Vec3d& p) const {  // the distance of a point
    const Vec3d local = rotate_back(turn, p - at);
    return length(Vec3d{std::max(0.0, std::fabs(local.x) - half.x), std::max(0.0, std::fabs(local.y) - half.y),
                        std::max(0.0, std::fabs(local.z) - half.z)});
  }
  double reach(const Vec3d& n) const {
    return half.x * std::fabs(dot(axis(0), n)) + half.y * std::fabs(dot(axis(1), n)) +
           half.z * std::fabs(dot(axis(2), n));
  }
  Shape shape() const { return box(convert<Real>(half * 2)); }
  Pose pose() const { return {Pos{} + at, convert<Real>(turn)}; }
};

double segments(const Vec3d& a, const Vec3d& da, const Vec3d& b, const Vec3d& db) {
  // min |a + s da − b − t db| on the unit square: inside it, else on one of its edges.
  const auto at = [&](double s, double t) { return length(a + da * s - b - db * t); };
  const double aa = dot(da, da), bb = dot(db, db), ab = dot(da, db), det = aa * bb - ab * ab;
  const Vec3d d = b - a;
  const auto best_t = [&](double s) { return std::clamp(dot(a + da * s - b, db) / bb, 0.0, 1.0); };
  const auto best_s = [&](double t) { return std::clamp(dot(b + db * t - a, da) / aa, 0.0, 1.0); };
  double best = std::min({at(0, best_t(0)), at(1, best_t(1)), at(best_s(0), 0), at(best_s(1), 1)});
  if (det > 1e-12 * aa * bb) {
    const double s = (dot(d, da) * bb - dot(d, db) * ab) / det, t = (dot(d, da) * ab - dot(d, db) * aa) / det;
    if (s >= 0 && s <= 1 && t >= 0 && t <= 1) best = std::min(best, at(s, t));
  }
  return best;
}

// Apart: the nearest points are a corner and any point, or lie on two edges. Overlapping: minus the least of the
// fifteen overlaps along face normals and products of edges.
double enumerated(const Placed& a, const Placed& b) {
  double apart = 1e300, deep = 1e300;
  for (int i = 0; i < 8; ++i) apart = std::min({apart, a.to(b.corner(i)), b.to(a.corner(i))});
  for (int i = 0; i < 8; ++i) {
    for (int j = 0; j < 8; ++j) {
      for (int e = 1; e < 8; e *= 2) {
        for (int f = 1; f < 8; f *= 2) {
          if ((i & e) != 0 || (j & f) != 0) continue;
          apart = std::min(
              apart, segments(a.corner(i), a.corner(i | e) - a.corner(i), b.corner(j), b.corner(j | f) - b.corner(j)));
        }
      }
    }
  }
  const auto test = [&](const Vec3d& n) {
    const double size = length(n);
    if (size > 1e-9) deep = std::min(deep, (a.reach(n) + b.reach(n) - std::fabs(dot(n, b.at - a.at))) / size);
  };
  for (int i = 0; i < 3; ++i) {
    test(a.axis(i)), test(b.axis(i));
    for (int j = 0; j < 3; ++j) test(cross(a.axis(i), b.axis(j)));
  }
  return deep > 0 ? -deep : apart;
}

// V39. Distances of boxes.
void box_distances(Run& run) {
  const double y = run["distance"], cheat = run.without("the right place") ? 0.01 : 0;
  const Shape cube = box({1, 1, 1});
  const Quat on_edge = axis_angle(Vec3{0, 0, 1}, Real(pi / 4)), across = axis_angle(Vec3{1, 0, 0}, Real(pi / 4));
  const Quat on_vertex = axis_angle(normalize(Vec3{1, 0, -1}), Real(std::acos(1 / std::sqrt(3.0))));
  const Pose up{{0, y + cheat, 0}, on_edge};
  run.check("edge over a face", "m", y - 0.5 - std::sqrt(0.5), distance(cube, {}, cube, up).value, 1e-5);
  run.check("crossed edges", "m", y - std::sqrt(2.0),
            distance(cube, {{}, on_edge}, cube, {{0, y + cheat, 0}, across}).value, 1e-5);
  run.check("corner over a face", "m", y - 0.5 - std::sqrt(0.75),
            distance(cube, {}, cube, {{0, y + cheat, 0}, on_vertex}).value, 1e-5);
  Random random{std::uint32_t(run["seed"])};
  const auto some_box = [&](double spread) {
    const Vec3d half{random.between(0.1, 1), random.between(0.1, 1), random.between(0.1, 1)};
    const Vec3d at{random.between(-spread, spread), random.between(-spread, spread), random.between(-spread, spread)};
    const Vec3d axis{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    const Quat turn = axis_angle(normalize(convert<Real>(axis) + Vec3{0, 0, Real(1e-3)}), Real(random.between(0, 3)));
    return Placed{convert<double>(convert<Real>(half)), at, convert<double>(turn)};
  };
  show(run, {{.shape = cube}, {.shape = cube, .at = up.p, .turn = up.q}});
  Plot& plot = run.plot("Distance of random pairs", "enumerated [m]", "the engine's [m]");
  plot.theory = {{-1, -1}, {3, 3}};
  double apart = 0, shallow = 0, deep = 0;
  int pairs = 0, overlapping = 0;
  for (const double spread : {2.0, 0.5}) {
    for (int i = 0; i < int(run["pairs"]); ++i, ++pairs) {
      const Placed a = some_box(0), b = some_box(spread);
      const Pose moved{b.pose().p + Vec3d{0, cheat, 0}, b.pose().q};
      const double exact = enumerated(a, b), got = distance(a.shape(), a.pose(), b.shape(), moved).value;
      plot.simulation.emplace_back(exact, got);
      if (exact >= 0) {
        apart = std::max(apart, std::fabs(got - exact));
        continue;
      }
      ++overlapping;
      shallow = std::max(shallow, got - exact), deep = std::max(deep, exact - got);
    }
  }
  run.holds("some pairs are apart, some overlap", overlapping > pairs / 10 && overlapping < pairs * 9 / 10);
  run.below("random pairs apart: largest error", "m", apart, 1e-5);
  run.below("random pairs overlapping: deeper than they are by", "m", deep, 1e-5);
  run.below("random pairs overlapping: less deep by", "m", shallow, 1e-5);
}

// V40. Round shapes.
void round_distances(Run& run) {
  const double cheat = run.without("the right place") ? 0.01 : 0;
  const double pass = run["passing"], thin = 0.125;
  const Pose crossed{{pass + cheat, 0.3, 0.2}, axis_angle(Vec3{1, 0, 0}, Real(1))};
  run.check("segments that pass each other, as axes of capsules", "m", pass,
            distance(capsule(Real(thin), 2), {}, capsule(Real(thin), 2), crossed).value + 2 * thin, 1e-5);
  // The foot of p on an ellipsoid is r² p/(r² + t), where Σ (r p/(r² + t))² = 1.
  const Vec3d r{1, 2, 3}, p{run["x"], run["y"], run["z"]};
  const auto foot = [&](double t) {
    return Vec3d{p.x / (1 + t / (r.x * r.x)), p.y / (1 + t / (r.y * r.y)), p.z / (1 + t / (r.z * r.z))};
  };
  const double t = root(
      [&](double s) {
        const Vec3d f = foot(s);
        return square(f.x / r.x) + square(f.y / r.y) + square(f.z / r.z) - 1;
      },
      0, 1e4);
  run.check("a point outside an ellipsoid", "m", length(p - foot(t)),
            distance(ellipsoid(convert<Real>(r)), {}, Pos{p.x + cheat, p.y, p.z}).value, 1e-5);
  // A cylinder on its rim, its axis inclined by the angle to the floor.
  const double radius = 0.5, h = 1;
  const auto inclined = [](double angle) { return axis_angle(Vec3{0, 0, 1}, Real(pi / 2 - angle)); };
  const auto rest = [&](double angle) { return radius * std::cos(angle) + h / 2 * std::sin(angle); };
  const auto got = [&](double angle) {
    return 2 - distance(cylinder(Real(radius), Real(h)), {{0, 2 + cheat, 0}, inclined(angle)}, half_space(), {}).value;
  };
  const double angle = run["inclination"] * pi / 180;
  run.check("height of a cylinder on its rim", "m", rest(angle), got(angle), 1e-5);
  Plot& plot = run.plot("Height of a cylinder on its rim", "inclination [°]", "m");
  for (int degrees = 0; degrees <= 90; degrees += 5) {
    plot.theory.emplace_back(degrees, rest(degrees * pi / 180));
    plot.simulation.emplace_back(degrees, got(degrees * pi / 180));
  }
  show(run, {{.shape = half_space(), .motion = Motion::fixed},
             {.shape = cylinder(Real(radius), Real(h)), .at = {0, rest(angle), 0}, .turn = inclined(angle)},
             {.shape = ellipsoid(convert<Real>(r)), .at = {4, 3, 0}}});
}

}

std::vector<Case> distances() {
  return {
      {.id = "V39",
       .title = "Distance of boxes",
       .group = "Geometry",
       .formula = "d − ½ − √½, d − √2, d − ½ − √¾; random pairs: corners and edges enumerated, fifteen axes",
       .source = "enumeration",
       .parameters = {{"distance", 2, 1.5, 10, "m"},
                      {"seed", 1, 0, 1e9, whole_number},
                      {"pairs", 200, 1, 1e5, whole_number}},
       .sets = {{"others", {{"distance", 3}, {"seed", 7}}}},
       .run = box_distances,
       .without = {"the right place"},
       .uses_solver = false},
      {.id = "V40",
       .title = "Distance of round shapes",
       .group = "Geometry",
       .formula = "Σ (r p/(r² + t))² = 1; r cos α + ½ h sin α",
       .source = "root of Lagrange's multiplier",
       .parameters = {{"passing", 1, 0.3, 10, "m"},
                      {"x", 4, 1, 100, "m"},
                      {"y", 4, 1, 100, "m"},
                      {"z", 4, 1, 100, "m"},
                      {"inclination", 30, 1, 89, "°"}},
       .sets = {{"others", {{"passing", 0.4}, {"x", 1.5}, {"z", 9}, {"inclination", 70}}}},
       .run = round_distances,
       .without = {"the right place"},
       .uses_solver = false},
  };
}

}
