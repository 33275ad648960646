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

JointSolve::JointSolve(Joints& joints, const Bodies& bodies, std::uint32_t joint, const SolverBody& on_a,
                       const SolverBody& on_b, Real h, const JointPull& pull)
    : a(joints.a[joint]), b(joints.b[joint]), joint_(joint), pull_(pull), impulse_(joints.impulse[joint].rows) {
  const JointRows demands = rows_of(joints, bodies, joint);
  count_ = demands.count;
  std::array<std::array<Real, 6>, 6> k{};
  for (std::size_t r = 0; r < std::size_t(count_); ++r) {
    static_cast<Row&>(rows_[r]) = demands.rows[r];
    rows_[r].prepare(on_a, on_b);
    bias_[r] = pull.rate * rows_[r].error;
    for (std::size_t s = 0; s <= r; ++s) k[r][s] = response(rows_[r], rows_[s], on_a, on_b);
  }
  block_.factor(k, count_);
  if (demands.free) prepare_coordinate(joints, demands, on_a, on_b, h);
}

void JointSolve::prepare_coordinate(Joints& joints, const JointRows& demands, const SolverBody& on_a,
                                    const SolverBody& on_b, Real h) {
  const JointImpulse& stored = joints.impulse[joint_];
  Real& coordinate = joints.coordinate[joint_];
  coordinate = demands.angle ? unwind(coordinate, demands.value) : demands.value;
  const auto bound = [&](BoundedRow& row, Real impulse, Real low, Real high) {
    static_cast<Row&>(row.row) = demands.rate;
    row.row.prepare(on_a, on_b);
    row.present = true;
    row.mass = 1 / response(row.row, row.row, on_a, on_b);
    row.impulse = clamp(impulse, low, high), row.low = low, row.high = high;
  };
  constexpr Real infinity = std::numeric_limits<Real>::infinity();
  const Limit& limit = joints.limit[joint_];
  const Real below = limit.low - coordinate, above = coordinate - limit.high;  // positive: beyond the limit
  if (limit.low > -infinity) {
    bound(low_, stored.low, 0, infinity);
    low_.target = min(Real(0), below / h);
    low_.push_target = pull_.rate * max(Real(0), below);
  }
  if (limit.high < infinity) {
    bound(high_, stored.high, -infinity, 0);
    high_.target = max(Real(0), -above / h);
    high_.push_target = -pull_.rate * max(Real(0), above);
  }
  const Drive* drive = drive_of(joints.definition[joint_]);
  if (drive == nullptr || drive->mode == DriveMode::off || !(drive->force > 0)) return;
  bound(drive_, stored.drive, -drive->force * h, drive->force * h);
  drive_.target = drive->mode == DriveMode::speed ? drive->target : servo_speed(*drive, coordinate, drive_.mass, h);
}

template <class Speed, class Apply>
Real JointSolve::solve_block(bool pull, Speed speed, Apply apply) {
  std::array<Real, 6> x{};
  Real largest = 0;
  const auto solve = [&]<int n>(std::integral_constant<int, n>) {
    for (std::size_t r = 0; r < std::size_t(n); ++r) {
      x[r] = -speed(rows_[r]) - (pull ? bias_[r] : Real(0));
      largest = max(largest, abs(x[r]));
    }
    block_.solve<n>(x);
    for (std::size_t r = 0; r < std::size_t(n); ++r) apply(r, x[r]);
  };
  switch (count_) {
    case 1: solve(std::integral_constant<int, 1>{}); break;
    case 3: solve(std::integral_constant<int, 3>{}); break;
    case 5: solve(std::integral_constant<int, 5>{}); break;
    case 6: solve(std::integral_constant<int, 6>{}); break;
    default: break;
  }
  return largest;
}

void JointSolve::stop(SolverBody& on_a, SolverBody& on_b) {
  solve_block(false, [&](const PreparedRow& row) { return row.speed(on_a, on_b); },
              [&](std::size_t r, Real impulse) {
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
}

void JointSolve::warm_start(SolverBody& on_a, SolverBody& on_b) const {
  for (std::size_t r = 0; r < std::size_t(count_); ++r) rows_[r].apply(on_a, on_b, impulse_[r]);
  for (const BoundedRow* row : {&low_, &high_, &drive_}) {
    if (row->present) row->row.apply(on_a, on_b, row->impulse);
  }
}

Real JointSolve::hold(SolverBody& on_a, SolverBody& on_b) {
  Real change = 0;
  for (BoundedRow* row : {&drive_, &low_, &high_}) {
    if (!row->present) continue;
    const Real left = row->target - row->row.speed(on_a, on_b);
    const Real total = clamp(row->impulse + left * row->mass, row->low, row->high);
    row->row.apply(on_a, on_b, total - row->impulse);
    change = max(change, abs(total - row->impulse) / row->mass);
    row->impulse = total;
  }
  const Real block = solve_block(pull_.in_velocity, [&](const PreparedRow& row) { return row.speed(on_a, on_b); },
                                 [&](std::size_t r, Real impulse) {
                                   rows_[r].apply(on_a, on_b, impulse);
                                   impulse_[r] += impulse;
                                 });
  return max(change, block);
}

Real JointSolve::push(SolverBody& on_a, SolverBody& on_b) {
  Real change = 0;
  for (BoundedRow* row : {&low_, &high_}) {
    if (!row->present || row->push_target == 0) continue;
    const Real left = row->push_target - row->row.push_speed(on_a, on_b);
    const Real total = clamp(row->push + left * row->mass, row->low, row->high);
    row->row.apply_push(on_a, on_b, total - row->push);
    change = max(change, abs(total - row->push) / row->mass);
    row->push = total;
  }
  if (pull_.in_velocity) return change;
  const Real block = solve_block(true, [&](const PreparedRow& row) { return row.push_speed(on_a, on_b); },
                                 [&](std::size_t r, Real impulse) { rows_[r].apply_push(on_a, on_b, impulse); });
  return max(change, block);
}

void JointSolve::store(Joints& joints) const {
  joints.impulse[joint_] = {impulse_, low_.impulse, high_.impulse, drive_.impulse, struck_, struck_limit_};
}

}
