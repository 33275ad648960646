// Small dense symmetric systems A = l d lᵀ, factored in place: l below the diagonal (ones on it), 1/d on it.
#pragma once

#include <sudar/math.h>

#include <array>

namespace sudar::inline SUDAR_PRECISION {

// A by rows of `stride` numbers, lower half used. The diagonal is raised by the relative `compliance`, and no pivot
// falls below that share of its entry: so rows that repeat each other stay solvable.
inline void factor_small(Real* a, int stride, int n, Real compliance) {
  std::array<Real, 6> d;
  for (int i = 0; i < n; ++i) {
    Real* row = a + i * stride;
    const Real least = row[i] * compliance;
    for (int j = 0; j <= i; ++j) {
      Real s = j == i ? row[i] + least : row[j];
      for (int m = 0; m < j; ++m) s -= row[m] * a[j * stride + m] * d[std::size_t(m)];
      if (j < i) {
        row[j] = s * a[j * stride + j];
      } else {
        d[std::size_t(i)] = max(s, least);
        row[i] = d[std::size_t(i)] > 0 ? 1 / d[std::size_t(i)] : Real(0);
      }
    }
  }
}
// x ← l⁻¹ x
inline void solve_lower(const Real* a, int stride, int n, Real* x) {
  for (int i = 1; i < n; ++i) {
    for (int j = 0; j < i; ++j) x[i] -= a[i * stride + j] * x[j];
  }
}
// x ← d⁻¹ x
inline void solve_diagonal(const Real* a, int stride, int n, Real* x) {
  for (int i = 0; i < n; ++i) x[i] *= a[i * stride + i];
}
// x ← l⁻ᵀ x
inline void solve_upper(const Real* a, int stride, int n, Real* x) {
  for (int i = n - 2; i >= 0; --i) {
    for (int j = i + 1; j < n; ++j) x[i] -= a[j * stride + i] * x[j];
  }
}

}
