// Four numbers that the processor treats as one, by the compilers' vector extensions: the same bits on every machine,
// nothing to link. Here they hold a Vec3 and a lane of no meaning, so that three-dimensional algebra runs in registers.
#pragma once

#include <sudar/math.h>

namespace sudar::inline SUDAR_PRECISION {

using Real4 = Real __attribute__((vector_size(4 * sizeof(Real))));

inline Real4 lanes(const Vec3& v) { return Real4{v.x, v.y, v.z, 0}; }
inline Vec3 vector(const Real4& v) { return {v[0], v[1], v[2]}; }
template <int lane>
inline Real4 broadcast(const Real4& v) { return __builtin_shufflevector(v, v, lane, lane, lane, lane); }
inline Real4 broadcast(Real x) { return Real4{x, x, x, x}; }
inline Real4 cross(const Real4& a, const Real4& b) {
  const Real4 a_yzx = __builtin_shufflevector(a, a, 1, 2, 0, 3), b_yzx = __builtin_shufflevector(b, b, 1, 2, 0, 3);
  const Real4 c_zxy = a * b_yzx - a_yzx * b;
  return __builtin_shufflevector(c_zxy, c_zxy, 1, 2, 0, 3);
}

// A Mat3 by columns.
struct Mat3Lanes {
  Real4 c0, c1, c2;
  friend Real4 operator*(const Mat3Lanes& m, const Real4& v) {
    return m.c0 * broadcast<0>(v) + m.c1 * broadcast<1>(v) + m.c2 * broadcast<2>(v);
  }
};
inline Mat3Lanes lanes(const Mat3& m) { return {lanes(m.c0), lanes(m.c1), lanes(m.c2)}; }
inline Mat3 matrix(const Mat3Lanes& m) { return {vector(m.c0), vector(m.c1), vector(m.c2)}; }

}
