// Sine, cosine, arc tangent and their kin without libm: the same bits from every compiler and machine.
// Written once over T, a number or a vector of lanes: no branches and no tables, only compare and select, so a lane
// gets the bits that the number alone would get. Three ideas keep the error below one unit in the last place (ulp):
//   - range reduction after Cody and Waite (1980): x − k π/2 with π/2 in parts so short that k times each is exact;
//   - what does not fit into one number is carried along in a second (pair.h) up to the last addition;
//   - minimax polynomials for the rest of the series behind its exact leading terms (tools/minimax.py made them).
// NaN stays NaN; an infinite argument gives NaN. Zeros come out without their sign.
#pragma once

#include "math/pair.h"
#include "math/trig_constants.h"

namespace sudar::inline SUDAR_PRECISION {

template <class T>
using TrigOf = TrigConstants<Element<T>>;

// c[0] + c[1] z + c[2] z² + …
template <class T, class S, std::size_t n>
constexpr T polynomial(const S (&c)[n], T z) {
  T sum = T(c[n - 1]);
  for (std::size_t i = n - 1; i-- > 0;) sum = sum * z + T(c[i]);
  return sum;
}

// The nearest integer, for |x| below a quarter of the largest number with integer steps.
template <class T>
T nearest(T x) {
  return (x + T(TrigOf<T>::rounder)) - T(TrigOf<T>::rounder);
}

template <class T>
struct SinCos {
  T sin, cos;
};

template <class T>
SinCos<T> sin_cos(T x) {
  using C = TrigOf<T>;
  using S = Element<T>;
  constexpr std::size_t parts = std::size(C::half_pi);
  const T k = nearest(x * T(S(2 / pi)));

  // r = x − k π/2 in −π/4…π/4, as a pair. The first difference is exact (Sterbenz).
  Pair<T> r{x - k * T(C::half_pi[0]), T(S(0))};
  for (std::size_t i = 1; i + 1 < parts; ++i) {
    const Pair<T> next = two_sum(r.hi, -(k * T(C::half_pi[i])));
    r = {next.hi, r.lo + next.lo};
  }
  r = quick_two_sum(r.hi, r.lo - k * T(C::half_pi[parts - 1]));
  // So large an argument that k no longer is exact has no meaningful sine, but it shall have one in −1…1.
  const T one = T(S(1)), zero = T(S(0));
  r = {select(r.hi > one, one, select(r.hi < -one, -one, r.hi)), select(abs(r.hi) > one, zero, r.lo)};

  const T z = r.hi * r.hi, half_z = z * T(S(0.5));
  const T s = r.hi + (r.lo * (one - half_z) + r.hi * z * polynomial(C::sine, z));
  const T w = one - half_z;
  const T c = w + (((one - w) - half_z) + (z * z * polynomial(C::cosine, z) - r.hi * r.lo));

  const T turn = k - T(S(4)) * nearest(k * T(S(0.25)));  // quarter turns −2…2
  return {select(turn == one, c, select(turn == -one, -c, select(turn == zero, s, -s))),
          select(turn == one, -s, select(turn == -one, s, select(turn == zero, c, -c)))};
}

// The angle of the point (x, y), −π…π; both as pairs, finite.
template <class T>
T atan2(Pair<T> y, Pair<T> x) {
  using C = TrigOf<T>;
  using S = Element<T>;
  const T zero = T(S(0)), one = T(S(1));
  const T y_sign = select(y.hi < zero, -one, one), x_sign = select(x.hi < zero, -one, one);
  y = {y.hi * y_sign, y.lo * y_sign};
  x = {x.hi * x_sign, x.lo * x_sign};

  const auto steep = y.hi > x.hi;
  Pair<T> n{select(steep, x.hi, y.hi), select(steep, x.lo, y.lo)};
  Pair<T> d{select(steep, y.hi, x.hi), select(steep, y.lo, x.lo)};
  const T scale = select(d.hi > T(C::large), T(C::shrink), select(d.hi < T(C::small), T(C::grow), one));
  n = {n.hi * scale, n.lo * scale};
  d = {d.hi * scale, d.lo * scale};

  // atan(n/d) = π/4 + atan((n − d)/(n + d)) brings n/d from 0…1 to −tan(π/8)…tan(π/8).
  const auto wide = n.hi > d.hi * T(S(0.41421356237309505));
  const Pair<T> difference = two_sum(n.hi, -d.hi), sum = two_sum(n.hi, d.hi);
  const T n_lo = n.lo, d_lo = d.lo;
  n = {select(wide, difference.hi, n.hi), select(wide, difference.lo + (n_lo - d_lo), n_lo)};
  d = {select(wide, sum.hi, d.hi), select(wide, sum.lo + (n_lo + d_lo), d_lo)};
  d.hi = select(d.hi == zero, one, d.hi);  // atan2(0, 0) = 0

  // The angle is `eighths` π/4 + sign · atan(q + q_lo).
  T eighths = select(wide, one, zero), sign = one;
  eighths = select(steep, T(S(2)) - eighths, eighths);
  sign = select(steep, -sign, sign) * x_sign;
  eighths = select(x_sign < zero, T(S(4)) - eighths, eighths);

  const T q = n.hi / d.hi;
  const Pair<T> product = two_product(q, d.hi);
  const T q_lo = (((n.hi - product.hi) - product.lo) + (n.lo - q * d.lo)) / d.hi;
  const T z = q * q;
  const T tail = q_lo * (one - z) + q * z * polynomial(C::arc_tangent, z);
  const Pair<T> head = two_sum(eighths * T(C::quarter_pi[0]), sign * q);
  return y_sign * (head.hi + (head.lo + (eighths * T(C::quarter_pi[1]) + sign * tail)));
}

// √(1 − x²) as a pair: the other side of the triangle that asin and acos need.
template <class T>
Pair<T> other_side(T x) {
  using S = Element<T>;
  const T zero = T(S(0)), one = T(S(1));
  const Pair<T> a = two_sum(one, -x), b = two_sum(one, x), p = two_product(a.hi, b.hi);
  const T root = sqrt(p.hi);
  const Pair<T> back = two_product(root, root);
  const T rest = ((p.hi - back.hi) - back.lo) + (p.lo + (a.hi * b.lo + a.lo * b.hi));
  return {root, select(root == zero, zero, rest / (T(S(2)) * select(root == zero, one, root)))};
}

template <class T>
T asin_of(T x) {
  return atan2(Pair<T>{x, T(Element<T>(0))}, other_side(x));
}

template <class T>
T acos_of(T x) {
  return atan2(other_side(x), Pair<T>{x, T(Element<T>(0))});
}

}
