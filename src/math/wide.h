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
  if constexpr (sizeof(Real) == sizeof(float) && lanes_of<V> >= 4) {
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

// Whether some lane of a comparison is true.
template <class Mask>
[[gnu::always_inline]] inline bool any(const Mask& mask) {
  constexpr int words = int(sizeof(Mask) / sizeof(long long));
  if constexpr (words == 0) {
    return mask[0] != 0;
  } else {
    long long word[words], some = 0;
    __builtin_memcpy(word, &mask, sizeof mask);
    for (int i = 0; i < words; ++i) some |= word[i];
    return some != 0;
  }
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

template <class Place>
[[gnu::always_inline]] inline Wide<4> four_at(Place place, int lane) {
  Wide<4> four;
  __builtin_memcpy(&four, place(lane), sizeof four);
  return four;
}
// Those of `lane` and of every fourth lane after it, so that all fours are transposed at once.
template <int W, class Place>
[[gnu::always_inline]] inline Wide<W> every_fourth(Place place, int lane) {
  const Wide<4> f = four_at(place, lane);
  if constexpr (W == 4) return f;
  else if constexpr (W == 8) return join(f, four_at(place, lane + 4));
  else return join(join(f, four_at(place, lane + 4)), join(four_at(place, lane + 8), four_at(place, lane + 12)));
}

// `place(lane)`: where they lie.
template <int W, class Place>
[[gnu::always_inline]] inline Fours<W> load(Place place) {
  if constexpr (W == 1) {
    const Wide<4> f = four_at(place, 0);
    return {Wide<1>{f[0]}, Wide<1>{f[1]}, Wide<1>{f[2]}, Wide<1>{f[3]}};
  } else {
    const Wide<W> r0 = every_fourth<W>(place, 0), r1 = every_fourth<W>(place, 1);
    const Wide<W> r2 = every_fourth<W>(place, 2), r3 = every_fourth<W>(place, 3);
    const Wide<W> xy01 = pick<0, 1, 0, 1>(r0, r1), xy23 = pick<0, 1, 0, 1>(r2, r3);
    const Wide<W> zw01 = pick<2, 3, 2, 3>(r0, r1), zw23 = pick<2, 3, 2, 3>(r2, r3);
    return {pick<0, 2, 0, 2>(xy01, xy23), pick<1, 3, 1, 3>(xy01, xy23), pick<0, 2, 0, 2>(zw01, zw23),
            pick<1, 3, 1, 3>(zw01, zw23)};
  }
}

// The way back: `put(lane, four)` for each lane.
template <int W, class Put>
[[gnu::always_inline]] inline void store(const Fours<W>& f, Put put) {
  if constexpr (W == 1) {
    put(0, Wide<4>{f.x[0], f.y[0], f.z[0], f.w[0]});
  } else {
    const Wide<W> xy02 = pick<0, 2, 0, 2>(f.x, f.y), xy13 = pick<1, 3, 1, 3>(f.x, f.y);
    const Wide<W> zw02 = pick<0, 2, 0, 2>(f.z, f.w), zw13 = pick<1, 3, 1, 3>(f.z, f.w);
    const Wide<W> rows[] = {pick<0, 2, 0, 2>(xy02, zw02), pick<0, 2, 0, 2>(xy13, zw13), pick<1, 3, 1, 3>(xy02, zw02),
                            pick<1, 3, 1, 3>(xy13, zw13)};
    for (int r = 0; r < 4; ++r) {
      Wide<4> fours[W / 4];
      __builtin_memcpy(fours, &rows[r], sizeof rows[r]);
      for (int q = 0; q < W / 4; ++q) put(4 * q + r, fours[q]);
    }
  }
}

}

}
