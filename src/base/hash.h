// A 64-bit hash of bytes: for telling contents apart and comparing runs, not for secrets. Eight bytes at a time in four
// independent streams, so that a processor's multiplications overlap; little-endian machines agree on every value.
#pragma once

#include <sudar/base.h>

#include <cstring>
#include <span>
#include <type_traits>

namespace sudar::inline SUDAR_PRECISION {

namespace hash_detail {

// Odd, with bits in no pattern: the fraction of the golden ratio, 2^64/φ.
inline constexpr std::uint64_t golden = 0x9e3779b97f4a7c15u;

// One word into a stream: a bijection of each for the other fixed. The product carries bits up, the shift brings them
// down.
constexpr std::uint64_t mix(std::uint64_t state, std::uint64_t word) {
  state = (state ^ word) * golden;
  return state ^ (state >> 32);
}

inline std::uint64_t load_word(const unsigned char* from, std::size_t size) {
  std::uint64_t word = 0;
  std::memcpy(&word, from, size);
  return word;
}

}

inline std::uint64_t hash_bytes(const void* data, std::size_t size, std::uint64_t seed = 0) {
  using namespace hash_detail;
  const auto* at = static_cast<const unsigned char*>(data);
  std::uint64_t state = mix(seed + golden, size);
  if (size >= 32) {
    std::uint64_t stream[4] = {state, state + golden, state + 2 * golden, state + 3 * golden};
    for (; size >= 32; size -= 32, at += 32) {
      for (int i = 0; i < 4; ++i) stream[i] = mix(stream[i], load_word(at + 8 * i, 8));
    }
    for (const std::uint64_t s : stream) state = mix(state, s);
  }
  for (; size >= 8; size -= 8, at += 8) state = mix(state, load_word(at, 8));
  if (size > 0) state = mix(state, load_word(at, size));
  return mix(mix(state, 0), 0);  // every bit of the last word reaches every bit of the result
}

// The hash of a sequence of values, each a trivially copyable type without padding.
class Hasher {
 public:
  template <class T>
  Hasher& add(const T& value) {
    static_assert(std::is_trivially_copyable_v<T> && !std::is_pointer_v<T>);
    hash_ = hash_bytes(&value, sizeof value, hash_);
    return *this;
  }
  template <class T>
  Hasher& add_all(std::span<const T> values) {
    static_assert(std::is_trivially_copyable_v<T> && !std::is_pointer_v<T>);
    hash_ = hash_bytes(values.data(), values.size_bytes(), hash_);
    return *this;
  }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0;
};

}
