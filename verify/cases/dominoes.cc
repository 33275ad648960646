// A row of dominoes that topple.
#include <algorithm>
#include <cmath>

#include "verify/cases/cases.h"
#include "verify/numerics.h"
#include "verify/scene.h"

namespace sudar::verify {

namespace {

// V21. Dominoes that turn about their toes, meet without friction or bounce, and then lean on each other: behind the
// front all move as one, with one freedom. Its energy has a fixed point from impact to impact.
class DominoTrain {
 public:
  DominoTrain(double height, double thickness, double gap) : h_(height), d_(thickness), s_(gap) {}
  double rate_at_impact() const {
    // An impact shares the front's rate: ω₀ = ω S/(1 + S); the fall gives back what that took.
    const double s = inertia(hits());
    return std::sqrt(2 * (height_of(0) - height_of(hits())) * standard_gravity / own() * (1 + s) / s);
  }
  double speed() const {
    const double s = inertia(hits()), start = rate_at_impact() * s / (1 + s);
    const auto rate = [&](double phi) {
      const double energy = inertia(0) * square(start) + 2 * standard_gravity * (height_of(0) - height_of(phi)) / own();
      return std::sqrt(energy / inertia(phi));
    };
    return (s_ + d_) / integral([&](double phi) { return 1 / rate(phi); }, 0, hits());
  }

 private:
  static constexpr int train = 100;  // dominoes behind the front; the last ones no longer move
  double hits() const { return std::asin(s_ / h_); }
  double own() const { return (h_ * h_ + d_ * d_) / 3; }  // moment of inertia about the toe / mass
  // The angle of the one behind, whose edge slides on the face of one at the angle phi; and how its rate follows.
  double behind(double phi) const { return phi + std::asin(((s_ + d_) * std::cos(phi) - d_) / h_); }
  double follows(double phi) const { return 1 - (s_ + d_) * std::sin(phi) / (h_ * std::cos(behind(phi) - phi)); }
  double inertia(double phi) const {  // of the train, in inertias of one
    double sum = 1, rate = 1;
    for (int k = 0; k < train; ++k) rate *= follows(phi), phi = behind(phi), sum += rate * rate;
    return sum;
  }
  double height_of(double phi) const {  // sum of the centres' heights
    double sum = 0;
    for (int k = 0; k <= train; ++k, phi = behind(phi)) sum += (h_ * std::cos(phi) + d_ * std::sin(phi)) / 2;
    return sum;
  }
  double h_, d_, s_;
};

void dominoes(Run& run) {
  const int n = int(run["dominoes"]);
  const double h = run["height"], d = run["thickness"] * h, s = run["gap"] * h;
  const DominoTrain train(h, d, s);
  World w(with_small_slop(run.fine_config()));
  add_gravity(run, w);
  std::vector<Body> row;
  for (int i = 0; i < n; ++i) {
    const double x = i * (s + d);
    const Vec3 spin{0, 0, Real(i == 0 ? -train.rate_at_impact() : 0)}, arm{Real(-d / 2), Real(h / 2), 0};
    row.push_back(w.add({.shape = box({Real(d), Real(h), Real(h / 2)}),
                         .at = {x - d / 2, h / 2, 0},
                         .velocity = cross(spin, arm),
                         .spin = spin,
                         .mass = 1,
                         .material = material(0)}));
    w.join(Hinge{.b = row.back(), .at = {x, 0, 0}, .limit = {.low = -3, .high = 0}});
  }
  const double exact = train.speed(), threshold = train.rate_at_impact() / 20;
  std::vector<double> begins;
  Plot& plot = run.plot("Begin of the fall", "t [s]", "x [m]");
  run.until(w, 1.5 * n * (s + d) / exact, [&] {
    while (begins.size() < row.size() && -double(w[row[begins.size()]].spin().z) > threshold) {
      plot.simulation.emplace_back(w.time(), double(begins.size()) * (s + d));
      begins.push_back(w.time());
    }
  });
  const std::size_t from = row.size() / 2, to = row.size() - 2;
  const double got = begins.size() > to ? double(to - from) * (s + d) / (begins[to] - begins[from]) : 0;
  if (begins.size() > to) {
    for (const std::size_t k : {from, to})
      plot.theory.emplace_back(begins[from] + double(k - from) * (s + d) / exact, double(k) * (s + d));
  }
  run.relative("speed of the front", "m/s", exact, got, 0.03);
}

}

std::vector<Case> domino_rows() {
  return {{.id = "V21",
           .title = "Dominoes",
           .group = "Toppling",
           .formula =
               "fixed point of the energy of a train that leans on its front; h sin(θₙ − θₙ₊₁) = (s + d) cos θₙ₊₁ − d",
           .source = "van Leeuwen, arXiv:physics/0401018; quadrature",
           .parameters = {{"dominoes", 40, 10, 200, whole_number},
                          {"height", 1, 0.2, 10, "m"},
                          {"thickness", 0.1, 0.02, 0.3, "heights"},
                          {"gap", 0.3, 0.1, 0.8, "heights"}},
           .sets = {{"48 × 7.5 mm, gap 22.5 mm, enlarged", {{"thickness", 7.5 / 48}, {"gap", 22.5 / 48}}},
                    {"thick", {{"thickness", 0.179}}}},
           .run = dominoes,
           .without = {"gravity", "impulses"}}};
}

}
