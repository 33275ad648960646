// Numbers as unevaluated sums hi + lo: the exact errors of floating-point sums and products, for where one rounding too
// many shows. All of it needs round to nearest and no contraction. Written over T: a number or a vector of lanes.
#pragma once

#include <sudar/math.h>

namespace sudar::inline SUDAR_PRECISION {

// The number type inside T; lane types specialise this.
template <class T>
struct ElementOf {
  using type = T;
};
template <class T>
using Element = typename ElementOf<T>::type;

template <class T>
constexpr T select(bool condition, T yes, T no) {
  return condition ? yes : no;
}

template <class T>
struct Pair {
  T hi, lo;
};

// a + b exactly (Knuth, The Art of Computer Programming 2, 4.2.2, theorem B).
template <class T>
constexpr Pair<T> two_sum(T a, T b) {
  const T s = a + b, t = s - a;
  return {s, (a - (s - t)) + (b - t)};
}

// a + b exactly if |a| ≥ |b| or a is 0 (Dekker 1971).
template <class T>
constexpr Pair<T> quick_two_sum(T a, T b) {
  const T s = a + b;
  return {s, b - (s - a)};
}

// a as two numbers of half the digits (Veltkamp 1968).
template <class T>
constexpr Pair<T> split(T a) {
  constexpr Element<T> factor =
      sizeof(Element<T>) == 4 ? Element<T>(4097) : Element<T>(134217729);  // 2^12 + 1, 2^27 + 1
  const T t = a * T(factor), hi = t - (t - a);
  return {hi, a - hi};
}

// a · b exactly, unless something over- or underflows (Dekker 1971).
template <class T>
constexpr Pair<T> two_product(T a, T b) {
  const T p = a * b;
  const Pair<T> x = split(a), y = split(b);
  return {p, ((x.hi * y.hi - p) + x.hi * y.lo + x.lo * y.hi) + x.lo * y.lo};
}

}
