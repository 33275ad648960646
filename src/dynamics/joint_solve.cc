#include "dynamics/joint_solve.h"

#include "dynamics/integrate.h"

namespace sudar::inline SUDAR_PRECISION {

JointSolve::JointSolve(Joints& joints, const Bodies& bodies, std::uint32_t joint, const SolverBodies& on, Real h)
    : a(on.number(joints.a[joint])), b(on.number(joints.b[joint])), a_answers_(on[a].answers()),
      b_answers_(on[b].answers()), joint_(joint), impulse_(joints.impulse[joint].rows) {
  const JointRows demands = rows_of(joints, bodies, joint);
  set_rows(demands, on);
  if (demands.free) prepare_coordinate(joints, bodies, demands, on, h);
}

const Drive& JointSolve::drive(const Joints& joints) const { return *drive_of(joints.definition[joint_]); }

void JointSolve::put(SolverBodies& on, Moving SolverBody::*which, const Moving& on_a, const Moving& on_b) const {
  if (a_answers_) on[a].*which = on_a;
  if (b_answers_) on[b].*which = on_b;
}

void JointSolve::set_rows(const JointRows& demands, const SolverBodies& on) {
  count_ = demands.count;
  for (std::size_t r = 0; r < std::size_t(count_); ++r) rows_[r] = {demands.rows[r], on[a], on[b]};
  if (demands.free) coordinate_ = {demands.rate, on[a], on[b]};
}

void JointSolve::renew_rows(const Joints& joints, const Bodies& bodies, const SolverBodies& on) {
  set_rows(rows_of(joints, bodies, joint_), on);
}

Real JointSolve::error() const {
  Real largest = 0;
  for (const PreparedRow& row : rows()) largest = max(largest, abs(row.error));
  return largest;
}

Real JointSolve::strongest() const {
  Real most = 0;
  for (std::size_t r = 0; r < rows().size(); ++r) most = max(most, abs(impulse_[r]) * response(rows_[r], rows_[r]));
  for (const BoundedRow* row : {&low_, &high_, &drive_}) {
    if (row->present) most = max(most, abs(row->impulse) / row->mass);
  }
  return most;
}

void JointSolve::restart(const Joints& joints, const Bodies& bodies, const SolverBodies& on) {
  renew_rows(joints, bodies, on);
  impulse_ = joints.impulse[joint_].rows;
}

Vec3 JointSolve::linear_impulse() const {
  Real4 sum{};
  for (std::size_t r = 0; r < std::size_t(count_); ++r) sum += rows_[r].a.linear * broadcast(impulse_[r]);
  return vector(sum);
}

// By how much the coordinate's rate changes over the sub-step without any impulse: the joint's directions turn, and so
// does the spin of a body that keeps its angular momentum.
Real JointSolve::drifting(const Joints& joints, const Bodies& bodies, const SolverBodies& on, Real h) const {
  const auto end = [&](std::uint32_t slot, std::uint32_t number, Real time) {
    return slot == no_body ? Ahead{} : ahead(bodies, slot, on[number], time);
  };
  const auto rate_after = [&](Real time) {
    const Ahead on_a = end(joints.a[joint_], a, time), on_b = end(joints.b[joint_], b, time);
    const Row row = rows_of(joints, {on_a.center, on_b.center}, joint_).rate;
    return dot(row.linear_a, vector(on[a].real.v)) - dot(row.linear_b, vector(on[b].real.v)) +
           dot(row.angular_a, on_a.spin) - dot(row.angular_b, on_b.spin);
  };
  return rate_after(h) - rate_after(0);
}

void JointSolve::prepare_coordinate(Joints& joints, const Bodies& bodies, const JointRows& demands,
                                    const SolverBodies& on, Real h) {
  const JointImpulse& stored = joints.impulse[joint_];
  Real& coordinate = joints.coordinate[joint_];
  const Real mass = 1 / response(coordinate_, coordinate_);
  coordinate = unwind(coordinate, demands.value, demands.period);
  const auto bound = [&](BoundedRow& row, Real impulse, Real low, Real high) {
    row.present = true;
    row.mass = mass;
    row.impulse = clamp(impulse, low, high), row.low = low, row.high = high;
  };
  constexpr Real infinity = std::numeric_limits<Real>::infinity();
  const Limit& limit = joints.limit[joint_];
  const Real below = limit.low - coordinate, above = coordinate - limit.high;  // positive: beyond the limit
  if (limit.low > -infinity) {
    bound(low_, stored.low, 0, infinity);
    low_.target = min(Real(0), below / h);
    low_.excess = max(Real(0), below);
  }
  if (limit.high < infinity) {
    bound(high_, stored.high, -infinity, 0);
    high_.target = max(Real(0), -above / h);
    high_.excess = -max(Real(0), above);
  }
  if (low_.present || high_.present) {
    const Real reach = Real(0.01) + 4 * h * abs(rate(on));
    near_limit_ = max(below, above) > -reach;
  }
  const Drive* drive = drive_of(joints.definition[joint_]);
  if (drive == nullptr || drive->mode == DriveMode::off || !(drive->force > 0)) return;
  bound(drive_, stored.drive, -drive->force * h, drive->force * h);
  switch (drive->mode) {
    case DriveMode::off: break;
    case DriveMode::speed: drive_.target = drive->target; break;
    case DriveMode::servo: break;  // see drives.h
    case DriveMode::spring: {
      // λ = h (k (target − x − h u) + c (rate − u)) − armature (u + drifting − u₀), with u₀ as the sub-step begins,
      // solved for u.
      const Real stiff = h * drive->stiffness, resistance = h * (stiff + drive->damping) + drive->armature;
      drive_.softness = resistance > 0 ? 1 / resistance : Real(0);
      drive_.target = drive_.softness * stiff * (drive->target - coordinate) +
                      drive_.softness * (h * drive->damping * drive->rate);
      if (drive->armature > 0)
        drive_.target += drive_.softness * drive->armature * (rate(on) - drifting(joints, bodies, on, h));
      drive_.present = resistance > 0;
      break;
    }
  }
}

void JointSolve::prepare_visits(const JointPull& pull) {
  pull_ = pull;
  for (std::size_t r = 0; r < std::size_t(count_); ++r) {
    for (std::size_t s = 0; s <= r; ++s) block_[r * 6 + s] = response(rows_[r], rows_[s]);
  }
  factor_small(block_.data(), 6, count_, sizeof(Real) == 4 ? Real(1e-6) : Real(1e-12));
}

template <class Apply>
Real JointSolve::solve_block(Real pull, const Moving& on_a, const Moving& on_b, Apply apply) {
  std::array<Real, 6> x{};
  Real largest = 0;
  const auto solve = [&]<int n>(std::integral_constant<int, n>) {
    for (std::size_t r = 0; r < std::size_t(n); ++r) {
      x[r] = -rows_[r].speed(on_a, on_b) - pull * rows_[r].error;
      largest = max(largest, abs(x[r]));
    }
    solve_lower(block_.data(), 6, n, x.data());
    solve_diagonal(block_.data(), 6, n, x.data());
    solve_upper(block_.data(), 6, n, x.data());
    for (std::size_t r = 0; r < std::size_t(n); ++r) apply(r, x[r]);
  };
  switch (count_) {
    case 1:
      solve(std::integral_constant<int, 1>{});
      break;
    case 3:
      solve(std::integral_constant<int, 3>{});
      break;
    case 5:
      solve(std::integral_constant<int, 5>{});
      break;
    case 6:
      solve(std::integral_constant<int, 6>{});
      break;
    default:
      break;
  }
  return largest;
}

void JointSolve::stop(SolverBodies& on) {
  Moving on_a = on[a].real, on_b = on[b].real;
  solve_block(0, on_a, on_b, [&](std::size_t r, Real impulse) {
    rows_[r].apply(on_a, on_b, impulse);
    struck_[r] += impulse;
  });
  for (BoundedRow* row : {&low_, &high_}) {
    if (!row->present) continue;
    const Real impulse = (row->target - coordinate_.speed(on_a, on_b)) * row->mass;
    if (!(impulse > row->low && impulse < row->high)) continue;
    coordinate_.apply(on_a, on_b, impulse);
    struck_limit_ += impulse;
  }
  put(on, &SolverBody::real, on_a, on_b);
}

void JointSolve::warm_start(SolverBodies& on) const {
  Moving on_a = on[a].real, on_b = on[b].real;
  for (std::size_t r = 0; r < std::size_t(count_); ++r) rows_[r].apply(on_a, on_b, impulse_[r]);
  for (const BoundedRow* row : {&low_, &high_, &drive_}) {
    if (row->present) coordinate_.apply(on_a, on_b, row->impulse);
  }
  put(on, &SolverBody::real, on_a, on_b);
}

void JointSolve::set_response(Real inverse_mass, std::span<const Carried> carried) {
  drive_.mass = 1 / (inverse_mass + drive_.softness);
  carried_ = carried;
}

void JointSolve::apply_drive(SolverBodies& on, Real impulse) const {
  Moving on_a = on[a].real, on_b = on[b].real;
  coordinate_.apply(on_a, on_b, impulse);
  put(on, &SolverBody::real, on_a, on_b);
}

// The drive moves all that hangs on it at once; else a servo far from what it moves would not be felt there.
Real JointSolve::hold_drive(SolverBodies& on) {
  if (!drive_.present) return 0;
  const Real left = drive_.target - rate(on) - drive_.softness * drive_.impulse;
  const Real total = clamp(drive_.impulse + left * drive_.mass, drive_.low, drive_.high), more = total - drive_.impulse;
  drive_.impulse = total;
  if (more == 0) return 0;
  apply_drive(on, more);
  for (const Carried& c : carried_) c.joint->apply(on, c.impulse, more);
  return abs(more) / drive_.mass;
}

Real JointSolve::hold(SolverBodies& on) {
  Real change = hold_drive(on);
  Moving on_a = on[a].real, on_b = on[b].real;
  for (BoundedRow* row : {&low_, &high_}) {
    if (!row->present) continue;
    const Real left = row->target - coordinate_.speed(on_a, on_b);
    const Real total = clamp(row->impulse + left * row->mass, row->low, row->high);
    coordinate_.apply(on_a, on_b, total - row->impulse);
    change = max(change, abs(total - row->impulse) / row->mass);
    row->impulse = total;
  }
  const Real block =
      solve_block(pull_.in_velocity ? pull_.rate : Real(0), on_a, on_b, [&](std::size_t r, Real impulse) {
        rows_[r].apply(on_a, on_b, impulse);
        impulse_[r] += impulse;
      });
  put(on, &SolverBody::real, on_a, on_b);
  return max(change, block);
}

Real JointSolve::push(SolverBodies& on) {
  Moving on_a = on[a].push, on_b = on[b].push;
  Real change = 0;
  for (BoundedRow* row : {&low_, &high_}) {
    if (!row->present || row->excess == 0) continue;
    const Real left = pull_.rate * row->excess - coordinate_.speed(on_a, on_b);
    const Real total = clamp(row->push + left * row->mass, row->low, row->high);
    coordinate_.apply(on_a, on_b, total - row->push);
    change = max(change, abs(total - row->push) / row->mass);
    row->push = total;
  }
  if (!pull_.in_velocity) {
    change = max(change, solve_block(pull_.rate, on_a, on_b,
                                     [&](std::size_t r, Real impulse) { rows_[r].apply(on_a, on_b, impulse); }));
  }
  put(on, &SolverBody::push, on_a, on_b);
  return change;
}

void JointSolve::apply(SolverBodies& on, const std::array<Real, 6>& impulse, Real share) {
  Moving on_a = on[a].real, on_b = on[b].real;
  for (std::size_t r = 0; r < std::size_t(count_); ++r) {
    rows_[r].apply(on_a, on_b, impulse[r] * share);
    impulse_[r] += impulse[r] * share;
  }
  put(on, &SolverBody::real, on_a, on_b);
}

void JointSolve::store(Joints& joints) const {
  joints.impulse[joint_] = {impulse_, low_.impulse, high_.impulse, drive_.impulse, struck_, struck_limit_};
}

}
