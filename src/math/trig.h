// Sine, cosine, arc tangent and their kin without libm: the same bits from every compiler and machine.
// Written once over T, a number or a vector of lanes: no branches and no tables, only compare and select, so a lane
// gets the bits that the number alone would get. Three ideas keep the error below one unit in the last place (ulp):
//   - range reduction after Cody and Waite (1980): x − k π/2 with π/2 in parts so short that k times each is exact;
//   - what does not fit into one number is carried along in a second (pair.h) up to the last addition;
//   - minimax polynomials for the rest of the series behind its exact leading terms (tools/minimax.py made them).
// NaN stays NaN; an infinite argument gives NaN. Zeros come out without their sign.
#pragma once

#include "math/pair.h"

#include <type_traits>

namespace sudar::inline SUDAR_PRECISION {

// The constants of one precision. `half_pi` sums to π/2; k · (every part but the last) is exact for |k| < 2^16.
template <class S>
struct TrigConstants;

template <>
struct TrigConstants<float> {
  static constexpr float rounder = 0x1.8p23f;  // adding and taking it away rounds to an integer
  static constexpr float half_pi[] = {0x1.92p0f, 0x1.fcp-12f, -0x1.58p-21f, 0x1.1p-30f, 0x1.68p-39f, 0x1.84698ap-48f};
  static constexpr float quarter_pi[] = {0x1.92p-1f, 0x1.fb5444p-13f};  // the first times 4 and fewer is exact
  static constexpr float sine[] = {-0.166666549f, 0.00833217815f, -0.00019517299f};
  static constexpr float cosine[] = {0.0416666469f, -0.00138873675f, 2.44384525e-05f};
  static constexpr float arc_tangent[] = {-0.333333155f, 0.199984894f, -0.142438485f, 0.105959996f, -0.0608344804f};
  // Beyond `large` and below `small` a product or its error would over- or underflow: scale first.
  static constexpr float large = 0x1p110f, shrink = 0x1p-20f, small = 0x1p-70f, grow = 0x1p80f;
};

template <>
struct TrigConstants<double> {
  static constexpr double rounder = 0x1.8p52;
  static constexpr double half_pi[] = {0x1.921fb544p0, 0x1.0b4611a6p-34, 0x1.3198a2ep-69, 0x1.b839a252049c1p-104};
  static constexpr double quarter_pi[] = {0x1.921fb544p-1, 0x1.0b4611a626331p-35};
  static constexpr double sine[] = {-0.16666666666666632,   0.008333333333322425,    -0.00019841269829816926,
                                    2.7557313695225494e-06, -2.5050758653916423e-08, 1.5896828001031283e-10};
  static constexpr double cosine[] = {0.0416666666666666,     -0.001388888888887414,  2.4801587289492e-05,
                                      -2.755731435528728e-07, 2.0875723690228553e-09, -1.1359670155397816e-11};
  static constexpr double arc_tangent[] = {-0.333333333333332,   0.19999999999954085,  -0.14285714280248707,
                                           0.11111110786148139,  -0.09090897836745394, 0.07692061642292407,
                                           -0.06663120441200972, 0.05848009321365432,  -0.050398472854850426,
                                           0.038078364837349,    -0.01792232616952146};
  static constexpr double large = 0x1p990, shrink = 0x1p-60, small = 0x1p-900, grow = 0x1p200;
};

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
