// The 4×4 matrices of drawing, in float and column by column as OpenGL wants them. Everything drawn is placed relative
// to the eye, in double before it is rounded to float, so that a scene far from the origin does not shake.
#pragma once

#include <sudar/math.h>

namespace sudar::view {

using Vec3f = Vec3T<float>;

inline Vec3f to_float(const Vec3& v) { return {float(v.x), float(v.y), float(v.z)}; }
inline Vec3f relative(const Pos& p, const Pos& eye) {
  return {float(p.x - eye.x), float(p.y - eye.y), float(p.z - eye.z)};
}

struct Vec4f {
  float x = 0, y = 0, z = 0, w = 0;
};
inline Vec4f with_w(const Vec3f& v, float w) { return {v.x, v.y, v.z, w}; }

// The turn (as a quaternion x, y, z, w) that takes y to `direction`, of length 1.
inline Vec4f turn_y_to(const Vec3f& direction) {
  const Vec3f axis = cross(Vec3f{0, 1, 0}, direction);
  const float w = 1 + direction.y;
  if (w < 1e-6f) return {1, 0, 0, 0};
  const float s = 1 / sudar::sqrt(dot(axis, axis) + w * w);
  return {axis.x * s, axis.y * s, axis.z * s, w * s};
}

struct Mat4 {
  float m[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  float& at(int row, int column) { return m[column * 4 + row]; }
  float at(int row, int column) const { return m[column * 4 + row]; }

  friend Mat4 operator*(const Mat4& a, const Mat4& b) {
    Mat4 c;
    for (int row = 0; row < 4; ++row) {
      for (int column = 0; column < 4; ++column) {
        float sum = 0;
        for (int k = 0; k < 4; ++k) sum += a.at(row, k) * b.at(k, column);
        c.at(row, column) = sum;
      }
    }
    return c;
  }
};

// Three axes at right angles: where a camera or a light looks.
struct Frame3 {
  Vec3f right, up, back;
};
inline Frame3 looking_along(const Vec3f& direction) {
  const Vec3f back = -normalize(direction);
  const Vec3f hint = abs(back.y) > 0.999f ? Vec3f{0, 0, -1} : Vec3f{0, 1, 0};
  const Vec3f right = normalize(cross(hint, back));
  return {right, cross(back, right), back};
}

// World axes → the frame's axes.
inline Mat4 into_frame(const Frame3& f) {
  Mat4 r;
  for (int i = 0; i < 3; ++i) r.at(0, i) = f.right[i], r.at(1, i) = f.up[i], r.at(2, i) = f.back[i];
  return r;
}

// `slope_x`, `slope_y`: tangents of half the picture's angles.
inline Mat4 perspective(float slope_x, float slope_y, float near, float far) {
  Mat4 p;
  p.at(0, 0) = 1 / slope_x;
  p.at(1, 1) = 1 / slope_y;
  p.at(2, 2) = (far + near) / (near - far);
  p.at(2, 3) = 2 * far * near / (near - far);
  p.at(3, 2) = -1;
  p.at(3, 3) = 0;
  return p;
}

// The box low…high, seen along −z.
inline Mat4 orthographic(const Vec3f& low, const Vec3f& high) {
  Mat4 p;
  for (int i = 0; i < 3; ++i) {
    const float size = high[i] - low[i], sign = i == 2 ? -1.0f : 1.0f;
    p.at(i, i) = sign * 2 / size;
    p.at(i, 3) = -sign * (high[i] + low[i]) / size;
  }
  return p;
}

}
