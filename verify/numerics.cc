#include "verify/numerics.h"

#include <algorithm>
#include <cmath>

namespace sudar::verify {

double elliptic_k(double m) {
  double a = 1, b = std::sqrt(1 - m);
  while (std::fabs(a - b) > 1e-15 * a) {
    const double mean = (a + b) / 2;
    b = std::sqrt(a * b);
    a = mean;
  }
  return std::acos(-1.0) / (2 * a);
}

double elliptic_f(double phi, double m) {
  double a = 1, b = std::sqrt(1 - m), times = 1;
  while (std::fabs(a - b) > 1e-15 * a) {
    // tan(φ' − φ) = b/a tan φ, with φ' − φ in the same quadrant as φ.
    const double more = std::atan2(b * std::sin(phi), a * std::cos(phi)), turn = 2 * std::acos(-1.0);
    phi += more + turn * std::round((phi - more) / turn);
    const double mean = (a + b) / 2;
    b = std::sqrt(a * b);
    a = mean;
    times *= 2;
  }
  return phi / (times * a);
}

Jacobi jacobi(double u, double m) {
  // The arithmetic-geometric mean of 1 and √(1−m) with its differences c, then φ back from level n: A&S 16.4.2–16.4.4.
  std::vector<double> a{1}, c{std::sqrt(m)};
  double b = std::sqrt(1 - m);
  while (std::fabs(c.back()) > 1e-16 && a.size() < 30) {
    const double mean = (a.back() + b) / 2;
    c.push_back((a.back() - b) / 2);
    b = std::sqrt(a.back() * b);
    a.push_back(mean);
  }
  double phi = std::ldexp(a.back() * u, int(a.size()) - 1);
  for (std::size_t n = a.size() - 1; n > 0; --n) phi = (phi + std::asin(c[n] / a[n] * std::sin(phi))) / 2;
  const double sn = std::sin(phi);
  return {sn, std::cos(phi), std::sqrt(1 - m * sn * sn)};
}

namespace {

constexpr std::array<double, 5> gauss_node = {0.1488743389816312, 0.4333953941292472, 0.6794095682990244,
                                              0.8650633666889845, 0.9739065285171717};
constexpr std::array<double, 5> gauss_weight = {0.2955242247147529, 0.2692667193099963, 0.2190863625159820,
                                                0.1494513491505806, 0.0666713443086881};

double piece(const std::function<double(double)>& f, double a, double b) {
  const double middle = (a + b) / 2, half = (b - a) / 2;
  double sum = 0;
  for (std::size_t i = 0; i < gauss_node.size(); ++i) {
    sum += gauss_weight[i] * (f(middle - half * gauss_node[i]) + f(middle + half * gauss_node[i]));
  }
  return sum * half;
}

double refine(const std::function<double(double)>& f, double a, double b, double whole, double tolerance, int depth,
              int& pieces) {
  const double middle = (a + b) / 2, left = piece(f, a, middle), right = piece(f, middle, b);
  if (depth == 0 || std::fabs(left + right - whole) <= tolerance) return left + right;
  if (++pieces > 20000) throw Error("integral", "does not converge: rounding or a singularity");
  return refine(f, a, middle, left, tolerance / 2, depth - 1, pieces) +
         refine(f, middle, b, right, tolerance / 2, depth - 1, pieces);
}

}

double integral(const std::function<double(double)>& f, double a, double b) {
  const double whole = piece(f, a, b);
  const double size = piece([&](double x) { return std::fabs(f(x)); }, a, b);
  int pieces = 0;
  return refine(f, a, b, whole, 1e-13 * size, 40, pieces);
}

double time_from_rest(const std::function<double(double)>& rate, double way) {
  return integral([&](double s) { return 2 * s / rate(s * s); }, 0, std::sqrt(way));
}

double root(const std::function<double(double)>& f, double a, double b) {
  double fa = f(a), fb = f(b);
  if (!(fa * fb <= 0)) throw Error("root", "the function has the same sign at both ends");
  int side = 0;
  for (int i = 0; i < 200 && std::fabs(b - a) > 1e-15 * (std::fabs(a) + std::fabs(b)); ++i) {
    const double x = fb != fa ? (fa * b - fb * a) / (fa - fb) : (a + b) / 2, fx = f(x);
    if (fx == 0) return x;
    if (fx * fb > 0) {
      b = x, fb = fx;
      if (side == -1) fa /= 2;
      side = -1;
    } else {
      a = x, fa = fx;
      if (side == 1) fb /= 2;
      side = 1;
    }
  }
  return (a + b) / 2;
}

namespace {

// Dormand & Prince 1980, RK5(4)7M: nodes, weights of the stages, and the difference of the two results.
constexpr double node[7] = {0, 1.0 / 5, 3.0 / 10, 4.0 / 5, 8.0 / 9, 1, 1};
constexpr double stage[7][6] = {{},
                                {1.0 / 5},
                                {3.0 / 40, 9.0 / 40},
                                {44.0 / 45, -56.0 / 15, 32.0 / 9},
                                {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
                                {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
                                {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}};
constexpr double difference[7] = {71.0 / 57600,      0,          -71.0 / 16695, 71.0 / 1920,
                                  -17253.0 / 339200, 22.0 / 525, -1.0 / 40};

struct Step {
  Vector y;
  double error;  // in tolerances
};
Step try_step(const Rate& f, double t, const Vector& y, double h) {
  std::array<Vector, 7> k;
  Vector x = y;
  for (std::size_t s = 0; s < 7; ++s) {
    x = y;
    for (std::size_t r = 0; r < s; ++r) {
      for (std::size_t i = 0; i < y.size(); ++i) x[i] += h * stage[s][r] * k[r][i];
    }
    k[s] = f(t + node[s] * h, x);
  }
  double error = 0;
  for (std::size_t i = 0; i < y.size(); ++i) {
    double e = 0;
    for (std::size_t s = 0; s < 7; ++s) e += h * difference[s] * k[s][i];
    error = std::max(error, std::fabs(e) / (1e-11 * (1 + std::fabs(y[i]))));
  }
  return {x, error};
}

// Advances until t1, or until `stop` says so of the step just made; gives the beginning of that step.
Moment advance(const Rate& f, double t, Vector y, double t1, const std::function<bool(double, const Vector&)>& stop) {
  double h = (t1 - t) / 100;
  int tries = 0;
  while (t < t1) {
    if (++tries > 100000) throw Error("solve_ode", "the solution ends: something comes to rest");
    h = std::min(h, t1 - t);
    const Step step = try_step(f, t, y, h);
    if (!std::isfinite(step.error)) throw Error("solve_ode", "the solution is not finite");
    if (step.error <= 1) {
      if (stop(t + h, step.y)) return {t, y};
      y = step.y;
      t = t1 - t > h ? t + h : t1;
    }
    h *= std::clamp(0.9 * std::pow(std::max(step.error, 1e-10), -0.2), 0.2, 5.0);
  }
  return {t1, y};
}

}

Vector solve_ode(const Rate& f, double t0, Vector y, double t1) {
  return advance(f, t0, std::move(y), t1, [](double, const Vector&) { return false; }).y;
}

Moment solve_until(const Rate& f, double t0, Vector y, double latest,
                   const std::function<double(double, const Vector&)>& g) {
  bool was_below = g(t0, y) < 0;
  double t_end = latest;
  const Moment before = advance(f, t0, std::move(y), latest, [&](double t, const Vector& x) {
    const bool above = g(t, x) >= 0;
    if (was_below && above) t_end = t;
    was_below = !above;
    return t_end < latest;
  });
  if (t_end >= latest) throw Error("solve_until", "what was waited for did not happen");
  const double t = root([&](double s) { return g(s, solve_ode(f, before.t, before.y, s)); }, before.t, t_end);
  return {t, solve_ode(f, before.t, before.y, t)};
}

bool feasible(std::vector<Vector> a, Vector b) {
  // Phase one of the simplex method: slack for every row, an artificial variable where b < 0; their sum must reach 0.
  const std::size_t rows = a.size(), columns = a.front().size(), width = columns + 2 * rows + 1;
  std::vector<Vector> table(rows, Vector(width, 0));
  Vector cost(width, 0);
  std::vector<std::size_t> basis(rows);
  for (std::size_t r = 0; r < rows; ++r) {
    const double sign = b[r] < 0 ? -1 : 1;
    for (std::size_t c = 0; c < columns; ++c) table[r][c] = sign * a[r][c];
    table[r][columns + r] = sign;
    table[r].back() = sign * b[r];
    basis[r] = columns + r;
    if (sign > 0) continue;
    basis[r] = columns + rows + r;
    table[r][basis[r]] = 1;
    for (std::size_t c = 0; c < width; ++c) cost[c] -= c == basis[r] ? 0 : table[r][c];
  }
  while (true) {
    std::size_t enter = 0;
    while (enter < columns + rows && cost[enter] > -1e-11) ++enter;
    if (enter == columns + rows) return cost.back() > -1e-9;
    std::size_t leave = rows;
    double least = 0;
    for (std::size_t r = 0; r < rows; ++r) {
      if (table[r][enter] < 1e-11) continue;
      const double ratio = table[r].back() / table[r][enter];
      if (leave == rows || ratio < least - 1e-14 || (ratio <= least + 1e-14 && basis[r] < basis[leave])) {
        leave = r, least = ratio;
      }
    }
    if (leave == rows) return false;
    const double pivot = table[leave][enter];
    for (double& x : table[leave]) x /= pivot;
    const auto clear = [&](Vector& row) {
      const double factor = row[enter];
      for (std::size_t c = 0; c < width; ++c) row[c] -= factor * table[leave][c];
    };
    for (std::size_t r = 0; r < rows; ++r) {
      if (r != leave) clear(table[r]);
    }
    clear(cost);
    basis[leave] = enter;
  }
}

double slope(const std::vector<std::pair<double, double>>& points) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const auto& [px, py] : points) n += 1, x += px, y += py, xx += px * px, xy += px * py;
  return (n * xy - x * y) / (n * xx - x * x);
}

void Crossings::sample(double t, double value) {
  if (value == 0) return;  // the next one tells whether it changed
  if (started_ && (value_ < 0) != (value < 0)) moments_.push_back(t_ + (t - t_) * value_ / (value_ - value));
  started_ = true;
  t_ = t, value_ = value;
}

}
