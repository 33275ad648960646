// Vectors, quaternions, matrices and poses, written once over the number type T: Real for users, double where an
// answer must be exact, vector lanes inside the solvers. Right-handed, y up, SI units, radians.
// Nothing here calls libm except sqrt (correctly rounded everywhere), so results have the same bits on every machine.
#pragma once

#include <sudar/base.h>

#include <cmath>
#include <limits>

namespace sudar::inline SUDAR_PRECISION {

inline constexpr double pi = 3.14159265358979323846;

// Our own, so that every platform returns the same bits. Error below 1 unit in the last place of the argument type
// for |x| < 1e5 (sin, cos; tan: 2.5 units) and everywhere (atan2, acos, asin); tests/unit/math/trig_test.cc measures it.
float sin(float x);
float cos(float x);
float tan(float x);
float atan2(float y, float x);
float acos(float x);
float asin(float x);
double sin(double x);
double cos(double x);
double tan(double x);
double atan2(double y, double x);
double acos(double x);
double asin(double x);

// Compare and select: unlike std::fmin these map to one instruction and treat NaN alike in every lane.
template <class T>
constexpr T min(T a, T b) { return a < b ? a : b; }
template <class T>
constexpr T max(T a, T b) { return a > b ? a : b; }
template <class T>
constexpr T clamp(T x, T low, T high) { return min(max(x, low), high); }
template <class T>
constexpr T square(T x) { return x * x; }
template <class T>
constexpr T abs(T x) {  // clears the sign bit: a comparison becomes a branch, which nothing can predict
  if constexpr (std::is_same_v<T, float>) return __builtin_fabsf(x);
  else if constexpr (std::is_same_v<T, double>) return __builtin_fabs(x);
  else return x < T(0) ? -x : x;
}
template <class T>
T sqrt(T x) { return std::sqrt(x); }

template <class T>
struct Vec3T {
  T x{}, y{}, z{};
  constexpr T& operator[](int i) { return i == 0 ? x : i == 1 ? y : z; }
  constexpr const T& operator[](int i) const { return i == 0 ? x : i == 1 ? y : z; }
  constexpr Vec3T operator-() const { return {-x, -y, -z}; }
  constexpr Vec3T& operator+=(const Vec3T& b) { return *this = {x + b.x, y + b.y, z + b.z}; }
  constexpr Vec3T& operator-=(const Vec3T& b) { return *this = {x - b.x, y - b.y, z - b.z}; }
  constexpr Vec3T& operator*=(T s) { return *this = {x * s, y * s, z * s}; }
  constexpr bool operator==(const Vec3T&) const = default;

  friend constexpr Vec3T operator+(Vec3T a, const Vec3T& b) { return a += b; }
  friend constexpr Vec3T operator-(Vec3T a, const Vec3T& b) { return a -= b; }
  friend constexpr Vec3T operator*(Vec3T a, T s) { return a *= s; }
  friend constexpr Vec3T operator*(T s, Vec3T a) { return a *= s; }
  friend constexpr Vec3T operator/(const Vec3T& a, T s) { return {a.x / s, a.y / s, a.z / s}; }

  friend constexpr T dot(const Vec3T& a, const Vec3T& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
  friend constexpr Vec3T cross(const Vec3T& a, const Vec3T& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
  friend constexpr Vec3T scale(const Vec3T& a, const Vec3T& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
  friend constexpr T length_squared(const Vec3T& a) { return dot(a, a); }
  friend T length(const Vec3T& a) { return sqrt(dot(a, a)); }
  // The zero vector stays zero.
  friend Vec3T normalize(const Vec3T& a) {
    const T l = length(a);
    return l > T(0) ? a / l : a;
  }
  friend constexpr Vec3T abs(const Vec3T& a) { return {abs(a.x), abs(a.y), abs(a.z)}; }
  friend constexpr Vec3T min(const Vec3T& a, const Vec3T& b) { return {min(a.x, b.x), min(a.y, b.y), min(a.z, b.z)}; }
  friend constexpr Vec3T max(const Vec3T& a, const Vec3T& b) { return {max(a.x, b.x), max(a.y, b.y), max(a.z, b.z)}; }
  friend constexpr T max_component(const Vec3T& a) { return max(max(a.x, a.y), a.z); }
  friend bool is_finite(const Vec3T& a) { return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z); }
};

// Some unit vector at right angles to the unit vector n; continuous except at one axis. Stable: picks the axis that n
// leans on least.
template <class T>
Vec3T<T> any_perpendicular(const Vec3T<T>& n) {
  const Vec3T<T> a = abs(n);
  const Vec3T<T> axis = a.x <= a.y && a.x <= a.z ? Vec3T<T>{1, 0, 0} : a.y <= a.z ? Vec3T<T>{0, 1, 0} : Vec3T<T>{0, 0, 1};
  return normalize(cross(n, axis));
}

// A 3×3 matrix by columns.
template <class T>
struct Mat3T {
  Vec3T<T> c0, c1, c2;
  static constexpr Mat3T identity() { return diagonal({1, 1, 1}); }
  static constexpr Mat3T diagonal(const Vec3T<T>& d) { return {{d.x, 0, 0}, {0, d.y, 0}, {0, 0, d.z}}; }
  // skew(a) b = a × b
  static constexpr Mat3T skew(const Vec3T<T>& a) { return {{0, a.z, -a.y}, {-a.z, 0, a.x}, {a.y, -a.x, 0}}; }
  // outer(a, b) c = a (b·c)
  static constexpr Mat3T outer(const Vec3T<T>& a, const Vec3T<T>& b) { return {a * b.x, a * b.y, a * b.z}; }
  constexpr Vec3T<T>& operator[](int i) { return i == 0 ? c0 : i == 1 ? c1 : c2; }
  constexpr const Vec3T<T>& operator[](int i) const { return i == 0 ? c0 : i == 1 ? c1 : c2; }
  constexpr bool operator==(const Mat3T&) const = default;

  friend constexpr Mat3T operator+(const Mat3T& a, const Mat3T& b) { return {a.c0 + b.c0, a.c1 + b.c1, a.c2 + b.c2}; }
  friend constexpr Mat3T operator-(const Mat3T& a, const Mat3T& b) { return {a.c0 - b.c0, a.c1 - b.c1, a.c2 - b.c2}; }
  friend constexpr Mat3T operator*(const Mat3T& a, T s) { return {a.c0 * s, a.c1 * s, a.c2 * s}; }
  friend constexpr Mat3T operator*(T s, const Mat3T& a) { return a * s; }
  friend constexpr Vec3T<T> operator*(const Mat3T& a, const Vec3T<T>& v) { return a.c0 * v.x + a.c1 * v.y + a.c2 * v.z; }
  friend constexpr Mat3T operator*(const Mat3T& a, const Mat3T& b) { return {a * b.c0, a * b.c1, a * b.c2}; }
  friend constexpr Mat3T transpose(const Mat3T& a) {
    return {{a.c0.x, a.c1.x, a.c2.x}, {a.c0.y, a.c1.y, a.c2.y}, {a.c0.z, a.c1.z, a.c2.z}};
  }
  friend constexpr T trace(const Mat3T& a) { return a.c0.x + a.c1.y + a.c2.z; }
  friend constexpr T determinant(const Mat3T& a) { return dot(a.c0, cross(a.c1, a.c2)); }
  // By cofactors. The caller makes sure that the matrix is regular.
  friend constexpr Mat3T inverse(const Mat3T& a) {
    const Vec3T<T> r0 = cross(a.c1, a.c2), r1 = cross(a.c2, a.c0), r2 = cross(a.c0, a.c1);
    return transpose(Mat3T{r0, r1, r2}) * (T(1) / dot(a.c0, r0));
  }
};

// A rotation as a unit quaternion, thesis (3.1), stored and printed x, y, z, w (vector part first, w the cosine of half the angle).
template <class T>
struct QuatT {
  T x{}, y{}, z{}, w{1};
  constexpr Vec3T<T> vector() const { return {x, y, z}; }
  constexpr bool operator==(const QuatT&) const = default;

  friend constexpr QuatT conjugate(const QuatT& q) { return {-q.x, -q.y, -q.z, q.w}; }
  // First b, then a.
  friend constexpr QuatT operator*(const QuatT& a, const QuatT& b) {
    return {a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
            a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
  }
  friend constexpr T length_squared(const QuatT& q) { return q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w; }
  friend QuatT normalize(const QuatT& q) {
    const T s = T(1) / sqrt(length_squared(q));
    return {q.x * s, q.y * s, q.z * s, q.w * s};
  }
  friend constexpr Vec3T<T> rotate(const QuatT& q, const Vec3T<T>& v) {
    const Vec3T<T> t = T(2) * cross(q.vector(), v);
    return v + q.w * t + cross(q.vector(), t);
  }
  friend constexpr Vec3T<T> rotate_back(const QuatT& q, const Vec3T<T>& v) { return rotate(conjugate(q), v); }
  friend constexpr Mat3T<T> matrix(const QuatT& q) {
    const T xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z, xy = q.x * q.y, xz = q.x * q.z, yz = q.y * q.z;
    const T wx = q.w * q.x, wy = q.w * q.y, wz = q.w * q.z;
    return {{1 - 2 * (yy + zz), 2 * (xy + wz), 2 * (xz - wy)},
            {2 * (xy - wz), 1 - 2 * (xx + zz), 2 * (yz + wx)},
            {2 * (xz + wy), 2 * (yz - wx), 1 - 2 * (xx + yy)}};
  }
  friend bool is_finite(const QuatT& q) { return is_finite(q.vector()) && std::isfinite(q.w); }
};

// The rotation by `angle` about the unit vector `axis`.
template <class T>
QuatT<T> axis_angle(const Vec3T<T>& axis, T angle) {
  const T half = angle * T(0.5), s = sin(half);
  return {axis.x * s, axis.y * s, axis.z * s, cos(half)};
}

// The exponential map: the rotation by |r| about r.
template <class T>
QuatT<T> rotation(const Vec3T<T>& r) {
  const T angle = length(r);
  return angle > T(0) ? axis_angle(r / angle, angle) : QuatT<T>{};
}

// The inverse of rotation(): the shortest rotation vector of q, length 0…π.
template <class T>
Vec3T<T> rotation_vector(const QuatT<T>& q) {
  const T s = length(q.vector());
  if (s == T(0)) return {};
  const T angle = T(2) * (q.w < T(0) ? atan2(-s, -q.w) : atan2(s, q.w));
  return q.vector() * (angle / s);
}

// The rotation matrix's quaternion (Shepperd 1978: divide by the largest component).
template <class T>
QuatT<T> quaternion(const Mat3T<T>& m) {
  const T d0 = m.c0.x, d1 = m.c1.y, d2 = m.c2.z, t = d0 + d1 + d2;
  QuatT<T> q;
  if (t >= max(max(d0, d1), d2)) {
    q = {m.c1.z - m.c2.y, m.c2.x - m.c0.z, m.c0.y - m.c1.x, 1 + t};
  } else if (d0 >= d1 && d0 >= d2) {
    q = {1 + d0 - d1 - d2, m.c0.y + m.c1.x, m.c2.x + m.c0.z, m.c1.z - m.c2.y};
  } else if (d1 >= d2) {
    q = {m.c0.y + m.c1.x, 1 + d1 - d2 - d0, m.c1.z + m.c2.y, m.c2.x - m.c0.z};
  } else {
    q = {m.c2.x + m.c0.z, m.c1.z + m.c2.y, 1 + d2 - d0 - d1, m.c0.y - m.c1.x};
  }
  return normalize(q);
}

// The same vector or rotation in another precision.
template <class U, class T>
constexpr Vec3T<U> convert(const Vec3T<T>& v) { return {U(v.x), U(v.y), U(v.z)}; }
template <class U, class T>
constexpr QuatT<U> convert(const QuatT<T>& q) { return {U(q.x), U(q.y), U(q.z), U(q.w)}; }

using Vec3 = Vec3T<Real>;
using Mat3 = Mat3T<Real>;
using Quat = QuatT<Real>;
using Vec3d = Vec3T<double>;
using Mat3d = Mat3T<double>;
using Quatd = QuatT<double>;

// An absolute position: always double, so that a body far from the origin moves as finely as one at it.
// A type of its own: the difference of two positions is a Vec3, and there is no other way from one to the other.
struct Pos {
  double x = 0, y = 0, z = 0;
  constexpr double& operator[](int i) { return i == 0 ? x : i == 1 ? y : z; }
  constexpr double operator[](int i) const { return i == 0 ? x : i == 1 ? y : z; }
  constexpr bool operator==(const Pos&) const = default;
  template <class T>
  friend constexpr Pos operator+(const Pos& p, const Vec3T<T>& d) { return {p.x + double(d.x), p.y + double(d.y), p.z + double(d.z)}; }
  template <class T>
  friend constexpr Pos operator-(const Pos& p, const Vec3T<T>& d) { return {p.x - double(d.x), p.y - double(d.y), p.z - double(d.z)}; }
  friend constexpr Vec3 operator-(const Pos& a, const Pos& b) { return {Real(a.x - b.x), Real(a.y - b.y), Real(a.z - b.z)}; }
  friend bool is_finite(const Pos& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }
};

// Where something is and how it is turned.
struct Pose {
  Pos p;
  Quat q;
  constexpr bool operator==(const Pose&) const = default;
  Pos point(const Vec3& local) const { return p + rotate(q, local); }             // local point → world
  Vec3 local(const Pos& world) const { return rotate_back(q, world - p); }        // world point → local
};

// The same, relative to something near: all Real.
struct Transform {
  Vec3 p;
  Quat q;
  constexpr bool operator==(const Transform&) const = default;
  Vec3 point(const Vec3& local) const { return p + rotate(q, local); }
  Vec3 local(const Vec3& outer) const { return rotate_back(q, outer - p); }
  friend Transform operator*(const Transform& a, const Transform& b) { return {a.point(b.p), a.q * b.q}; }
  friend Transform inverse(const Transform& t) { return {-rotate_back(t.q, t.p), conjugate(t.q)}; }
};

// An axis-aligned box: absolute, closed (touching counts as overlap).
struct Box {
  Pos low, high;
  friend constexpr bool overlap(const Box& a, const Box& b) {
    return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y &&
           a.low.z <= b.high.z && b.low.z <= a.high.z;
  }
  friend constexpr bool contains(const Box& a, const Box& b) {
    return a.low.x <= b.low.x && b.high.x <= a.high.x && a.low.y <= b.low.y && b.high.y <= a.high.y &&
           a.low.z <= b.low.z && b.high.z <= a.high.z;
  }
};

}
