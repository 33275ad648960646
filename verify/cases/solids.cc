// Mass properties: hulls of random points against exact sums, solids against closed forms and quadrature.
#include <sudar/solids.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "verify/cases/cases.h"
#include "verify/numerics.h"
#include "verify/scene.h"

namespace sudar::verify {

namespace {

struct Whole {  // a vector of integers
  std::int64_t x, y, z;
  Whole operator-(const Whole& o) const { return {x - o.x, y - o.y, z - o.z}; }
  bool operator==(const Whole&) const = default;
};
Whole cross(const Whole& a, const Whole& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
std::int64_t dot(const Whole& a, const Whole& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vec3d real(const Whole& a) { return {double(a.x), double(a.y), double(a.z)}; }

// V37. The hull of points with whole coordinates, without rounding: each plane through three points that has all others
// on one side is a face. Slow and plain on purpose.
class ExactHull {
 public:
  explicit ExactHull(const std::vector<Whole>& points) : points_(points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (std::size_t j = i + 1; j < points.size(); ++j) {
        for (std::size_t k = j + 1; k < points.size(); ++k) consider(i, j, k);
      }
    }
  }
  double volume() const { return volume_; }
  Vec3d center() const { return first_ * (1 / volume_); }
  Mat3d inertia() const {  // about the centre: tr(C) E − C
    const Mat3d c = second_ - Mat3d::outer(center(), center()) * volume_;
    const double trace = c.c0.x + c.c1.y + c.c2.z;
    return Mat3d::diagonal({trace, trace, trace}) - c;
  }

 private:
  void consider(std::size_t i, std::size_t j, std::size_t k) {
    Whole normal = cross(points_[j] - points_[i], points_[k] - points_[i]);
    if (normal == Whole{0, 0, 0}) return;
    bool above = false, below = false;
    std::vector<std::size_t> on;
    for (std::size_t p = 0; p < points_.size(); ++p) {
      const std::int64_t height = dot(normal, points_[p] - points_[i]);
      above |= height > 0, below |= height < 0;
      if (height == 0) on.push_back(p);
    }
    if (above && below) return;
    if (above) normal = {-normal.x, -normal.y, -normal.z};
    if (faces_.insert(on).second) add_face(on, normal);
  }
  // Its outline: an edge from p leads to the farthest q that has all others on its left.
  void add_face(const std::vector<std::size_t>& on, const Whole& normal) {
    for (const std::size_t p : on) {
      for (const std::size_t q : on) {
        const Whole edge = points_[q] - points_[p];
        const auto allows = [&](std::size_t r) {
          const Whole to = points_[r] - points_[p];
          const std::int64_t side = dot(normal, cross(edge, to));
          return side > 0 || (side == 0 && dot(edge, to) >= 0 && dot(to, to) <= dot(edge, edge));
        };
        if (points_[p] != points_[q] && std::all_of(on.begin(), on.end(), allows))
          add_tetrahedron(points_[on[0]], points_[p], points_[q]);
      }
    }
  }
  void add_tetrahedron(const Whole& wa, const Whole& wb, const Whole& wc) {  // with the origin
    const Vec3d a = real(wa), b = real(wb), c = real(wc), sum = a + b + c;
    const double six = double(dot(wa, cross(wb, wc)));
    volume_ += six / 6;
    first_ += sum * (six / 24);
    second_ =
        second_ + (Mat3d::outer(a, a) + Mat3d::outer(b, b) + Mat3d::outer(c, c) + Mat3d::outer(sum, sum)) * (six / 120);
  }
  const std::vector<Whole>& points_;
  std::set<std::vector<std::size_t>> faces_;
  double volume_ = 0;
  Vec3d first_;
  Mat3d second_ = Mat3d::diagonal({0, 0, 0});
};

double largest(const Mat3d& m) {
  double most = 0;
  for (int i = 0; i < 3; ++i) most = std::max({most, std::fabs(m[i].x), std::fabs(m[i].y), std::fabs(m[i].z)});
  return most;
}

void random_hull(Run& run) {
  Random random{std::uint32_t(run["seed"])};
  std::vector<Whole> points;
  std::vector<Vec3> given;
  for (int i = 0; i < int(run["points"]); ++i) {
    std::int64_t x[3];
    for (std::int64_t& v : x) v = std::int64_t(random.bits() % 101) - 50;
    points.push_back({x[0], x[1], x[2]});
    given.push_back({Real(x[0]), Real(x[1]) * (run.without("all coordinates") ? Real(0.9) : Real(1)), Real(x[2])});
  }
  const ExactHull exact(points);
  const MassProperties got = hull(given).mass_properties();
  show(run, {{.shape = hull(given)}});
  const double share = by_precision(1e-6, 1e-13);
  run.relative("volume", "m³", exact.volume(), got.volume, share);
  run.below("centre of mass, distance", "m", length(got.center - exact.center()), share * 50);
  run.below("inertia tensor, largest relative error", "1",
            largest(got.inertia - exact.inertia()) / largest(exact.inertia()), share);
  Plot& plot = run.plot("Volume of the hull of the first points", "points", "m³");
  for (std::size_t n = 5; n <= points.size(); n += 1 + points.size() / 20) {
    const std::vector<Whole> some(points.begin(), points.begin() + std::ptrdiff_t(n));
    plot.theory.emplace_back(n, ExactHull(some).volume());
    plot.simulation.emplace_back(n, hull({given.data(), n}).mass_properties().volume);
  }
}

// V38. What a solid's mass properties must be: volume, height of the centre, and moments about the axis y and across
// it.
struct Moments {
  double volume, center, axis, across;
};

// A solid of revolution about y with the radii outer(y) and inner(y), which may begin and end like a circle.
using Radius = std::function<double(double)>;
Moments revolve(
    double from, double to, const Radius& outer, const Radius& inner = [](double) { return 0; }) {
  // y = middle + half sin s: smooth where the profile is a circle's end.
  const double middle = (from + to) / 2, half = (to - from) / 2;
  const auto sum = [&](const std::function<double(double y, double r2, double r4)>& f) {
    return integral(
        [&](double s) {
          const double y = middle + half * std::sin(s), o = square(outer(y)), i = square(inner(y));
          return half * std::cos(s) * f(y, o - i, o * o - i * i);
        },
        -pi / 2, pi / 2);
  };
  const double volume = pi * sum([](double, double r2, double) { return r2; });
  const double center = pi * sum([](double y, double r2, double) { return y * r2; }) / volume;
  const double fourth = pi / 4 * sum([](double, double, double r4) { return r4; });
  return {volume, center, 2 * fourth,
          fourth + pi * sum([&](double y, double r2, double) { return square(y - center) * r2; })};
}

// What is worst of the four numbers, relative to its own size (a centre at 0: to the solid's).
double error(const Moments& exact, const MassProperties& got, double size) {
  const double across =
      std::max(std::fabs(got.inertia.c0.x / exact.across - 1), std::fabs(got.inertia.c2.z / exact.across - 1));
  return std::max({std::fabs(got.volume / exact.volume - 1), std::fabs(got.center.y - exact.center) / size,
                   std::fabs(got.inertia.c1.y / exact.axis - 1), across});
}

void solids_of_revolution(Run& run, double s, double cheat) {
  const auto ball = [](double r) { return [r](double y) { return std::sqrt(std::max(0.0, r * r - y * y)); }; };
  const auto constant = [](double r) { return [r](double) { return r; }; };
  const auto line = [](double r0, double r1, double h) { return [=](double y) { return r0 + (r1 - r0) * y / h; }; };
  const auto compare = [&](const char* name, const Moments& exact, const MassProperties& got) {
    run.below(std::string(name) + ": largest relative error", "1", error(exact, got, s), 1e-6);
  };
  const double r = run["radius"] * s, in = 0.6 * r, h = 2 * s, c = cheat;
  compare("sphere", revolve(-r, r, ball(r)), sphere(Real(c * r)).mass_properties());
  compare("thick shell", revolve(-r, r, ball(r), ball(in)), mass_of(solid::ThickShell{c * r, in}));
  compare("cylinder", revolve(-h / 2, h / 2, constant(r)), cylinder(Real(c * r), Real(h)).mass_properties());
  compare("tube", revolve(-h / 2, h / 2, constant(r), constant(in)), mass_of(solid::Tube{c * r, in, h}));
  compare("cone", revolve(-h / 4, 3 * h / 4, line(3 * r / 4, -r / 4, h)), cone(Real(c * r), Real(h)).mass_properties());
  compare("frustum", revolve(0, h, line(r, 0.4 * r, h)), mass_of(solid::Frustum{c * r, 0.4 * r, h}));
  const double l = 1.2 * s;
  compare("capsule",
          revolve(-l / 2 - r, l / 2 + r, [&](double y) { return ball(r)(std::max(0.0, std::fabs(y) - l / 2)); }),
          capsule(Real(c * r), Real(l)).mass_properties());
  compare("hemisphere", revolve(0, r, ball(r)), mass_of(solid::Hemisphere{c * r}));
  compare("spheroid", revolve(-0.8 * s, 0.8 * s, [&](double y) { return ball(1)(y / (0.8 * s)) * r; }),
          ellipsoid({Real(c * r), Real(0.8 * s), Real(c * r)}).mass_properties());
  const double tube = s / 4;
  compare("torus",
          revolve(
              -tube, tube, [&](double y) { return s + ball(tube)(y); }, [&](double y) { return s - ball(tube)(y); }),
          mass_of(solid::Torus{c * s, tube}));
  compare("paraboloid", revolve(0, h, [&](double y) { return r * std::sqrt(y / h); }),
          mass_of(solid::Paraboloid{c * r, h}));
  compare("cap", revolve(0.2 * r, r, ball(r)), mass_of(solid::Cap{c * r, c * 0.8 * r}));
  // Two spheres and the cone that touches both.
  const double bottom = 0.778 * r, top = 0.5 * r, apart = 1.0996 * r, sine = (bottom - top) / apart,
               cosine = std::sqrt(1 - sine * sine);
  compare("tapered capsule",
          revolve(-apart / 2 - bottom, apart / 2 + top,
                  [&](double y) {
                    const double from = -apart / 2 + bottom * sine, to = apart / 2 + top * sine;
                    if (y < from) return ball(bottom)(y + apart / 2);
                    if (y > to) return ball(top)(y - apart / 2);
                    return (bottom + (top - bottom) * (y - from) / (to - from)) * cosine;
                  }),
          mass_of(solid::TaperedCapsule{c * bottom, top, apart}));
}

void polyhedra(Run& run, double s, double cheat) {
  const double golden = (1 + std::sqrt(5.0)) / 2;
  const auto compare = [&](const char* name, double volume, double axis, double across, const Shape& got) {
    run.below(std::string(name) + ": largest relative error", "1",
              error({volume, 0, volume * axis, volume * across}, got.mass_properties(), s), 1e-6);
  };
  const auto even = [&](const char* name, double volume, double moment, const Shape& got) {
    compare(name, volume, moment, moment, got);
  };
  const double a = s, c = cheat * s;
  even("cube", a * a * a, a * a / 6, box({Real(c), Real(c), Real(c)}));
  even("tetrahedron", a * a * a / (6 * std::sqrt(2.0)), a * a / 20, tetrahedron(Real(c)));
  even("octahedron", a * a * a * std::sqrt(2.0) / 3, a * a / 10, octahedron(Real(c)));
  even("icosahedron", 5 * (3 + std::sqrt(5.0)) / 12 * a * a * a, square(golden * a) / 10, icosahedron(Real(c)));
  even("dodecahedron", (15 + 7 * std::sqrt(5.0)) / 4 * a * a * a, (95 + 39 * std::sqrt(5.0)) / 300 * a * a,
       dodecahedron(Real(c)));
  for (const int n : {3, 6}) {  // in a circle of radius a, 2 a high
    const double angle = 2 * pi / n, volume = n * std::sin(angle) * a * a * a,
                 polar = a * a * (2 + std::cos(angle)) / 6;
    compare(n == 3 ? "triangular prism" : "hexagonal prism", volume, polar, polar / 2 + a * a / 3,
            prism(n, Real(c), Real(2 * a)));
  }
  compare("square pyramid", 8 * a * a * a / 3, square(2 * a) / 10, square(2 * a) * (1.0 / 20 + 3.0 / 80),
          pyramid(4, Real(c * std::sqrt(2.0)), Real(2 * a)));
  const MassProperties bar = box({Real(c), Real(2 * a), Real(3 * a)}).mass_properties();
  const double mass = 6 * a * a * a;
  run.relative("box: moment about x", "m⁵", mass * 13 * a * a / 12, bar.inertia.c0.x, 1e-6);
  run.relative("box: moment about y", "m⁵", mass * 10 * a * a / 12, bar.inertia.c1.y, 1e-6);
  run.relative("box: moment about z", "m⁵", mass * 5 * a * a / 12, bar.inertia.c2.z, 1e-6);
  const MassProperties ramp = wedge({Real(c), Real(a), Real(2 * a)}).mass_properties();
  run.relative("wedge: moment about its edges", "m⁵", std::pow(a, 5) / 9, ramp.inertia.c2.z, 1e-6);
  run.relative("wedge: moment across", "m⁵", std::pow(a, 5) * (1.0 / 18 + 1.0 / 3), ramp.inertia.c0.x, 1e-6);
  run.relative("wedge: product of inertia", "m⁵", std::pow(a, 5) / 36, ramp.inertia.c0.y, 1e-6);
}

void mass_of_solids(Run& run) {
  const double size = run["size"], cheat = run.without("the right size") ? 1.01 : 1;
  solids_of_revolution(run, size, cheat);
  polyhedra(run, size, cheat);
  Plot& plot = run.plot("Frustum: moment about its axis", "upper / lower radius", "m⁵");
  for (int i = 1; i <= 20; ++i) {
    const auto radius = [&](double y) { return size * (1 + (i / 20.0 - 1) * y / size); };
    plot.theory.emplace_back(i / 20.0, revolve(0, size, radius).axis);
    plot.simulation.emplace_back(i / 20.0, mass_of(solid::Frustum{size, size * i / 20, size}).inertia.c1.y);
  }
  const Real s = Real(size);
  show(run, {{.shape = cylinder(s / 2, 2 * s), .at = {-3 * size, 0, 0}},
             {.shape = cone(s / 2, 2 * s), .at = {-1.5 * size, 0, 0}},
             {.shape = ellipsoid({s / 2, s * Real(0.8), s / 2})},
             {.shape = dodecahedron(s / 2), .at = {1.5 * size, 0, 0}},
             {.shape = prism(6, s / 2, s), .at = {3 * size, 0, 0}}});
}

}

std::vector<Case> solids() {
  return {
      {.id = "V37",
       .title = "Hulls of random points: mass",
       .group = "Geometry",
       .formula = "signed tetrahedra: V = Σ det/6, ∫x = Σ det (a+b+c)/24, ∫xxᵀ = Σ det (aaᵀ + bbᵀ + ccᵀ + ssᵀ)/120",
       .source = "faces by exact integers; x ← 1664525 x + 1013904223 mod 2³²",
       .parameters = {{"seed", 1, 0, 1e9, whole_number}, {"points", 12, 4, 200, whole_number}},
       .sets = {{"24 points", {{"seed", 2}, {"points", 24}}}, {"60 points", {{"seed", 3}, {"points", 60}}}},
       .run = random_hull,
       .without = {"all coordinates"},
       .uses_solver = false},
      {.id = "V38",
       .title = "Mass of 23 solids",
       .group = "Geometry",
       .formula = "V = π ∫r² dy, I = ½ π ∫r⁴ dy about the axis; closed forms of the polyhedra",
       .source = "quadrature of the profiles, Gauss–Legendre",
       .parameters = {{"size", 1, 0.01, 100, "m"}, {"radius", 0.5, 0.1, 0.7, "sizes"}},
       .sets = {{"large", {{"size", 3}, {"radius", 0.3}}}},
       .run = mass_of_solids,
       .without = {"the right size"},
       .uses_solver = false},
  };
}

}
