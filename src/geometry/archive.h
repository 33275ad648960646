// Vectors, poses and shapes as bytes (base/archive.h).
#pragma once

#include "base/archive.h"
#include "geometry/geometry.h"

namespace sudar::inline SUDAR_PRECISION {

template <class T>
concept PlainMath = std::is_same_v<T, Vec3> || std::is_same_v<T, Quat> || std::is_same_v<T, Pos> ||
                    std::is_same_v<T, Vec3d> || std::is_same_v<T, Mat3> || std::is_same_v<T, Transform>;

template <PlainMath T>
void write(Writer& w, const T& x) { w.plain(&x, 1); }
template <PlainMath T>
void read(Reader& r, T& x) { r.raw(&x, sizeof x); }

template <PlainMath T>
void list_components(const T& x, const std::string& path, Leaves& out) {
  using Scalar = std::conditional_t<std::is_same_v<T, Pos> || std::is_same_v<T, Vec3d>, double, Real>;
  out.push_back(leaf_of(path, reinterpret_cast<const Scalar*>(&x), sizeof x / sizeof(Scalar)));
}

// A shape is written as its own data (kind, sizes, vertices, faces), not as the call that made it: a later version whose
// hull builder differs still reads the same geometry.
void write(Writer& w, const Shape& shape);
void read(Reader& r, Shape& shape);

}
