#include "dynamics/joint_solve.h"

namespace sudar::inline SUDAR_PRECISION {

namespace {

// The fastest approach from which the drive's force still stops at the target, in steps of h: v²/2a + vh/2 = distance.
Real servo_speed(const Drive& drive, Real coordinate, Real mass, Real h) {
  const Real way = drive.target - coordinate, distance = abs(way);
  const Real acceleration = drive.force / mass, half = acceleration * h * Real(0.5);
  const Real stoppable = sqrt(square(half) + 2 * acceleration * distance) - half;
  const Real speed = min(min(stoppable, distance / h), drive.max_speed);
  return way < 0 ? -speed : speed;
}

}

JointSolve::JointSolve(Joints& joints, const Bodies& bodies, std::uint32_t joint, const SolverBodies& on, Real h)
    : a(joints.a[joint]), b(joints.b[joint]), joint_(joint), impulse_(joints.impulse[joint].rows) {
  const JointRows demands = rows_of(joints, bodies, joint);
  set_rows(demands, on);
  if (demands.free) prepare_coordinate(joints, demands, on, h);
}

void JointSolve::set_rows(const JointRows& demands, const SolverBodies& on) {
  count_ = demands.count;
  for (std::size_t r = 0; r < std::size_t(count_); ++r) rows_[r] = {demands.rows[r], on[a], on[b]};
}

void JointSolve::renew_rows(const Joints& joints, const Bodies& bodies, const SolverBodies& on) {
  set_rows(rows_of(joints, bodies, joint_), on);
}

Real JointSolve::error() const {
  Real largest = 0;
  for (const PreparedRow& row : rows()) largest = max(largest, abs(row.error));
  return largest;
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

bool JointSolve::bounded() const { return drive_.present || near_limit_; }

void JointSolve::prepare_coordinate(Joints& joints, const JointRows& demands, const SolverBodies& on, Real h) {
  const JointImpulse& stored = joints.impulse[joint_];
  Real& coordinate = joints.coordinate[joint_];
  coordinate = unwind(coordinate, demands.value, demands.period);
  const auto bound = [&](BoundedRow& row, Real impulse, Real low, Real high) {
    row.row = {demands.rate, on[a], on[b]};
    row.present = has_bounds_ = true;
    row.mass = 1 / response(row.row, row.row);
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
    const BoundedRow& either = low_.present ? low_ : high_;
    const Real reach = Real(0.01) + 4 * h * abs(either.row.speed(on[a].real, on[b].real));
    near_limit_ = max(below, above) > -reach;
  }
  const Drive* drive = drive_of(joints.definition[joint_]);
  if (drive == nullptr || drive->mode == DriveMode::off || !(drive->force > 0)) return;
  bound(drive_, stored.drive, -drive->force * h, drive->force * h);
  switch (drive->mode) {
    case DriveMode::off: break;
    case DriveMode::speed: drive_.target = drive->target; break;
    case DriveMode::servo: drive_.target = servo_speed(*drive, coordinate, drive_.mass, h); break;
    case DriveMode::spring: {
      // λ = h (k (target − x − h u) − c u), solved for u.
      const Real stiff = h * drive->stiffness, resistance = h * (stiff + drive->damping);
      drive_.softness = resistance > 0 ? 1 / resistance : Real(0);
      drive_.target = drive_.softness * stiff * (drive->target - coordinate);
      drive_.mass = 1 / (1 / drive_.mass + drive_.softness);
      if (!(resistance > 0)) drive_.present = false;
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

template <class Visit>
void JointSolve::each_bound(Visit visit) {
  if (!has_bounds_) return;
  for (BoundedRow* row : {&drive_, &low_, &high_}) {
    if (row->present) visit(*row);
  }
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
    const Real impulse = (row->target - row->row.speed(on_a, on_b)) * row->mass;
    if (!(impulse > row->low && impulse < row->high)) continue;
    row->row.apply(on_a, on_b, impulse);
    struck_limit_ += impulse;
  }
  on[a].real = on_a, on[b].real = on_b;
}

void JointSolve::warm_start(SolverBodies& on) const {
  Moving &on_a = on[a].real, &on_b = on[b].real;
  for (std::size_t r = 0; r < std::size_t(count_); ++r) rows_[r].apply(on_a, on_b, impulse_[r]);
  for (const BoundedRow* row : {&low_, &high_, &drive_}) {
    if (row->present) row->row.apply(on_a, on_b, row->impulse);
  }
}

Real JointSolve::hold(SolverBodies& on) {
  Moving on_a = on[a].real, on_b = on[b].real;
  Real change = 0;
  each_bound([&](BoundedRow& row) {
    const Real left = row.target - row.row.speed(on_a, on_b) - row.softness * row.impulse;
    const Real total = clamp(row.impulse + left * row.mass, row.low, row.high);
    row.row.apply(on_a, on_b, total - row.impulse);
    change = max(change, abs(total - row.impulse) / row.mass);
    row.impulse = total;
  });
  const Real block =
      solve_block(pull_.in_velocity ? pull_.rate : Real(0), on_a, on_b, [&](std::size_t r, Real impulse) {
        rows_[r].apply(on_a, on_b, impulse);
        impulse_[r] += impulse;
      });
  on[a].real = on_a, on[b].real = on_b;
  return max(change, block);
}

Real JointSolve::push(SolverBodies& on) {
  Moving on_a = on[a].push, on_b = on[b].push;
  Real change = 0;
  each_bound([&](BoundedRow& row) {
    if (row.excess == 0) return;
    const Real left = pull_.rate * row.excess - row.row.speed(on_a, on_b);
    const Real total = clamp(row.push + left * row.mass, row.low, row.high);
    row.row.apply(on_a, on_b, total - row.push);
    change = max(change, abs(total - row.push) / row.mass);
    row.push = total;
  });
  if (!pull_.in_velocity) {
    change = max(change, solve_block(pull_.rate, on_a, on_b,
                                     [&](std::size_t r, Real impulse) { rows_[r].apply(on_a, on_b, impulse); }));
  }
  on[a].push = on_a, on[b].push = on_b;
  return change;
}

void JointSolve::apply(SolverBodies& on, const std::array<Real, 6>& impulse) {
  for (std::size_t r = 0; r < std::size_t(count_); ++r) {
    rows_[r].apply(on[a].real, on[b].real, impulse[r]);
    impulse_[r] += impulse[r];
  }
}

void JointSolve::store(Joints& joints) const {
  joints.impulse[joint_] = {impulse_, low_.impulse, high_.impulse, drive_.impulse, struck_, struck_limit_};
}

}
