// Floating-point first; where the result is smaller than its error bound, again with expansions: sums of numbers that
// do not overlap, so that the largest has the sum's sign (Shewchuk 1997, "Adaptive precision floating-point
// arithmetic").
#include "geometry/predicates.h"

#include "math/pair.h"

#include <array>

namespace sudar::inline SUDAR_PRECISION {

namespace {

// Terms in increasing order of size, without zeros.
template <int capacity>
class Expansion {
 public:
  void add(double x) {
    int kept = 0;
    for (int i = 0; i < count_; ++i) {
      const Pair<double> sum = two_sum(x, terms_[std::size_t(i)]);
      if (sum.lo != 0) terms_[std::size_t(kept++)] = sum.lo;
      x = sum.hi;
    }
    if (x != 0) terms_[std::size_t(kept++)] = x;
    count_ = kept;
  }
  template <int n, int m>
  void add_product(const Expansion<n>& a, const Expansion<m>& b, double sign) {
    for (int i = 0; i < a.count(); ++i) {
      for (int j = 0; j < b.count(); ++j) {
        const Pair<double> p = two_product(sign * a.term(i), b.term(j));
        add(p.lo);
        add(p.hi);
      }
    }
  }
  int count() const { return count_; }
  double term(int i) const { return terms_[std::size_t(i)]; }
  int sign() const { return count_ == 0 ? 0 : term(count_ - 1) > 0 ? 1 : -1; }

 private:
  std::array<double, capacity> terms_;
  int count_ = 0;
};

Expansion<2> difference(double a, double b) {
  const Pair<double> d = two_sum(a, -b);
  Expansion<2> e;
  e.add(d.lo);
  e.add(d.hi);
  return e;
}

int exact_orientation(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) {
  Expansion<192> determinant;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    Expansion<16> minor;
    minor.add_product(difference(b[j], a[j]), difference(c[k], a[k]), 1);
    minor.add_product(difference(b[k], a[k]), difference(c[j], a[j]), -1);
    determinant.add_product(minor, difference(d[i], a[i]), 1);
  }
  return determinant.sign();
}

}

int orientation(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) {
  const Vec3d u = b - a, v = c - a, w = d - a;
  const Vec3d p{u.y * v.z, u.z * v.x, u.x * v.y}, q{u.z * v.y, u.x * v.z, u.y * v.x};
  const double determinant = dot(p - q, w);
  // Three roundings of differences, one each of product, difference and product and two of sums are 8 units 2⁻⁵³ at
  // most.
  const double bound = 1e-15 * dot(abs(p) + abs(q), abs(w));
  if (determinant > bound) return 1;
  if (determinant < -bound) return -1;
  return exact_orientation(a, b, c, d);
}

}
