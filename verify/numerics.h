// What references are computed with, in double: elliptic integrals and functions, quadrature, ordinary differential
// equations with an event, roots, feasibility of linear inequalities. Small on purpose; tests/verify checks each.
#pragma once

#include <sudar/base.h>

#include <array>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace sudar::verify {

// Complete elliptic integral of the first kind K(m), m = k² < 1, by the arithmetic-geometric mean.
double elliptic_k(double m);

// The incomplete one, F(φ | m), 0 ≤ φ ≤ π/2 (Abramowitz & Stegun 17.6).
double elliptic_f(double phi, double m);

// Jacobi's sn, cn, dn of u with parameter m, 0 ≤ m < 1 (descending Landen transformation, Abramowitz & Stegun 16.4).
struct Jacobi {
  double sn, cn, dn;
};
Jacobi jacobi(double u, double m);

// ∫ f over [a, b] to about 1e-12 of the integral of |f|: adaptive Gauss–Legendre, 10 points a piece. Throws Error when
// it does not converge: f must be computed without cancellation.
double integral(const std::function<double(double)>& f, double a, double b);

// The time for a way from rest, where the rate is known as a function of the way and begins like its square root: the
// substitution way = s² takes the singularity away.
double time_from_rest(const std::function<double(double)>& rate, double way);

// Where f changes its sign between a and b, which f(a) and f(b) must have different: bisection and secant (Illinois).
double root(const std::function<double(double)>& f, double a, double b);

// y' = f(t, y) by Dormand & Prince's method of order 5 with step control, error per step below 1e-11 of the state.
using Vector = std::vector<double>;
using Rate = std::function<Vector(double t, const Vector& y)>;
// The state at the end. Throws Error where the solution ends: at a singular point.
Vector solve_ode(const Rate& f, double t0, Vector y, double t1);
// Goes on from t0 until g(t, y) changes from negative to positive; gives that moment and state. Throws Error when it
// has not by `latest`.
struct Moment {
  double t;
  Vector y;
};
Moment solve_until(const Rate& f, double t0, Vector y, double latest,
                   const std::function<double(double, const Vector&)>& g);

// Whether some x ≥ 0 has A x ≤ b: phase one of the simplex method with Bland's rule, for small problems.
bool feasible(std::vector<Vector> a, Vector b);

// Reproducible numbers: x ← 1664525 x + 1013904223 mod 2³² (Numerical Recipes), of which the upper half is used.
class Random {
 public:
  explicit Random(std::uint32_t seed) : state_(seed) {}
  std::uint32_t bits() { return (state_ = 1664525 * state_ + 1013904223) >> 16; }
  double between(double low, double high) { return low + (high - low) * bits() / 65536.0; }

 private:
  std::uint32_t state_;
};

// Slope of the line through the points that has the least squared error.
double slope(const std::vector<std::pair<double, double>>& points);

// Watches a sampled function for the moments at which it changes its sign, by linear interpolation.
class Crossings {
 public:
  void sample(double t, double value);
  const std::vector<double>& moments() const { return moments_; }
  double first() const { return moments_.empty() ? std::nan("") : moments_.front(); }

 private:
  bool started_ = false;
  double t_ = 0, value_ = 0;
  std::vector<double> moments_;
};

}
