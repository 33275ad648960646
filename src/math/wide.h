// W numbers that the processor treats as one: one lane for each of W equal problems solved side by side (math/lanes.h is
// the other use of vectors: the three axes of one problem). Only +, −, ×, ÷, comparison, choice and square root act
// between lanes of equal number, each rounded as IEEE 754 says, so a lane has the same bits whatever W is.
#pragma once

#include <sudar/math.h>

#include <utility>

#ifdef __SSE2__
#include <immintrin.h>
#endif

namespace sudar::inline SUDAR_PRECISION {

template <int W>
struct WideType {  // g++ drops the attribute of an alias template
  using type [[gnu::vector_size(W * sizeof(Real))]] = Real;
};
template <int W>
using Wide = typename WideType<W>::type;

namespace wide {

template <class V>
inline constexpr int lanes_of = int(sizeof(V) / sizeof(Real));

template <class V>
[[gnu::always_inline]] inline V all(Real x) { return V{} + x; }
template <class V>
[[gnu::always_inline]] inline V larger(const V& a, const V& b) { return a > b ? a : b; }
template <class V>
[[gnu::always_inline]] inline V smaller(const V& a, const V& b) { return a < b ? a : b; }

template <class V>
[[gnu::always_inline]] inline V root(const V& x) {
  V r;
#ifdef __SSE2__
  if constexpr (sizeof(Real) == sizeof(float)) {
    __m128 parts[sizeof(V) / sizeof(__m128)];
    __builtin_memcpy(parts, &x, sizeof x);
    for (__m128& p : parts) p = _mm_sqrt_ps(p);
    __builtin_memcpy(&r, parts, sizeof r);
    return r;
  }
#endif
  for (int i = 0; i < lanes_of<V>; ++i) r[i] = sqrt(x[i]);
  return r;
}

// Lanes of a, then those of b.
template <class V>
[[gnu::always_inline]] inline Wide<2 * lanes_of<V>> join(const V& a, const V& b) {
  return [&]<int... i>(std::integer_sequence<int, i...>) {
    return __builtin_shufflevector(a, b, i...);
  }(std::make_integer_sequence<int, 2 * lanes_of<V>>());
}

// In each four lanes of the result: lanes p, q of the same four of a, then r, s of b.
template <int p, int q, int r, int s, class V>
[[gnu::always_inline]] inline V pick(const V& a, const V& b) {
  constexpr int width = lanes_of<V>, from[] = {p, q, r + width, s + width};
  return [&]<int... i>(std::integer_sequence<int, i...>) {
    return __builtin_shufflevector(a, b, (i / 4 * 4 + from[i % 4])...);
  }(std::make_integer_sequence<int, width>());
}

// The four numbers at each of W places, number by number: what lies in memory, transposed.
template <int W>
struct Fours {
  Wide<W> x, y, z, w;
};
template <int W, class Place>
[[gnu::always_inline]] inline Fours<W> load(Place place) {
  static_assert(W == 4 || W == 8 || W == 16);
  const auto four = [&](int lane) { return *static_cast<const Wide<4>*>(place(lane)); };
  // Places 4 apart beside each other, so that all fours are transposed at once.
  const auto row = [&](int lane) {
    if constexpr (W == 4) return four(lane);
    else if constexpr (W == 8) return join(four(lane), four(lane + 4));
    else return join(join(four(lane), four(lane + 4)), join(four(lane + 8), four(lane + 12)));
  };
  const Wide<W> r0 = row(0), r1 = row(1), r2 = row(2), r3 = row(3);
  const Wide<W> low01 = pick<0, 1, 0, 1>(r0, r1), low23 = pick<0, 1, 0, 1>(r2, r3);
  const Wide<W> high01 = pick<2, 3, 2, 3>(r0, r1), high23 = pick<2, 3, 2, 3>(r2, r3);
  return {pick<0, 2, 0, 2>(low01, low23), pick<1, 3, 1, 3>(low01, low23), pick<0, 2, 0, 2>(high01, high23),
          pick<1, 3, 1, 3>(high01, high23)};
}

// The way back: `put(lane, four)` for each lane.
template <int W, class Put>
[[gnu::always_inline]] inline void store(const Fours<W>& f, Put put) {
  const Wide<W> xy02 = pick<0, 1, 0, 1>(f.x, f.y), xy13 = pick<2, 3, 2, 3>(f.x, f.y);
  const Wide<W> zw02 = pick<0, 1, 0, 1>(f.z, f.w), zw13 = pick<2, 3, 2, 3>(f.z, f.w);
  const Wide<W> rows[] = {pick<0, 2, 0, 2>(xy02, zw02), pick<1, 3, 1, 3>(xy02, zw02), pick<0, 2, 0, 2>(xy13, zw13),
                          pick<1, 3, 1, 3>(xy13, zw13)};
  for (int r = 0; r < 4; ++r) {
    Wide<4> fours[W / 4];
    __builtin_memcpy(fours, &rows[r], sizeof rows[r]);
    for (int q = 0; q < W / 4; ++q) put(4 * q + r, fours[q]);
  }
}

}

}
