#include "dynamics/drives.h"

#include <algorithm>

#include "dynamics/integrate.h"
#include "math/trig.h"

namespace sudar::inline SUDAR_PRECISION {

namespace {

// Share of its force with which a servo plans to brake: the rest mends what the plan did not know.
constexpr Real planned = Real(0.98);
constexpr std::size_t most_coupled = 32;  // drives in a group that plan together
// A group of more visits than this in a pass: its drives carry their own joint only, and passes do the rest.
constexpr std::size_t most_carried = 256;
// Of what its bodies alone would answer: less, and the joints leave a drive nothing to move.
constexpr Real least_answer = sizeof(Real) == 4 ? Real(1e-5) : Real(1e-9);

// The fastest approach from which the deceleration a still stops at the target, in steps of h that drift with the new
// speed: v²/2a + vh/2 = way.
Real stoppable(Real way, Real a, Real h) {
  const Real half = a * h * Real(0.5);
  if (!(half * half < std::numeric_limits<Real>::infinity())) return way / h;
  return min(sqrt(square(half) + 2 * a * way) - half, way / h);
}

Real inner(const Vec3& v, const Vec3& w, const Moving& m) { return dot(v, vector(m.v)) + dot(w, vector(m.w)); }

// The inverse of a symmetric positive matrix; false where it has (almost) none.
bool invert(std::vector<Real> a, std::size_t n, std::vector<Real>& inverse) {
  inverse.assign(n * n, 0);
  std::vector<Real> least(n);
  for (std::size_t i = 0; i < n; ++i) inverse[i * n + i] = 1, least[i] = a[i * n + i] * Real(1e-4);
  for (std::size_t p = 0; p < n; ++p) {
    if (!(a[p * n + p] > least[p])) return false;
    const Real scale = 1 / a[p * n + p];
    for (std::size_t c = 0; c < n; ++c) a[p * n + c] *= scale, inverse[p * n + c] *= scale;
    for (std::size_t r = 0; r < n; ++r) {
      const Real factor = a[r * n + p];
      if (r == p || factor == 0) continue;
      for (std::size_t c = 0; c < n; ++c) {
        a[r * n + c] -= factor * a[p * n + c], inverse[r * n + c] -= factor * inverse[p * n + c];
      }
    }
  }
  return true;
}

}

void Drives::prepare(SubStep& s, std::span<const JointGroup> groups) {
  impulses_.assign(s.joint_rows.size(), 0);
  kept_.resize(s.joint_rows.size());
  if (field_.size() < s.on.size()) field_.resize(s.on.size());
  for (const JointGroup& g : groups) prepare_group(g, s);
}

void Drives::forget(const JointGroup& g, const SubStep& s) {
  for (const std::uint32_t body : g.component->bodies) field_[s.on.number(body)] = {};
  field_[SolverBodies::still] = {};
}

void Drives::prepare_group(const JointGroup& g, SubStep& s) {
  driven_.clear();
  for (const std::uint32_t k : g.joints) {
    if (s.joint_rows[k].driven()) driven_.emplace_back(k);
  }
  if (driven_.empty()) return;
  std::optional<JointSystem> alone;  // of one joint
  const auto own = [&](std::uint32_t k, Driven& d) {
    const auto answers = [&](std::uint32_t i) { return s.on[i].answers() ? i : JointSystem::nobody; };
    const JointSolve& j = s.joint_rows[k];
    const JointSystem::Joint joint{answers(j.a), answers(j.b), int(j.rows().size())};
    alone = JointSystem::plan({&joint, 1}, std::numeric_limits<std::int64_t>::max());
    rows_ = {j.rows()};
    alone->factor(rows_);
    respond(*alone, {&k, 1}, s, d);
  };
  std::optional<JointSystem>& system = g.component->system;
  if (system) {
    rows_of(g, s.joint_rows, rows_);
    system->factor(rows_);
  }
  const std::size_t n = driven_.size();
  answer_.assign(n * n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    Driven& d = driven_[i];
    if (system)
      respond(*system, g.joints, s, d);
    else
      own(d.joint, d);
    for (const std::uint32_t body : g.component->dynamic) d.motion.push_back(field_[s.on.number(body)]);
    for (std::size_t k = 0; k < n; ++k) {
      const JointSolve& other = s.joint_rows[driven_[k].joint];
      answer_[i * n + k] = other.coordinate().speed(field_[other.a], field_[other.b]);
    }
    answer_[i * n + i] = d.inverse_mass;
    forget(g, s);
  }
  for (Driven& d : driven_) {
    Real inverse_mass = d.inverse_mass;
    if (system && n * g.joints.size() > most_carried) {
      Driven local(d.joint);
      own(d.joint, local);
      forget(g, s);
      inverse_mass = local.inverse_mass, kept_[d.joint] = std::move(local.carried);
    } else {
      kept_[d.joint] = std::move(d.carried);
    }
    s.joint_rows[d.joint].set_response(inverse_mass, kept_[d.joint]);
  }
  carry_on(g, s);
  couple();
  aim(s, true);
  solve(s);
  aim(s, false);
}

// The motion of a unit impulse, and the joints' impulses that keep it one that they allow. Its kinetic energy is half
// the answer: that way rounding is not magnified where d and cᵀ A⁻¹ c almost cancel.
void Drives::respond(JointSystem& system, std::span<const std::uint32_t> joints, SubStep& s, Driven& d) {
  const JointSolve& own = s.joint_rows[d.joint];
  own.coordinate().apply(field_[own.a], field_[own.b], 1);
  for (const std::uint32_t k : joints) d.carried.push_back({&s.joint_rows[k], {}});
  lambda_.resize(joints.size());
  for (int refinement = 0; refinement < 2; ++refinement) {
    for (std::size_t n = 0; n < joints.size(); ++n) {
      const JointSolve& j = s.joint_rows[joints[n]];
      for (std::size_t r = 0; r < j.rows().size(); ++r)
        lambda_[n][r] = -j.rows()[r].speed(field_[j.a], field_[j.b]);
    }
    system.solve(lambda_);
    for (std::size_t n = 0; n < joints.size(); ++n) {
      const JointSolve& j = s.joint_rows[joints[n]];
      for (std::size_t r = 0; r < j.rows().size(); ++r) {
        j.rows()[r].apply(field_[j.a], field_[j.b], lambda_[n][r]);
        d.carried[n].impulse[r] += lambda_[n][r];
      }
    }
  }
  Real energy = 0;
  std::vector<std::uint32_t> bodies;
  for (const std::uint32_t k : joints) bodies.push_back(s.joint_rows[k].a), bodies.push_back(s.joint_rows[k].b);
  std::sort(bodies.begin(), bodies.end());
  bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
  for (const std::uint32_t n : bodies) {
    if (!s.on[n].answers()) continue;
    const std::uint32_t i = s.on.slot(n);
    const Vec3 v = vector(field_[n].v), w = vector(field_[n].w);
    energy += s.in.bodies.mass[i] * length_squared(v) + dot(w, s.in.bodies.inertia_world(i) * w);
  }
  d.inverse_mass = max(energy, least_answer * response(own.coordinate(), own.coordinate()));
}

// By the principle of virtual work: what the loads do along the motion of a unit impulse, the rate gains.
void Drives::carry_on(const JointGroup& g, const SubStep& s) {
  const Bodies& bodies = s.in.bodies;
  evaluate(s.in.forces, bodies, g.component->dynamic, loads_);
  for (Driven& d : driven_) d.rate = d.carried_on = s.joint_rows[d.joint].rate(s.on);
  for (std::size_t n = 0; n < loads_.size(); ++n) {
    const std::uint32_t i = g.component->dynamic[n];
    const SolverBody& now = s.on[s.on.number(i)];
    SolverBody then = now;
    accelerate(bodies, i, loads_[n], drag_on(s.in.forces, bodies, i), s.h, then);
    const Vec3 momentum = vector(then.real.v - now.real.v) * bodies.mass[i];
    const Vec3 turn = bodies.inertia_world(i) * vector(then.real.w - now.real.w);
    for (Driven& d : driven_) d.carried_on += inner(momentum, turn, d.motion[n]);
  }
}

// The inertia matrix of the driven coordinates: what one of them feels while the others are held. Where two drive the
// same motion there is none, and each is taken for itself.
void Drives::couple() {
  const std::size_t n = driven_.size();
  if (n <= most_coupled && invert(answer_, n, inertia_)) return;
  inertia_.assign(n * n, 0);
  for (std::size_t i = 0; i < n; ++i) inertia_[i * n + i] = 1 / answer_[i * n + i];
}

// What the drive's force and the loads can do to stop servo n over the way that is left: the loads' work is taken
// as if every body went on along its circle, F·u sin kw / k + F·(ω × u) (1 − cos kw) / k² with its motion u, ω per unit
// of the coordinate and k = |ω|: exact for what turns about an axis or slides along one under forces that do not
// change.
Drives::Servo Drives::plan(const SubStep& s, std::size_t n, Real way) const {
  const std::size_t count = driven_.size();
  const Real inertia = inertia_[n * count + n], distance = abs(way), forward = way < 0 ? Real(-1) : Real(1);
  Real work = 0;
  for (std::size_t b = 0; b < loads_.size(); ++b) {
    const Wrench& load = loads_[b];
    if (load.force == Vec3{} && load.torque == Vec3{}) continue;
    Vec3 u, w;
    for (std::size_t j = 0; j < count; ++j) {
      const Real share = inertia_[n * count + j] * forward;
      u += vector(driven_[j].motion[b].v) * share, w += vector(driven_[j].motion[b].w) * share;
    }
    const Real k = length(w), angle = k * distance;
    Real along = distance, across = distance * distance * Real(0.5);
    if (angle > Real(0.01)) along = sin(angle) / k, across = (1 - cos(angle)) / (k * k);
    work += dot(load.force, u) * along + dot(load.force, cross(w, u)) * across + dot(load.torque, w) * distance;
  }
  const Real force = s.joint_rows[driven_[n].joint].drive(s.in.joint_state).force;
  // At the target itself it must be able to creep, whatever pulls.
  const Real left = distance > 0 ? force - work / distance : force;
  return {way, planned * max(left, Real(1e-3) * force) / inertia, inertia};
}

// `staggered`: half of the drive's impulse acts before the drift and half after, so that half of the present rate is
// still driven before the new one counts.
void Drives::aim(SubStep& s, bool staggered) {
  const std::size_t n = driven_.size();
  std::vector<Servo> plans(n);
  for (std::size_t i = 0; i < n; ++i) {
    const JointSolve& j = s.joint_rows[driven_[i].joint];
    const Drive& drive = j.drive(s.in.joint_state);
    if (drive.mode != DriveMode::servo) continue;
    const Real rest = drive.target - s.in.joint_state.coordinate[j.joint()];
    plans[i] = plan(s, i, staggered ? rest - s.h * driven_[i].rate * Real(0.5) : rest);
  }
  // Servos that brake together press on each other: each plans so softly that all have the force for it.
  Real share = 1;
  for (std::size_t i = 0; i < n; ++i) {
    if (plans[i].inertia == 0) continue;
    Real needed = plans[i].inertia * plans[i].deceleration;
    const Real own = needed;
    for (std::size_t k = 0; k < n; ++k) {
      const Real much = plans[k].deceleration * s.h;
      if (k == i || plans[k].inertia == 0) continue;
      if (abs(plans[k].way) > much * s.h || abs(driven_[k].rate) > much)
        needed += abs(inertia_[i * n + k]) * plans[k].deceleration;
    }
    if (own < needed) share = min(share, own / needed);
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (plans[i].inertia == 0) continue;
    JointSolve& j = s.joint_rows[driven_[i].joint];
    const Servo& servo = plans[i];
    const Real speed = min(stoppable(abs(servo.way), share * servo.deceleration, s.h), j.drive(s.in.joint_state).max_speed);
    j.set_aim(servo.way < 0 ? -speed : speed);
  }
}

// The impulses of the group's drives together, each within its force: projected Gauss–Seidel.
void Drives::solve(const SubStep& s) {
  constexpr int passes = 50;
  const std::size_t n = driven_.size();
  for (int pass = 0; pass < passes; ++pass) {
    Real change = 0, all = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const JointSolve& j = s.joint_rows[driven_[i].joint];
      Real rate = driven_[i].carried_on;
      for (std::size_t k = 0; k < n; ++k) rate += answer_[k * n + i] * impulses_[driven_[k].joint];
      const Real most = j.drive(s.in.joint_state).force * s.h;
      Real& impulse = impulses_[driven_[i].joint];
      const Real total = clamp(impulse + (j.aim() - rate) / answer_[i * n + i], -most, most);
      change = max(change, abs(total - impulse) * answer_[i * n + i]), all = max(all, abs(j.aim()) + abs(rate));
      impulse = total;
    }
    if (change <= Real(1e-6) * all) break;
  }
}

}
