// Contacts as soft_step iterates on them: W contacts side by side, one a lane, no two of which share a body that answers
// impulses. All that the points of one contact do to each other along the normal goes through three numbers: how the
// contact's middle moves along the normal, and how it tilts about the two tangents. All that they do along the surface
// goes through three others. So a visit reads the bodies once and writes them once.
#pragma once

#include <array>
#include <cstdint>

#include "math/wide.h"

namespace sudar::inline SUDAR_PRECISION {

// What passes read and write of a body; in fours, for wide::load. Body 0 stands for all that stays where it is.
struct alignas(4 * sizeof(Real)) SoftBody {
  Vec3 v;
  Real inverse_mass = 0;                // 0: does not answer impulses
  Vec3 w;                               // world axes
  Real pad_w = 0;
  Vec3 shift;                           // way since the step began, m
  Real pad_shift = 0;
  Vec3 turn;                            // turned since, rad
  Real pad_turn = 0;
  Real xx = 0, xy = 0, xz = 0, yy = 0;  // inverse inertia, world axes
  Real yz = 0, zz = 0, pad_i0 = 0, pad_i1 = 0;
};
static_assert(sizeof(SoftBody) == 24 * sizeof(Real));

// A symmetric 3 × 3 matrix.
template <class T>
struct Symmetric3 {
  T xx{}, xy{}, xz{}, yy{}, yz{}, zz{};
  friend Vec3T<T> operator*(const Symmetric3& m, const Vec3T<T>& v) {
    return {m.xx * v.x + m.xy * v.y + m.xz * v.z, m.xy * v.x + m.yy * v.y + m.yz * v.z,
            m.xz * v.x + m.yz * v.y + m.zz * v.z};
  }
};

template <int W>
struct SoftRows {
  using V = Wide<W>;
  struct Point {
    V x{}, y{};                 // from the middle along the tangents, m
    V separation{};             // when the step began, m
    V normal_mass{};            // 1 / nᵀKn; 0: there is no such point
    V tangent_mass{};           // 1 / the larger eigenvalue of K in the tangent plane
    V normal{}, reference{};    // accumulated impulse; the part of it that does not leak away, N s
    V friction_1{}, friction_2{};
  };
  Vec3T<V> n, t1;               // normal from b to a; t2 = n × t1
  Vec3T<V> ra, rb;              // the middle from the centres of mass, world axes, m
  Symmetric3<V> press;          // how (u·n, −ω·t2, ω·t1) answers impulses along the normal at (1, x, y)
  Symmetric3<V> slide;          // how (u·t1, u·t2, ω·n) answers those along the surface
  V friction{};                 // coefficient, static or dynamic: chosen once a step
  V lift{};                     // added to separations: far apart where the contact is to be left alone
  V glide_1{}, glide_2{};       // how the surfaces move along themselves, a less b, m/s
  V bias_rate{}, mass_scale{}, impulse_scale{};  // softness
  std::array<Point, 4> points;
  std::array<std::uint32_t, W> a{}, b{};         // numbers of the bodies
};

}
