// Contact points as the impulse solvers iterate on them: rows in the contact's own frame, and what one visit does.
#pragma once

#include "dynamics/contacts.h"
#include "dynamics/rows.h"
#include "math/lanes.h"

namespace sudar::inline SUDAR_PRECISION {

// One contact point. Velocities and impulses are in the contact's frame: x along the normal from b to a, y and z
// tangential. Impulses act on a; b gets the opposite.
struct PointRow {
  Mat3Lanes arm_a, arm_b;    // ω → velocity of the point in the contact's frame
  Mat3Lanes turn_a, turn_b;  // I⁻¹ armᵀ: impulse → change of ω
  Real4 glide{};             // added to u: how the surfaces move along themselves, and how the contact curves
  Vec3 impulse;              // accumulated, N s
  Real normal_mass;          // 1 / nᵀKn
  Real tangent_mass;         // 1 / the larger eigenvalue of K in the tangent plane: one number for both directions,
                             // because unequal ones would bend the direction of friction
  Real slide_y, slide_z;     // tangent_mass · Kn: friction that answers a unit normal impulse
  Real slip_y, slip_z;       // tangent_mass times what the direction of sliding friction leaves out of `glide`
  Real normal_response, tangent_response;  // their inverses
  Real target;                             // u_n that the contact passes aim at
  // used once a sub-step
  Vec3 curving;          // change of u until the middle of the sub-step (curving.h)
  Real free_speed;       // min(0, depth/h): approach that closes the gap exactly is allowed
  Real start;            // u_n before collisions, m/s
  Real aim;              // u_n that the impact at hand leaves, m/s
  Real unheld;           // u_n before the joints had their say, m/s
  Vec3 blow;             // impulse of the impact at hand, N s
  Real push = 0;         // accumulated, pseudo
  Real push_target = 0;  // pseudo speed apart, m/s
  Vec3 ra, rb;           // from the centres of mass, world axes, m
  bool hit = false;      // took part in a collision
};

// Resistance to rolling and spinning: one row of torque for the whole contact, in the contact's frame (x spins, y and z
// roll). Its limits are lengths times the normal impulse.
struct TurnRow {
  Mat3Lanes turn_a, turn_b;   // I⁻¹ times the frame
  Real spin_mass, roll_mass;  // 1 / nᵀI⁻¹n, 1 / the larger tangential eigenvalue
  Vec3 impulse;               // accumulated, N m s
};

// What all points of a contact do together: an impulse along the normal in their middle. Points that one face presses
// on answer nearly alike, and one after the other would take long to share their load; what is left over would turn the
// body, to the same side in every sub-step, until a tower leans.
struct SharedRow {
  PreparedRow row;
  Real response, mass;  // to the impulse of each point; its inverse
  Real target;          // the mean of theirs, less what is added to u
};

struct ManifoldRow {
  Mat3Lanes to_frame;        // world → contact's frame
  Mat3Lanes mass_a, mass_b;  // impulse in the contact's frame → change of v: 1/m times the frame
  std::uint32_t a, b, contact;
  std::uint32_t count;
  Real friction;  // static or dynamic, chosen once a sub-step
  Mat3 frame;     // columns: normal from b to a, two tangents
  Material material;
  TurnRow turn;
  SharedRow shared;
  bool a_answers, b_answers;  // impulses move it
  bool struck, owes;          // took part in a collision; joints took a part of its bounce
  std::array<PointRow, 4> points;
  bool resists_turning() const { return material.rolling > 0 || material.spinning > 0; }
  std::span<PointRow> rows() { return std::span(points).first(count); }
  std::span<const PointRow> rows() const { return std::span(points).first(count); }
};

// u in the contact's frame, thesis (3.9), and what the surfaces add to it.
inline Real4 relative_velocity(const Moving& a, const Moving& b, const ManifoldRow& m, const PointRow& p) {
  return m.to_frame * (a.v - b.v) + (p.arm_a * a.w - p.arm_b * b.w) + p.glide;
}

// thesis (3.7), (3.8), (3.10), (3.12)
inline void apply(Moving& a, Moving& b, const ManifoldRow& m, const PointRow& p, const Vec3& impulse) {
  const Real4 step = lanes(impulse);
  a.v += m.mass_a * step;
  a.w += p.turn_a * step;
  b.v -= m.mass_b * step;
  b.w -= p.turn_b * step;
}

inline Real slide(const Vec3& u) { return sqrt(square(u.y) + square(u.z)); }  // the tangential part's length

// 1 / the larger eigenvalue of the tangential block of a symmetric K.
inline Real tangential_mass(const Mat3& k) {
  const Real mean = (k.c1.y + k.c2.z) * Real(0.5);
  return 1 / (mean + sqrt(square((k.c1.y - k.c2.z) * Real(0.5)) + square(k.c1.z)));
}

// Sets what depends on K alone: thesis (3.11), (3.13) K = (1/m_a + 1/m_b) E − r̃_a I_a⁻¹ r̃_a − r̃_b I_b⁻¹ r̃_b, in the
// contact's frame.
inline void prepare_masses(PointRow& p, const Mat3& to_frame, const SolverBody& a, const SolverBody& b) {
  const Mat3 arm_a = to_frame * Mat3::skew(-p.ra), arm_b = to_frame * Mat3::skew(-p.rb);
  const Mat3 turn_a = a.inverse_inertia * transpose(arm_a), turn_b = b.inverse_inertia * transpose(arm_b);
  const Real inverse_mass = a.inverse_mass + b.inverse_mass;
  const Mat3 k = Mat3::diagonal({inverse_mass, inverse_mass, inverse_mass}) + arm_a * turn_a + arm_b * turn_b;
  p.normal_response = k.c0.x;
  p.normal_mass = 1 / k.c0.x;
  p.tangent_mass = tangential_mass(k);
  p.tangent_response = 1 / p.tangent_mass;
  p.slide_y = p.tangent_mass * k.c0.y;
  p.slide_z = p.tangent_mass * k.c0.z;
  p.arm_a = lanes(arm_a), p.arm_b = lanes(arm_b);
  p.turn_a = lanes(turn_a), p.turn_b = lanes(turn_b);
}

// Sets the shared row but for its target, which prepare_aim() sets once the points have theirs.
inline void prepare_shared(ManifoldRow& m, const SolverBody& a, const SolverBody& b) {
  Vec3 ra, rb;
  for (const PointRow& p : m.rows()) ra += p.ra / Real(m.count), rb += p.rb / Real(m.count);
  const Vec3 n = m.frame.c0;
  m.shared.row = PreparedRow({n, n, cross(ra, n), cross(rb, n)}, a, b);
  m.shared.response = response(m.shared.row, m.shared.row) * Real(m.count);
  m.shared.mass = 1 / m.shared.response;
}
inline void prepare_aim(ManifoldRow& m) {
  m.shared.target = 0;
  for (const PointRow& p : m.rows()) m.shared.target += (p.target - p.glide[0]) / Real(m.count);
}

// One visit of a point whose relative velocity is u: the accumulated impulse goes where u_n would be `target`, by the
// share `relaxation` of the way, and where it would not slide, both as far as a contact can push and hold. Written so
// that little waits for something else: each point waits for the one before.
inline Vec3 answer(const PointRow& p, const Real4& u, Real target, Real relaxation, Real friction, Vec3& impulse) {
  const Real normal = max(-impulse.x, relaxation * p.normal_mass * (target - u[0]));
  Vec3 step{normal, -p.tangent_mass * u[1] - p.slide_y * normal, -p.tangent_mass * u[2] - p.slide_z * normal};
  Vec3 next = impulse + step;
  const Real most = friction * next.x, tangential = square(next.y) + square(next.z);
  if (tangential > square(most)) {
    next.y += p.slip_y, next.z += p.slip_z;
    const Real whole = square(next.y) + square(next.z);
    const Real cut = whole > 0 ? most / sqrt(whole) : Real(0);
    next.y *= cut, next.z *= cut;
    step = next - impulse;
  }
  impulse = next;
  return step;
}
// A step as the relative velocity that it answers; `whole` undoes the relaxation.
inline Real size(const PointRow& p, const Vec3& step, Real whole) {
  return max(abs(step.x) * p.normal_response * whole, max(abs(step.y), abs(step.z)) * p.tangent_response);
}

inline void prepare_turning(TurnRow& t, const Mat3& frame, const SolverBody& a, const SolverBody& b) {
  const Mat3 turn_a = a.inverse_inertia * frame, turn_b = b.inverse_inertia * frame;
  const Mat3 k = transpose(frame) * (turn_a + turn_b);
  t.turn_a = lanes(turn_a), t.turn_b = lanes(turn_b);
  t.spin_mass = 1 / k.c0.x;
  t.roll_mass = tangential_mass(k);
}

inline void apply_turning(Moving& a, Moving& b, const TurnRow& t, const Vec3& impulse) {
  const Real4 step = lanes(impulse);
  a.w += t.turn_a * step;
  b.w -= t.turn_b * step;
}

// One visit: brakes the relative turning as far as `load`, the contact's normal impulse, can. Returns the change of the
// relative angular velocity.
inline Real resist_turning(ManifoldRow& m, Moving& a, Moving& b, Real load) {
  TurnRow& t = m.turn;
  const Vec3 w = vector(m.to_frame * (a.w - b.w));
  const Real spin_most = m.material.spinning * load, roll_most = m.material.rolling * load;
  Vec3 next{clamp(t.impulse.x - t.spin_mass * w.x, -spin_most, spin_most), t.impulse.y - t.roll_mass * w.y,
            t.impulse.z - t.roll_mass * w.z};
  const Real rolling = slide(next);
  if (rolling > roll_most) next.y *= roll_most / rolling, next.z *= roll_most / rolling;
  const Vec3 step = next - t.impulse;
  apply_turning(a, b, t, step);
  t.impulse = next;
  return max(abs(step.x) / t.spin_mass, max(abs(step.y), abs(step.z)) / t.roll_mass);
}

// Whether the contact as a whole is at the edge of its cone: in sum, or (turning on the spot) in every loaded point.
// One point at its edge says nothing: how the load is shared among points is not determined.
inline bool slips(std::span<const Vec3> impulses, Real coefficient) {
  const Real nearly = Real(0.999) * coefficient;
  Vec3 sum;
  bool everywhere = true;
  for (const Vec3& p : impulses) {
    sum += p;
    everywhere &= slide(p) >= nearly * p.x;
  }
  return sum.x > 0 && (everywhere || slide(sum) >= nearly * sum.x);
}

}
