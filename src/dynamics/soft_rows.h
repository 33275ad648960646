// Contacts as soft_step iterates on them: some contacts side by side, one a lane, no two of which share a body that
// answers impulses. All that the points of one contact do to each other along the normal goes through three numbers: how
// the contact's middle moves along the normal, and how it tilts about the two tangents. All that they do along the
// surface goes through three others. So a visit reads the bodies once and writes them once.
#pragma once

#include <cstdint>

#include <sudar/math.h>

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
  Real most_turn = 0;                   // square of the turn, rad², beyond which what contacts know of its inertia is too old
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

// A number of each of the contacts side by side, as it lies in memory. Passes take them in registers of fewer lanes, if
// that is what the processor has.
struct alignas(64) SoftLanes {
  static constexpr int count = 16;
  Real x[count]{};
  Real& operator[](std::uint32_t lane) { return x[lane]; }
  const Real& operator[](std::uint32_t lane) const { return x[lane]; }
};

struct SoftRows {
  using V = SoftLanes;
  struct Point {
    V x, y;              // from the middle along the tangents, m
    V separation;        // when the step began, m
    V normal_mass;       // 1 / nᵀKn; 0: there is no such point. Not 0 where `answer` is to set it
    V tangent_mass;      // 1 / the larger eigenvalue of K in the tangent plane
    V reference;         // impulse that does not leak away, N s
    V normal, friction_1, friction_2;  // accumulated, N s
  };
  Vec3T<V> n, t1;        // normal from b to a; t2 = n × t1
  Vec3T<V> ra, rb;       // the middle from the centres of mass, world axes, m
  Symmetric3<V> press;   // how (u·n, −ω·t2, ω·t1) answers impulses along the normal at (1, x, y)
  Symmetric3<V> slide;   // how (u·t1, u·t2, ω·n) answers those along the surface
  V friction, friction_dynamic;  // coefficients: the one at work, and the one of what slips
  V spin_mass, roll_mass;        // 1 / nᵀI⁻¹n, 1 / the larger eigenvalue of I⁻¹ in the tangent plane
  V spinning, rolling;           // limits of the moments as lengths times the normal impulse, m
  V spin, roll_1, roll_2;        // accumulated moments about n, t1, t2, N m s
  V lift;                // added to separations: far apart where the contact is to be left alone
  Vec3T<V> apart;        // from b's centre to a's when the step began, m
  V owned_by_a;          // 1: the contact's points go along with a, 0: with b
  V glide_1, glide_2;    // how the surfaces move along themselves, a less b, m/s
  V bias_rate, mass_scale, impulse_scale;          // softness
  Point points[4];
  std::uint32_t a[V::count]{}, b[V::count]{};      // numbers of the bodies
  std::uint32_t used = 0;                          // lanes, the first ones
  std::uint32_t most_points = 4;                   // 1, 2 or 4: no contact has more
  bool turning = false;                            // some contact resists turning
};

// Ball joints side by side.
struct SoftBallRows {
  using V = SoftLanes;
  Vec3T<V> ra, rb;       // anchors from the centres of mass when the step began, world axes, m
  Vec3T<V> gap;          // anchor a less anchor b then, m
  Vec3T<V> impulse;      // accumulated, on a, N s
  std::uint32_t a[V::count]{}, b[V::count]{};
  std::uint32_t used = 0;
};

// Bodies side by side in the order of their numbers: all that moves them but their velocities, which lie in SoftBody.
struct SoftMotion {
  using V = SoftLanes;
  QuatT<V> orientation;               // principal frame → world
  Vec3T<V> momentum;                  // angular, about the centre of mass, world axes
  Vec3T<V> spin;                      // ω that it stands for, until impulses change ω
  Vec3T<V> inertia, inverse_inertia;  // principal moments
  Vec3T<V> acceleration, angular_acceleration;  // by forces but drag
  V drag, quadratic_drag, angular_drag, quadratic_angular_drag;  // rates, see DragRates
  V falls;                            // 1; 0: has just bounced, and forces do not act in this sub-step
  Vec3T<V> v_before, momentum_before;  // after forces, before contacts
  Vec3T<V> gain_v, gain_momentum;     // what contacts made of them in the last sub-step
  std::uint32_t first = 0, used = 0;  // numbers of bodies
  bool turned_far = false;            // some body has, beyond its most_turn
};

struct PassSettings {
  Real h;           // s
  Real push_speed;  // overlap is not undone faster, m/s
  Real reach;       // within which a loaded point is still held though it is apart, m
  Real joint_bias_rate, joint_mass_scale, joint_impulse_scale;  // softness of joints
};

// The passes, for registers of some width.
struct SoftPassTable {
  int lanes;
  // Forces act, and then what contacts did in the last sub-step, since their impulses begin with those.
  void (*begin)(SoftMotion*, std::size_t, SoftBody*, const PassSettings&);
  // Positions follow velocities (dynamics/rotation.h, side by side).
  void (*drift)(SoftMotion*, std::size_t, SoftBody*, const PassSettings&);
  // Takes over the velocities, and notes what contacts did.
  void (*settle)(SoftMotion*, std::size_t, SoftBody*, const PassSettings&);
  // Sets how bodies answer impulses at contacts: press, slide and all masses.
  void (*answer)(SoftRows*, std::size_t, SoftBody*, const PassSettings&);
  // The same for contacts of bodies that have turned far.
  void (*answer_again)(SoftRows*, std::size_t, SoftBody*, const PassSettings&);
  // Applies what is accumulated.
  void (*warm)(const SoftRows*, std::size_t, SoftBody*, const PassSettings&);
  // Normal impulses against overlap: soft where points are within reach, exact where they are farther apart.
  void (*solve)(SoftRows*, std::size_t, SoftBody*, const PassSettings&);
  // The same without the push that undoes overlap; then friction.
  void (*relax)(SoftRows*, std::size_t, SoftBody*, const PassSettings&);
  // The same for ball joints.
  void (*warm_balls)(const SoftBallRows*, std::size_t, SoftBody*, const PassSettings&);
  void (*solve_balls)(SoftBallRows*, std::size_t, SoftBody*, const PassSettings&);
  void (*relax_balls)(SoftBallRows*, std::size_t, SoftBody*, const PassSettings&);
};
// Turns one body so fast that a sub-step is too long for its turn; for the drift.
void turn_in_parts(SoftMotion&, std::uint32_t lane, Real h);

// The widest that this processor has, of at most `lanes`; 0: any. All have the same bits.
const SoftPassTable& soft_passes(int lanes);

}
