// Contact points as the impulse solvers iterate on them: rows in the contact's own frame, and what one visit does. Rows
// hold only what a visit in the contact passes reads, since they stream through the caches hundreds of times a step;
// what is used once a sub-step is in ManifoldStart and ManifoldPush beside them.
#pragma once

#include "dynamics/contacts.h"
#include "dynamics/rows.h"
#include "math/lanes.h"

namespace sudar::inline SUDAR_PRECISION {

// How a moves relative to b where they touch: in the contact's frame (x along the normal from b to a, y and z
// tangential), the velocity in the middle of the contact's points, and the angular velocity. All that the points of one
// contact can do to each other goes through these six numbers, so a visit reads the bodies once and writes them once.
struct RelativeMotion {
  Real4 u, w;
};
// An impulse and its moment about the middle of the contact, in its frame; on a, b gets the opposite.
struct WrenchImpulse {
  Real4 force{}, moment{};
};

// One contact point. Impulses act on a; b gets the opposite.
struct PointRow {
  Real4 at;                  // from the middle of the contact, in its frame, m
  Real4 glide{};             // added to u: how the surfaces move along themselves, and how the contact curves
  Vec3 impulse;              // accumulated, in the contact's frame, N s
  Real normal_mass;          // 1 / nᵀKn
  Real tangent_mass;         // 1 / the larger eigenvalue of K in the tangent plane: one number for both directions,
                             // because unequal ones would bend the direction of friction
  Real slide_y, slide_z;     // tangent_mass · Kn: friction that answers a unit normal impulse
  Real normal_response, tangent_response;  // inverses of the masses
  Real target;               // u_n that the contact passes aim at
};

// What all points of a contact do together: equal impulses along the normal, which add up to one in their middle. Points
// that one face presses on answer nearly alike, and one after the other would take long to share their load; what is
// left over would turn the body, to the same side in every sub-step, until a tower leans.
struct SharedRow {
  Real response, mass;  // to the impulse of each point; its inverse
  Real target;          // the mean of theirs, less what is added to u
};

struct ManifoldRow {
  Mat3Lanes frame;     // contact's frame → world: columns are the normal from b to a and two tangents
  Mat3Lanes to_frame;  // its transpose
  Real4 ra, rb;        // the middle of the points from the centres of mass, world axes, m
  Mat3Lanes u_by_force, u_by_moment, w_by_force, w_by_moment;  // how the motion answers, thesis (3.11) with its moments
  std::uint32_t a, b;         // numbers of the bodies (SolverBodies)
  std::uint32_t contact;      // number in the input
  std::uint8_t count;
  bool a_answers, b_answers;  // impulses move it
  bool resists_turning;       // there is a TurnRow
  Real friction;              // static or dynamic, chosen once a sub-step
  Real slip_y, slip_z;        // of a lone point: tangent_mass times what the direction of sliding leaves out of `glide`
  SharedRow shared;
  std::array<PointRow, 4> points;
  std::span<PointRow> rows() { return std::span(points).first(count); }
  std::span<const PointRow> rows() const { return std::span(points).first(count); }
};
static_assert(sizeof(Real) != sizeof(float) || sizeof(ManifoldRow) <= 700, "rows stream through the caches");

// Resistance to rolling and spinning: one row of torque for the whole contact, in the contact's frame (x spins, y and z
// roll). Its limits are lengths times the normal impulse.
struct TurnRow {
  Real spin_mass, roll_mass;  // 1 / nᵀI⁻¹n, 1 / the larger tangential eigenvalue
  Real spinning, rolling;     // m
  Vec3 impulse;               // accumulated, N m s
};

// A manifold at the beginning of the sub-step, and what collisions make of it.
struct ManifoldStart {
  struct Point {
    Real depth;          // m
    Real free_speed;     // min(0, depth/h): approach that closes the gap exactly is allowed
    Real speed;          // u_n before collisions, m/s
    Real aim;            // u_n that the impact at hand leaves, m/s
    Real unheld;         // u_n before the joints had their say, m/s
    Vec3 blow;           // impulse of the impact at hand, N s
    Vec3 curving;        // change of u until the middle of the sub-step (curving.h)
    bool hit = false;    // took part in a collision
  };
  std::array<Point, 4> points;
  Real restitution, friction_static, friction_dynamic;
  bool struck = false;  // took part in a collision
  bool owes = false;    // joints took a part of its bounce
};

// Split impulse: accumulated pseudo impulses, and the pseudo speeds apart that they aim at.
struct ManifoldPush {
  std::array<Real, 4> impulse{}, target{};
  bool needed = false;  // some target is not 0
};

inline RelativeMotion motion_of(const ManifoldRow& m, const Moving& a, const Moving& b) {
  return {m.to_frame * ((a.v - b.v) + (cross(a.w, m.ra) - cross(b.w, m.rb))), m.to_frame * (a.w - b.w)};
}
// The relative velocity at a point, thesis (3.9), and what the surfaces add to it.
inline Real4 relative_velocity(const RelativeMotion& t, const PointRow& p) { return t.u + cross(t.w, p.at) + p.glide; }

// What an impulse at a point is in the middle.
inline WrenchImpulse to_middle(const PointRow& p, const Vec3& impulse) {
  const Real4 force = lanes(impulse);
  return {force, cross(p.at, force)};
}
inline void operator+=(WrenchImpulse& sum, const WrenchImpulse& i) { sum.force += i.force, sum.moment += i.moment; }

// How the contact's own motion answers an impulse.
inline void answer(const ManifoldRow& m, RelativeMotion& t, const WrenchImpulse& i) {
  t.u += m.u_by_force * i.force + m.u_by_moment * i.moment;
  t.w += m.w_by_force * i.force + m.w_by_moment * i.moment;
}
// How the bodies do: thesis (3.7), (3.8), (3.10), (3.12). `on_a`, `on_b` hold their masses, a and b are velocities.
inline void apply(Moving& a, Moving& b, const SolverBody& on_a, const SolverBody& on_b, const ManifoldRow& m,
                  const WrenchImpulse& i) {
  const Real4 force = m.frame * i.force, moment = m.frame * i.moment;
  a.v += force * broadcast(on_a.inverse_mass);
  a.w += on_a.inverse_inertia * (moment + cross(m.ra, force));
  b.v -= force * broadcast(on_b.inverse_mass);
  b.w -= on_b.inverse_inertia * (moment + cross(m.rb, force));
}

inline Real slide(const Vec3& u) { return sqrt(square(u.y) + square(u.z)); }  // the tangential part's length

// 1 / the larger eigenvalue of the tangential block of a symmetric K.
inline Real tangential_mass(const Mat3& k) {
  const Real mean = (k.c1.y + k.c2.z) * Real(0.5);
  return 1 / (mean + sqrt(square((k.c1.y - k.c2.z) * Real(0.5)) + square(k.c1.z)));
}

// Sets how the motion answers, from the bodies' masses and the middle's arms: what force and moment about the middle
// make of both bodies, Δω = I⁻¹ (m + r × f), Δu = f/m + Δω × r, in the contact's frame.
inline void prepare_response(ManifoldRow& m, const SolverBody& a, const SolverBody& b) {
  const Mat3 frame = matrix(m.frame), to_frame = matrix(m.to_frame);
  const Real inverse_mass = a.inverse_mass + b.inverse_mass;
  Mat3 u_f = Mat3::diagonal({inverse_mass, inverse_mass, inverse_mass}), u_m{}, w_f{}, w_m{};
  const auto add = [&](const Real4& r, const SolverBody& on) {
    const Mat3 arm = Mat3::skew(to_frame * vector(r)), inertia = to_frame * matrix(on.inverse_inertia) * frame;
    const Mat3 turned = inertia * arm;
    u_f = u_f + transpose(arm) * turned;
    u_m = u_m + transpose(turned);
    w_f = w_f + turned;
    w_m = w_m + inertia;
  };
  add(m.ra, a), add(m.rb, b);
  m.u_by_force = lanes(u_f), m.u_by_moment = lanes(u_m), m.w_by_force = lanes(w_f), m.w_by_moment = lanes(w_m);
  m.shared.response = u_f.c0.x * Real(m.count);
  m.shared.mass = 1 / m.shared.response;
}

// thesis (3.11), (3.13): K, how a point's velocity answers an impulse there, in the contact's frame.
inline Mat3 response_matrix(const ManifoldRow& m, const PointRow& p) {
  const Mat3 arm = Mat3::skew(vector(p.at));
  return matrix(m.u_by_force) + matrix(m.u_by_moment) * arm -
         arm * (matrix(m.w_by_force) + matrix(m.w_by_moment) * arm);
}

// Sets what depends on K alone.
inline void prepare_masses(const ManifoldRow& m, PointRow& p) {
  const Mat3 k = response_matrix(m, p);
  p.normal_response = k.c0.x;
  p.normal_mass = 1 / k.c0.x;
  p.tangent_mass = tangential_mass(k);
  p.tangent_response = 1 / p.tangent_mass;
  p.slide_y = p.tangent_mass * k.c0.y;
  p.slide_z = p.tangent_mass * k.c0.z;
}

inline void prepare_aim(ManifoldRow& m) {
  m.shared.target = 0;
  for (const PointRow& p : m.rows()) m.shared.target += (p.target - p.glide[0]) / Real(m.count);
}

// One visit of a point whose relative velocity is u: the accumulated impulse goes where u_n would be `target`, by the
// share `relaxation` of the way, and where it would not slide, both as far as a contact can push and hold: it is
// projected onto the friction cone. `slip` bends the direction of sliding (ManifoldRow). Returns the step. Written so
// that little waits for something else: each point waits for the one before.
inline Vec3 project_onto_cone(const PointRow& p, const Real4& u, Real target, Real relaxation, Real friction,
                              Real slip_y, Real slip_z, Vec3& impulse) {
  const Real normal = max(-impulse.x, relaxation * p.normal_mass * (target - u[0]));
  Vec3 step{normal, -p.tangent_mass * u[1] - p.slide_y * normal, -p.tangent_mass * u[2] - p.slide_z * normal};
  Vec3 next = impulse + step;
  const Real most = friction * next.x, tangential = square(next.y) + square(next.z);
  if (tangential > square(most)) {
    next.y += slip_y, next.z += slip_z;
    const Real whole = square(next.y) + square(next.z);
    const Real cut = whole > 0 ? most / sqrt(whole) : Real(0);
    next.y *= cut, next.z *= cut;
    step = next - impulse;
  }
  impulse = next;
  return step;
}
// The relative velocity that a step answers; `whole` undoes the relaxation.
inline Real velocity_change(const PointRow& p, const Vec3& step, Real whole) {
  return max(abs(step.x) * p.normal_response * whole, max(abs(step.y), abs(step.z)) * p.tangent_response);
}

inline void prepare_turning(TurnRow& t, const ManifoldRow& m) {
  const Mat3 k = matrix(m.w_by_moment);
  t.spin_mass = 1 / k.c0.x;
  t.roll_mass = tangential_mass(k);
}

// One visit: brakes the relative turning as far as `load`, the contact's normal impulse, can. Returns the moment.
inline Vec3 resist_turning(TurnRow& t, const RelativeMotion& motion, Real load) {
  const Vec3 w = vector(motion.w);
  const Real spin_most = t.spinning * load, roll_most = t.rolling * load;
  Vec3 next{clamp(t.impulse.x - t.spin_mass * w.x, -spin_most, spin_most), t.impulse.y - t.roll_mass * w.y,
            t.impulse.z - t.roll_mass * w.z};
  const Real rolling = slide(next);
  if (rolling > roll_most) next.y *= roll_most / rolling, next.z *= roll_most / rolling;
  const Vec3 step = next - t.impulse;
  t.impulse = next;
  return step;
}
// The relative angular velocity that a moment answers.
inline Real turn_change(const TurnRow& t, const Vec3& step) {
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
