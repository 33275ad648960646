#include "dynamics/impulse_2007.h"

#include <algorithm>

#include "base/timer.h"
#include "dynamics/integrate.h"
#include "math/lanes.h"

namespace sudar::inline SUDAR_PRECISION {

namespace {

// One contact point. Velocities and impulses are in the contact's frame: x along the normal from b to a, y and z
// tangential. Impulses act on a; b gets the opposite.
struct PointRow {
  Mat3Lanes arm_a, arm_b;      // ω → velocity of the point in the contact's frame
  Mat3Lanes turn_a, turn_b;    // I⁻¹ armᵀ: impulse → change of ω
  Vec3 impulse;                // accumulated, N s
  Real normal_mass;            // 1 / nᵀKn
  Real tangent_mass;           // 1 / the larger eigenvalue of K in the tangent plane: one number for both directions,
                               // because unequal ones would bend the direction of friction
  Real slide_y, slide_z;       // tangent_mass · Kn: friction that answers a unit normal impulse
  Real target;                 // u_n that the contact passes aim at
  // used once a sub-step
  Real free_speed;             // min(0, depth/h): approach that closes the gap exactly is allowed
  Real start;                  // u_n before collisions, m/s
  Real push = 0;               // accumulated, pseudo
  Real push_target = 0;        // pseudo speed apart, m/s
  Vec3 ra, rb;                 // from the centres of mass, world axes, m
  bool hit = false;            // took part in a collision
};

struct ManifoldRow {
  Mat3Lanes to_frame;          // world → contact's frame
  Mat3Lanes mass_a, mass_b;    // impulse in the contact's frame → change of v: 1/m times the frame
  std::uint32_t a, b, contact;
  std::uint32_t count;
  Real friction;               // static or dynamic, chosen once a sub-step
  Mat3 frame;                  // columns: normal from b to a, two tangents
  PairMaterial material;
  std::array<PointRow, 4> points;
  std::span<PointRow> rows() { return std::span(points).first(count); }
  std::span<const PointRow> rows() const { return std::span(points).first(count); }
};

// A body's velocities while a manifold is worked on, in registers.
struct Moving {
  Real4 v, w;
  explicit Moving(const SolverBody& b) : v(lanes(b.v)), w(lanes(b.w)) {}
  void store(SolverBody& b) const { b.v = vector(v), b.w = vector(w); }
};

// A limit's end or a drive: one row with bounds.
struct BoundedRow {
  PreparedRow row;
  Real mass = 0, impulse = 0, low = 0, high = 0;  // impulse within low…high
  Real target = 0;                                // rate that it aims at
  Real push = 0, push_target = 0;
};

struct JointSolve {
  std::uint32_t joint, a, b;
  int count;                                      // rows of the block
  std::array<PreparedRow, 6> rows;
  SmallSystem block;
  std::array<Real, 6> impulse{}, bias{};          // bias: rate that pulls the position back
  BoundedRow low, high, drive;
  bool has_low = false, has_high = false, has_drive = false;
};

// u in the contact's frame.
Real4 relative_velocity(const Moving& a, const Moving& b, const ManifoldRow& m, const PointRow& p) {
  return m.to_frame * (a.v - b.v) + (p.arm_a * a.w - p.arm_b * b.w);
}

void apply(Moving& a, Moving& b, const ManifoldRow& m, const PointRow& p, const Vec3& impulse) {
  const Real4 step = lanes(impulse);
  a.v += m.mass_a * step;
  a.w += p.turn_a * step;
  b.v -= m.mass_b * step;
  b.w -= p.turn_b * step;
}

Real slide(const Vec3& u) { return sqrt(square(u.y) + square(u.z)); }  // the tangential part's length

class SubStep {
 public:
  SubStep(const SolveInput& input, Bodies& bodies, Joints& joints, Contacts& contacts, SolveReport& report)
      : in_(input), set_(input.config.impulse_2007), bodies_(bodies), joints_(joints), contacts_(contacts),
        report_(report), h_(input.h), g_(length(gravity(input.forces))) {}

  void run() {
    gather();
    for (const ActiveContact& c : in_.contacts) prepare(c);
    for (const std::uint32_t j : in_.joints) prepare(j);
    Timer timer;
    collide();
    report_.passes_microseconds += timer.microseconds();
    aim();
    accelerate_all();
    timer = {};
    hold();
    report_.passes_microseconds += timer.microseconds();
    store();
    move();
  }

 private:
  static constexpr std::uint32_t world = 0;  // solver body 0 stands for the world; slot i is solver body i + 1
  SolverBody& body(std::uint32_t slot) { return solver_[slot == no_body ? world : slot + 1]; }

  void gather() {
    solver_.assign(bodies_.size() + 1, {});
    for (const std::uint32_t i : in_.awake) {
      SolverBody& s = body(i);
      s.v = bodies_.velocity[i];
      s.w = spin_of(bodies_, i);
      s.inverse_mass = bodies_.inverse_mass[i];
      s.inverse_inertia = bodies_.inverse_inertia_world(i);
    }
    for (const std::uint32_t i : in_.kinematic) body(i).v = bodies_.velocity[i], body(i).w = bodies_.spin[i];
    before_.resize(in_.awake.size());
    for (std::size_t k = 0; k < in_.awake.size(); ++k) before_[k] = body(in_.awake[k]).w;
  }

  // --- preparation ---

  void prepare(const ActiveContact& c) {
    const Manifold manifold = set_.one_point_contact ? centre(*c.manifold) : *c.manifold;
    ManifoldRow m;
    m.a = c.a, m.b = c.b;
    m.contact = std::uint32_t(&c - in_.contacts.data());
    m.count = std::uint32_t(manifold.count);
    m.material = c.material;
    const Vec3 n = manifold.normal, t = any_perpendicular(n);
    m.frame = {n, t, cross(n, t)};
    const Mat3 to_frame = transpose(m.frame);
    const SolverBody &a = body(c.a), &b = body(c.b);
    m.to_frame = lanes(to_frame);
    m.mass_a = lanes(m.frame * a.inverse_mass);
    m.mass_b = lanes(m.frame * b.inverse_mass);
    const Vec3 to_shape = rotate(bodies_.orientation[c.a], bodies_.shape_frame[c.a].p);
    const Vec3 apart = bodies_.position[c.a] - bodies_.position[c.b];
    for (std::size_t k = 0; k < m.count; ++k) {
      const ManifoldPoint& from = manifold.points[k];
      PointRow& p = m.points[k];
      p.ra = from.at + to_shape;
      p.rb = p.ra + apart;
      const Mat3 arm_a = to_frame * Mat3::skew(-p.ra), arm_b = to_frame * Mat3::skew(-p.rb);
      const Mat3 turn_a = a.inverse_inertia * transpose(arm_a), turn_b = b.inverse_inertia * transpose(arm_b);
      // (4.8) K = (1/m_a + 1/m_b) E − r̃_a I_a⁻¹ r̃_a − r̃_b I_b⁻¹ r̃_b, in the contact's frame
      const Real inverse_mass = a.inverse_mass + b.inverse_mass;
      masses(p, Mat3::diagonal({inverse_mass, inverse_mass, inverse_mass}) + arm_a * turn_a + arm_b * turn_b);
      p.arm_a = lanes(arm_a), p.arm_b = lanes(arm_b);
      p.turn_a = lanes(turn_a), p.turn_b = lanes(turn_b);
      const Real depth = -from.separation;
      p.free_speed = min(Real(0), depth / h_);
      p.start = relative_velocity(Moving(a), Moving(b), m, p)[0];
      fastest_ = max(fastest_, -p.start);
      p.push_target = set_.correction / h_ * max(Real(0), depth - slop());  // (4.14): a speed, not an impulse
      if (set_.one_point_contact || from.match >= 0) {
        // The impulse of the last sub-step, point by feature; friction turned into the new tangent plane.
        const ContactImpulse& stored = contacts_.impulse[c.slot];
        const std::size_t old = set_.one_point_contact ? 0 : std::size_t(from.match);
        p.impulse = to_frame * stored.friction[old];
        p.impulse.x = stored.normal[old];
      }
    }
    manifolds_.push_back(m);
  }

  static void masses(PointRow& p, const Mat3& k) {
    const Real mean = (k.c1.y + k.c2.z) * Real(0.5);
    p.normal_mass = 1 / k.c0.x;
    p.tangent_mass = 1 / (mean + sqrt(square((k.c1.y - k.c2.z) * Real(0.5)) + square(k.c1.z)));
    p.slide_y = p.tangent_mass * k.c0.y;
    p.slide_z = p.tangent_mass * k.c0.z;
  }

  // The thesis's contact: one point, the centre of the overlap. It carries no moment, so no tower stands on it.
  static Manifold centre(const Manifold& m) {
    Manifold one;
    one.normal = m.normal;
    one.count = 1;
    one.points[0].separation = m.points[0].separation;
    for (int k = 0; k < m.count; ++k) {
      one.points[0].at += m.points[std::size_t(k)].at / Real(m.count);
      one.points[0].separation = min(one.points[0].separation, m.points[std::size_t(k)].separation);
    }
    return one;
  }

  void prepare(std::uint32_t joint) {
    JointSolve j;
    j.joint = joint;
    j.a = joints_.a[joint], j.b = joints_.b[joint];
    const SolverBody &a = body(j.a), &b = body(j.b);
    const JointRows demands = rows_of(joints_, bodies_, joint);
    const JointImpulse& stored = joints_.impulse[joint];
    j.count = demands.count;
    std::array<std::array<Real, 6>, 6> k{};
    for (std::size_t r = 0; r < std::size_t(j.count); ++r) {
      static_cast<Row&>(j.rows[r]) = demands.rows[r];
      j.rows[r].prepare(a, b);
      j.bias[r] = set_.joint_correction / h_ * j.rows[r].error;
      for (std::size_t s = 0; s <= r; ++s) k[r][s] = response(j.rows[r], j.rows[s], a, b);
    }
    j.block.factor(k, j.count);
    j.impulse = stored.rows;
    if (demands.free) prepare_coordinate(j, demands, stored);
    joints_in_step_.push_back(j);
  }

  void prepare_coordinate(JointSolve& j, const JointRows& demands, const JointImpulse& stored) {
    const SolverBody &a = body(j.a), &b = body(j.b);
    Real& coordinate = joints_.coordinate[j.joint];
    coordinate = demands.angle ? unwind(coordinate, demands.value) : demands.value;
    const auto bounded = [&](BoundedRow& row, Real impulse, Real low, Real high) {
      static_cast<Row&>(row.row) = demands.rate;
      row.row.prepare(a, b);
      row.mass = 1 / response(row.row, row.row, a, b);
      row.impulse = impulse, row.low = low, row.high = high;
    };
    constexpr Real infinity = std::numeric_limits<Real>::infinity();
    const Limit& limit = joints_.limit[j.joint];
    const Real below = limit.low - coordinate, above = coordinate - limit.high;  // positive: beyond the limit
    if ((j.has_low = limit.low > -infinity)) {
      bounded(j.low, stored.low, 0, infinity);
      j.low.target = min(Real(0), below / h_);
      j.low.push_target = set_.joint_correction / h_ * max(Real(0), below);
    }
    if ((j.has_high = limit.high < infinity)) {
      bounded(j.high, stored.high, -infinity, 0);
      j.high.target = max(Real(0), -above / h_);
      j.high.push_target = -set_.joint_correction / h_ * max(Real(0), above);
    }
    const Drive* drive = drive_of(joints_.definition[j.joint]);
    if ((j.has_drive = drive != nullptr && drive->mode != DriveMode::off && drive->force > 0)) {
      bounded(j.drive, stored.drive, -drive->force * h_, drive->force * h_);
      j.drive.impulse = clamp(j.drive.impulse, j.drive.low, j.drive.high);
      j.drive.target = drive->mode == DriveMode::speed ? drive->target : servo_speed(*drive, coordinate, j.drive.mass);
    }
  }

  // The fastest approach from which the drive's force still stops at the target, in steps of h: v²/2a + vh/2 = distance.
  Real servo_speed(const Drive& drive, Real coordinate, Real mass) const {
    const Real way = drive.target - coordinate;
    const Real gain = drive.force / mass * h_;  // largest change of speed in a step
    const Real half = gain * Real(0.5), distance = abs(way);
    const Real speed = min(min(sqrt(square(half) + 2 * gain / h_ * distance) - half, distance / h_), drive.max_speed);
    return way < 0 ? -speed : speed;
  }

  Real slop() const { return set_.slop * in_.config.length_unit; }
  Real stick_speed() const { return Real(0.1) * g_ * h_; }

  // --- collisions: thesis (4.9)–(4.11) ---

  // Passes until no manifold approaches. Nothing is warm-started and nothing is kept: an impact is over at once.
  void collide() {
    // Approach slower than a hundredth of gravity's share in a step is what turning arms and the last contact passes left
    // over: the coming contact passes mend it, no impact does.
    least_ = Real(0.01) * g_ * h_ + Real(1e-6) * fastest_;
    for (int pass = 0; pass < set_.collision_passes; ++pass) {
      for (JointSolve& j : joints_in_step_) stop(j);
      bool approaching = false;
      for (ManifoldRow& m : manifolds_) {
        const Moving a(body(m.a)), b(body(m.b));
        bool approaches = false;
        for (const PointRow& p : m.rows()) approaches |= relative_velocity(a, b, m, p)[0] < p.free_speed - least_;
        if (!approaches) continue;
        approaching = true;
        if (set_.friction_per_increment) strike_as_written(m);
        else strike(m);
      }
      if (!approaching) break;
      ++report_.collision_passes;
    }
  }

  // A joint's whole relative velocity vanishes in an impact: p = K⁻¹(−u), (4.21).
  void stop(JointSolve& j) {
    SolverBody &a = body(j.a), &b = body(j.b);
    solve_block(j, a, b, false, nullptr);
    for (BoundedRow* row : {j.has_low ? &j.low : nullptr, j.has_high ? &j.high : nullptr}) {
      if (row == nullptr) continue;
      const Real impulse = (row->target - row->row.speed(a, b)) * row->mass;
      if (impulse > row->low && impulse < row->high) row->row.apply(a, b, impulse);
    }
  }

  // One impact of a manifold: all its points at once, with accumulated impulses that live in this visit only.
  void strike(ManifoldRow& m) {
    const Moving a0(body(m.a)), b0(body(m.b));
    Moving a = a0, b = b0;
    const auto again = [&](Real restitution, Real friction) {
      a = a0, b = b0;
      return impact(m, a, b, restitution, friction);
    };
    // It sticks if it can: only when the static cone does not hold does it slip, under dynamic friction.
    Real friction = m.material.friction_static;
    Impact outcome = again(m.material.restitution, friction);
    if (outcome.slips && m.material.friction_dynamic != friction) {
      friction = m.material.friction_dynamic;
      outcome = again(m.material.restitution, friction);
    }
    if (outcome.made_energy) outcome = again(0, friction);  // friction made energy: take the bounce away instead
    a.store(body(m.a)), b.store(body(m.b));
  }

  struct Impact {
    bool slips = false, made_energy = false;
  };
  Impact impact(ManifoldRow& m, Moving& a, Moving& b, Real restitution, Real friction) {
    std::array<Real, 4> aim{};
    std::array<Vec3, 4> impulse{}, before{};
    for (std::size_t k = 0; k < m.count; ++k) {
      const PointRow& p = m.points[k];
      before[k] = vector(relative_velocity(a, b, m, p));
      const Real un = before[k].x;
      aim[k] = un < p.free_speed ? -restitution * un : p.free_speed;
    }
    constexpr int most = 60;
    for (int repeat = 0; repeat < most; ++repeat) {
      Real change = 0;
      for (std::size_t k = 0; k < m.count; ++k) {
        const PointRow& p = m.points[k];
        const Vec3 step = answer(p, relative_velocity(a, b, m, p), aim[k], 1, friction, impulse[k]);
        apply(a, b, m, p, step);
        change = max(change, size(p, step, 1));
      }
      report_.point_passes += m.count;
      if (change <= Real(0.1) * least_) break;
    }
    Impact outcome;
    Real work = 0, scale_of_work = 0;  // ½ Σ p·(u⁻ + u⁺), and its size without cancellation
    for (std::size_t k = 0; k < m.count; ++k) {
      PointRow& p = m.points[k];
      work += dot(impulse[k], before[k] + vector(relative_velocity(a, b, m, p))) * Real(0.5);
      scale_of_work += abs(dot(impulse[k], before[k]));
      p.hit |= impulse[k].x > 0;
    }
    outcome.slips = slips(std::span<const Vec3>(impulse).first(m.count), friction);
    outcome.made_energy = work > Real(1e-5) * scale_of_work;
    return outcome;
  }

  // One visit of a point whose relative velocity is u: the accumulated impulse goes where u_n would be `target`, by the
  // share `relaxation` of the way, and where it would not slide, both as far as a contact can push and hold. Written so
  // that little waits for something else: each point waits for the one before.
  static Vec3 answer(const PointRow& p, const Real4& u, Real target, Real relaxation, Real friction, Vec3& impulse) {
    const Real normal = max(-impulse.x, relaxation * p.normal_mass * (target - u[0]));
    Vec3 step{normal, -p.tangent_mass * u[1] - p.slide_y * normal, -p.tangent_mass * u[2] - p.slide_z * normal};
    Vec3 next = impulse + step;
    const Real most = friction * next.x, tangential = square(next.y) + square(next.z);
    if (tangential > square(most)) {
      const Real cut = most / sqrt(tangential);
      next.y *= cut, next.z *= cut;
      step = next - impulse;
    }
    impulse = next;
    return step;
  }
  // A step as the relative velocity that it answers, unrelaxed.
  static Real size(const PointRow& p, const Vec3& step, Real relaxation) {
    return max(abs(step.x) / (p.normal_mass * relaxation), max(abs(step.y), abs(step.z)) / p.tangent_mass);
  }

  // Whether the contact as a whole is at the edge of its cone: in sum, or (turning on the spot) in every loaded point.
  // One point at its edge says nothing: how the load is shared among points is not determined.
  static bool slips(std::span<const Vec3> impulses, Real coefficient) {
    const Real nearly = Real(0.999) * coefficient;
    Vec3 sum;
    bool everywhere = true;
    for (const Vec3& p : impulses) {
      sum += p;
      everywhere &= slide(p) >= nearly * p.x;
    }
    return sum.x > 0 && (everywhere || slide(sum) >= nearly * sum.x);
  }

  // Option friction_per_increment: (4.10), (4.11) as written, each increment against its own cone. It serves to show
  // what goes wrong: a train moves that static friction should hold.
  void strike_as_written(ManifoldRow& m) {
    for (PointRow& p : m.rows()) p.hit |= increment_as_written(m, p, m.material.restitution) > 0;
    report_.point_passes += m.count;
  }

  Real increment_as_written(const ManifoldRow& m, const PointRow& p, Real restitution) {
    Moving a(body(m.a)), b(body(m.b));
    const Vec3 u = vector(relative_velocity(a, b, m, p));
    if (u.x >= p.free_speed) return 0;
    const Mat3 k = matrix(m.to_frame) * (matrix(m.mass_a) + matrix(m.mass_b)) + matrix(p.arm_a) * matrix(p.turn_a) +
                   matrix(p.arm_b) * matrix(p.turn_b);
    Vec3 impulse = inverse(k) * (Vec3{-restitution * u.x, 0, 0} - u);                         // (4.10) sticking
    if (impulse.x < 0 || slide(impulse) > m.material.friction_static * impulse.x) {
      const Real fast = slide(u);
      const Real share = fast > 0 ? m.material.friction_dynamic / fast : Real(0);
      const Vec3 direction{1, -share * u.y, -share * u.z};
      const Real denominator = dot(k.c0, direction);
      if (denominator <= 0) return 0;                                                         // jamming
      impulse = direction * (-(1 + restitution) * u.x / denominator);                         // (4.11) with u_n, not Δu_n
    }
    apply(a, b, m, p, impulse);
    a.store(body(m.a)), b.store(body(m.b));
    return impulse.x;
  }

  // --- between collisions and contacts ---

  // Static or dynamic friction is decided once a sub-step, since a decision inside the passes flickers. Who stuck goes
  // on sticking until the static cone was reached; who slipped sticks again once it is slow. Speed alone must not decide:
  // the foot of a turning body seems to move by ω²rh, only because its arm turned during the last sub-step.
  Real choose_friction(const ManifoldRow& m) {
    const auto rows = m.rows();
    const bool held = std::any_of(rows.begin(), rows.end(), [](const PointRow& p) { return p.impulse.x > 0; });
    if (held && contacts_.slipping[in_.contacts[m.contact].slot] == 0) return m.material.friction_static;
    const Moving a(body(m.a)), b(body(m.b));
    Real fastest = 0;
    for (const PointRow& p : rows) fastest = max(fastest, slide(vector(relative_velocity(a, b, m, p))));
    return fastest <= stick_speed() ? m.material.friction_static : m.material.friction_dynamic;
  }

  // What the contact passes aim at. A bounce won in the collisions must not be eaten by this step's gravity.
  void aim() {
    for (ManifoldRow& m : manifolds_) {
      m.friction = choose_friction(m);
      const Moving a(body(m.a)), b(body(m.b));
      Real hardest = 0;
      const PointRow* where = nullptr;
      for (PointRow& p : m.rows()) {
        const Real bounce = -m.material.restitution * p.start;
        p.target = p.free_speed;
        if (p.hit && bounce > g_ * h_) p.target = min(Real(relative_velocity(a, b, m, p)[0]), bounce);
        if (p.hit && -p.start > hardest) hardest = -p.start, where = &p;
      }
      if (where != nullptr && hardest > 2 * g_ * h_) report_.hits.push_back({m.contact, where->ra, hardest});
    }
  }

  void accelerate_all() {
    std::vector<Wrench> load;
    evaluate(in_.forces, bodies_, in_.awake, bodies_.position, bodies_.orientation, load);
    for (const std::uint32_t i : in_.awake) {
      SolverBody& s = body(i);
      accelerate(bodies_, i, load[i], drag_on(in_.forces, bodies_, i), h_, s);
      if (!is_finite(s.v) || !is_finite(s.w)) give_up(i);  // before it can infect what it touches
    }
  }

  void give_up(std::uint32_t i) {
    SolverBody& s = body(i);
    s = {};
    bodies_.quarantined[i] = 1;
    report_.broken.push_back(i);
  }

  // --- contacts: the same formulas with restitution −1 … 0, that is 1 + e = ρ as a relaxation factor ---

  void hold() {
    warm_start();
    const bool pushing = needs_push();
    const Real enough = Real(1e-6) * g_ * h_;
    for (int pass = 1; pass <= set_.contact_passes; ++pass) {
      const Real relaxation = Real(pass) / Real(set_.contact_passes);
      Real change = 0;
      for (JointSolve& j : joints_in_step_) change = max(change, hold(j));
      const auto visit = [&](ManifoldRow& m) {
        change = max(change, set_.friction_per_increment ? hold_as_written(m, relaxation) : hold(m, relaxation));
        if (pushing) change = max(change, push(m));
      };
      if (pushing) {
        for (JointSolve& j : joints_in_step_) change = max(change, push(j));
      }
      if (pass % 2 == 1) for (std::size_t k = 0; k < manifolds_.size(); ++k) visit(manifolds_[k]);
      else for (std::size_t k = manifolds_.size(); k-- > 0;) visit(manifolds_[k]);
      ++report_.contact_passes;
      if (change <= enough) break;
    }
  }

  void warm_start() {
    for (ManifoldRow& m : manifolds_) {
      Moving a(body(m.a)), b(body(m.b));
      for (PointRow& p : m.rows()) {
        if (p.target > 0 || set_.friction_per_increment) p.impulse = {};
        apply(a, b, m, p, p.impulse);
      }
      a.store(body(m.a)), b.store(body(m.b));
      report_.points += m.count;
    }
    for (JointSolve& j : joints_in_step_) {
      SolverBody &a = body(j.a), &b = body(j.b);
      for (std::size_t r = 0; r < std::size_t(j.count); ++r) j.rows[r].apply(a, b, j.impulse[r]);
      if (j.has_low) j.low.row.apply(a, b, j.low.impulse);
      if (j.has_high) j.high.row.apply(a, b, j.high.impulse);
      if (j.has_drive) j.drive.row.apply(a, b, j.drive.impulse);
    }
  }

  bool needs_push() const {
    if (!joints_in_step_.empty() && !set_.joint_correction_in_velocity) return true;
    for (const ManifoldRow& m : manifolds_) {
      for (const PointRow& p : m.rows()) {
        if (p.push_target > 0) return true;
      }
    }
    return false;
  }

  // Returns the largest change of a relative velocity, unrelaxed, m/s.
  Real hold(ManifoldRow& m, Real relaxation) {
    Moving a(body(m.a)), b(body(m.b));
    Real change = 0;
    for (PointRow& p : m.rows()) {
      const Vec3 step = answer(p, relative_velocity(a, b, m, p), p.target, relaxation, m.friction, p.impulse);
      apply(a, b, m, p, step);
      change = max(change, size(p, step, relaxation));
    }
    a.store(body(m.a)), b.store(body(m.b));
    report_.point_passes += m.count;
    return change;
  }

  Real hold_as_written(ManifoldRow& m, Real relaxation) {
    Real change = 0;
    for (PointRow& p : m.rows()) {
      const Real impulse = increment_as_written(m, p, relaxation - 1);
      p.impulse.x += impulse;
      change = max(change, impulse / p.normal_mass);
    }
    report_.point_passes += m.count;
    return change;
  }

  // Split impulse (4.13)–(4.15): the overlap is removed in a pseudo velocity that moves bodies and is forgotten.
  Real push(ManifoldRow& m) {
    SolverBody &a = body(m.a), &b = body(m.b);
    const Vec3 n = m.frame.c0;
    Real change = 0;
    for (PointRow& p : m.rows()) {
      if (p.push_target <= 0) continue;
      const Real w = dot(n, a.push_v - b.push_v) + dot(cross(p.ra, n), a.push_w) - dot(cross(p.rb, n), b.push_w);
      const Real total = max(Real(0), p.push + (p.push_target - w) * p.normal_mass);
      const Real step = total - p.push;
      a.push_v += n * (a.inverse_mass * step);
      a.push_w += vector(p.turn_a.c0) * step;
      b.push_v -= n * (b.inverse_mass * step);
      b.push_w -= vector(p.turn_b.c0) * step;
      change = max(change, abs(step) / p.normal_mass);
      p.push = total;
    }
    return change;
  }

  // --- joints: p = K⁻¹(−u), all rows of a joint as one block (4.21) ---

  template <int n>
  Real solve_rows(JointSolve& j, SolverBody& a, SolverBody& b, bool pseudo, std::array<Real, 6>* keep) {
    std::array<Real, 6> x{};
    Real largest = 0;
    const bool pull = pseudo || (keep != nullptr && set_.joint_correction_in_velocity);
    for (std::size_t r = 0; r < n; ++r) {
      const Real u = pseudo ? j.rows[r].push_speed(a, b) : j.rows[r].speed(a, b);
      x[r] = -u - (pull ? j.bias[r] : Real(0));
      largest = max(largest, abs(x[r]));
    }
    j.block.template solve<n>(x);
    for (std::size_t r = 0; r < n; ++r) {
      if (pseudo) j.rows[r].apply_push(a, b, x[r]);
      else j.rows[r].apply(a, b, x[r]);
      if (keep != nullptr) (*keep)[r] += x[r];
    }
    return largest;
  }

  // Returns the largest relative velocity that was left, m/s.
  Real solve_block(JointSolve& j, SolverBody& a, SolverBody& b, bool pseudo, std::array<Real, 6>* keep) {
    switch (j.count) {
      case 1: return solve_rows<1>(j, a, b, pseudo, keep);
      case 3: return solve_rows<3>(j, a, b, pseudo, keep);
      case 5: return solve_rows<5>(j, a, b, pseudo, keep);
      case 6: return solve_rows<6>(j, a, b, pseudo, keep);
      default: return 0;
    }
  }

  Real hold(JointSolve& j) {
    SolverBody &a = body(j.a), &b = body(j.b);
    Real change = 0;
    const auto bounded = [&](BoundedRow& row) {
      const Real left = row.target - row.row.speed(a, b);
      const Real total = clamp(row.impulse + left * row.mass, row.low, row.high);
      row.row.apply(a, b, total - row.impulse);
      change = max(change, abs(total - row.impulse) / row.mass);
      row.impulse = total;
    };
    if (j.has_drive) bounded(j.drive);
    if (j.has_low) bounded(j.low);
    if (j.has_high) bounded(j.high);
    return max(change, solve_block(j, a, b, false, &j.impulse));
  }

  Real push(JointSolve& j) {
    if (set_.joint_correction_in_velocity) return 0;
    SolverBody &a = body(j.a), &b = body(j.b);
    Real change = 0;
    const auto bounded = [&](BoundedRow& row) {
      if (row.push_target == 0) return;
      const Real total = clamp(row.push + (row.push_target - row.row.push_speed(a, b)) * row.mass, row.low, row.high);
      row.row.apply_push(a, b, total - row.push);
      change = max(change, abs(total - row.push) / row.mass);
      row.push = total;
    };
    if (j.has_low) bounded(j.low);
    if (j.has_high) bounded(j.high);
    return max(change, solve_block(j, a, b, true, nullptr));
  }

  // --- the end of the sub-step ---

  void store() {
    for (const ManifoldRow& m : manifolds_) {
      const ActiveContact& c = in_.contacts[m.contact];
      ContactImpulse& out = contacts_.impulse[c.slot];
      out = {};
      std::array<Vec3, 4> impulse;
      for (std::size_t k = 0; k < m.count; ++k) {
        const Vec3& p = impulse[k] = m.points[k].impulse;
        out.normal[k] = p.x;
        out.friction[k] = m.frame.c1 * p.y + m.frame.c2 * p.z;
      }
      contacts_.slipping[c.slot] = slips(std::span<const Vec3>(impulse).first(m.count), m.friction) ? 1 : 0;
    }
    for (const JointSolve& j : joints_in_step_) {
      joints_.impulse[j.joint] = {j.impulse, j.low.impulse, j.high.impulse, j.drive.impulse};
    }
  }

  // (4.16) x += h (v + v_bias), and the exponential map for the turn.
  void move() {
    std::vector<std::uint8_t> integrated(bodies_.size(), 0);
    for (const std::uint32_t i : in_.smooth) integrated[i] = 1;
    runge_kutta_4(bodies_, in_.forces, in_.smooth, h_);
    for (std::size_t k = 0; k < in_.awake.size(); ++k) {
      const std::uint32_t i = in_.awake[k];
      if (integrated[i] != 0 || bodies_.quarantined[i] != 0) continue;
      const SolverBody& s = body(i);
      if (!is_finite(s.v) || !is_finite(s.w) || !is_finite(s.push_v) || !is_finite(s.push_w)) give_up(i);
      else drift(bodies_, i, s, before_[k], h_);
    }
    for (const std::uint32_t i : in_.kinematic) {
      bodies_.position[i] = bodies_.position[i] + bodies_.velocity[i] * h_;
      bodies_.orientation[i] = normalize(rotation(bodies_.spin[i] * h_) * bodies_.orientation[i]);
    }
  }

  const SolveInput& in_;
  const Impulse2007& set_;
  Bodies& bodies_;
  Joints& joints_;
  Contacts& contacts_;
  SolveReport& report_;
  Real h_, g_;
  Real fastest_ = 0;  // approach at the start, m/s
  Real least_ = 0;    // approach that counts as an impact, m/s
  std::vector<SolverBody> solver_;
  std::vector<Vec3> before_;  // ω of the awake bodies before impulses
  std::vector<ManifoldRow> manifolds_;
  std::vector<JointSolve> joints_in_step_;
};

}

void impulse_2007(const SolveInput& input, Bodies& bodies, Joints& joints, Contacts& contacts, SolveReport& report) {
  SubStep(input, bodies, joints, contacts, report).run();
}

}
