#include "dynamics/impulse_2007.h"

#include <algorithm>

#include "base/timer.h"
#include "dynamics/contact_impact.h"
#include "dynamics/contact_visit.h"
#include "dynamics/free_joints.h"
#include "dynamics/integrate.h"
#include "dynamics/levels.h"
#include "dynamics/grouping.h"

namespace sudar::inline SUDAR_PRECISION {

struct Impulse2007Solver::Memory {
  SolverBodies bodies;
  std::vector<Wrench> loads;
  std::vector<ManifoldRow> manifolds;
  std::vector<ContactGroup> groups;
  std::vector<JointSolve> joints;
  FreeJoints free_joints;
  std::vector<std::uint8_t> touched;  // bodies in contacts
};

namespace {

class SubStep {
 public:
  SubStep(const SolveInput& input, Bodies& bodies, Joints& joints, Contacts& contacts, SolveReport& report,
          Impulse2007Solver::Memory& memory)
      : in_(input), set_(input.config.impulse_2007), bodies_(bodies), joints_(joints), contacts_(contacts),
        report_(report), h_(input.h), g_(length(gravity(input.forces))), memory_(memory),
        manifolds_(memory.manifolds), joints_in_step_(memory.joints), free_(memory.free_joints) {}

  // The main loop, thesis §3.3, from the second step on (the first, detection, is done).
  void run() {
    gather();
    manifolds_.resize(in_.contacts.size());
    for (std::uint32_t k = 0; k < manifolds_.size(); ++k) prepare(k, manifolds_[k]);
    constexpr std::uint32_t still = no_body;
    const auto sides = [&](std::uint32_t k) {
      const ManifoldRow& m = manifolds_[k];
      return std::array{m.a_answers ? m.a : still, m.b_answers ? m.b : still};
    };
    group_contacts(std::uint32_t(manifolds_.size()), still, sides, memory_.groups);
    prepare_joints();
    collide();
    aim();
    accelerate_all();
    warm_start();
    hold();
    pull_back();
    if (set_.shock_propagation) propagate();
    store();
    move();
  }

 private:
  SolverBody& body(std::uint32_t slot) { return memory_.bodies[slot]; }
  // The time of a scope counts as that of passes.
  class Stopwatch {
   public:
    explicit Stopwatch(Profile::Passes& passes) : passes_(passes) {}
    ~Stopwatch() { passes_.microseconds += timer_.microseconds(); }

   private:
    Profile::Passes& passes_;
    Timer timer_;
  };

  template <class Visit>
  void visit_joints(Visit visit) {
    if (joints_in_step_.empty()) return;
    const Stopwatch watch(report_.joint);
    ++report_.joint.used;
    for (JointSolve& j : joints_in_step_) {
      if (j.free) continue;
      visit(j);
      ++report_.joint.visits;
    }
  }

  void gather() {
    memory_.bodies.reset(bodies_.size());
    for (const std::uint32_t i : in_.awake) body(i) = solver_body(bodies_, i);
    for (const std::uint32_t i : in_.kinematic) body(i) = solver_body(bodies_, i);
  }

  void prepare_joints() {
    joints_in_step_.clear();
    for (const std::uint32_t j : in_.joints) joints_in_step_.emplace_back(joints_, bodies_, j, memory_.bodies, h_);
    free_.reset(bodies_.size());
    if (set_.exact_joints && !set_.joint_correction_in_velocity && !in_.joints.empty()) {
      memory_.touched.assign(bodies_.size(), 0);
      for (const ActiveContact& c : in_.contacts) memory_.touched[c.a] = memory_.touched[c.b] = 1;
      const Stopwatch watch(report_.joint);
      free_.advance(joints_in_step_, joints_, bodies_, in_.forces, memory_.touched, in_.config.length_unit, h_);
    }
    const JointPull pull{set_.joint_correction / h_, set_.joint_correction_in_velocity};
    for (JointSolve& j : joints_in_step_) {
      if (!j.free) j.prepare_visits(pull);
    }
  }

  // --- preparation ---

  void prepare(std::uint32_t contact, ManifoldRow& m) {
    const ActiveContact& c = in_.contacts[contact];
    const Manifold manifold = set_.one_point_contact ? centre(*c.manifold) : *c.manifold;
    m.a = c.a, m.b = c.b;
    m.contact = contact;
    m.count = std::uint32_t(manifold.count);
    m.material = c.material;
    m.struck = m.owes = false;
    const Vec3 n = manifold.normal, t = any_perpendicular(n);
    m.frame = {n, t, cross(n, t)};
    const Mat3 to_frame = transpose(m.frame);
    const SolverBody &a = body(c.a), &b = body(c.b);
    m.to_frame = lanes(to_frame);
    m.mass_a = lanes(m.frame * a.inverse_mass);
    m.mass_b = lanes(m.frame * b.inverse_mass);
    m.a_answers = a.inverse_mass > 0, m.b_answers = b.inverse_mass > 0;
    if (m.resists_turning()) {
      prepare_turning(m.turn, m.frame, a, b);
      m.turn.impulse = to_frame * contacts_.impulse[c.slot].turning;
    }
    const Vec3 to_shape = rotate(bodies_.orientation[c.a], bodies_.shape_frame[c.a].p);
    const Vec3 apart = bodies_.position[c.a] - bodies_.position[c.b];
    const Vec3 surfaces = bodies_.surface_velocity_world(c.a) - bodies_.surface_velocity_world(c.b);
    const Real4 glide{0, dot(m.frame.c1, surfaces), dot(m.frame.c2, surfaces), 0};
    for (std::size_t k = 0; k < m.count; ++k) {
      const ManifoldPoint& from = manifold.points[k];
      PointRow& p = m.points[k] = PointRow{};
      p.glide = glide;
      p.ra = from.at + to_shape;
      p.rb = p.ra + apart;
      prepare_masses(p, to_frame, a, b);
      const Real depth = -from.separation;
      p.free_speed = min(Real(0), depth / h_);
      p.start = relative_velocity(a.real, b.real, m, p)[0];
      fastest_ = max(fastest_, -p.start);
      p.push_target = set_.correction / h_ * max(Real(0), depth - slop());  // thesis (3.20): a speed
      if (set_.one_point_contact || from.match >= 0) {
        // The impulse of the last sub-step, point by feature; friction turned into the new tangent plane.
        const ContactImpulse& stored = contacts_.impulse[c.slot];
        const std::size_t old = set_.one_point_contact ? 0 : std::size_t(from.match);
        p.impulse = to_frame * stored.friction[old];
        p.impulse.x = stored.normal[old];
      }
    }
  }

  Real slop() const { return set_.slop * in_.config.length_unit; }
  Real stick_speed() const { return Real(0.1) * g_ * h_; }

  // --- collisions: thesis §3.5, §3.6 ---

  // Passes until no manifold approaches, thesis (3.15). Nothing is warm-started and nothing is kept: an impact is over at once.
  void collide() {
    // Approach slower than a hundredth of gravity's share in a step is what turning arms and the last contact passes left
    // over: the coming contact passes mend it, no impact does.
    least_ = Real(0.01) * g_ * h_ + Real(1e-6) * fastest_;
    for (int pass = 0; pass < set_.collision_passes; ++pass) {
      stop_joints();
      const Stopwatch watch(report_.collision);
      bool approaching = false;
      for (ManifoldRow& m : manifolds_) {
        if (m.owes) strike(m), approaching = true;
      }
      for (ManifoldRow& m : manifolds_) {
        const Moving &a = body(m.a).real, &b = body(m.b).real;
        bool approaches = false;
        for (const PointRow& p : m.rows()) approaches |= relative_velocity(a, b, m, p)[0] < p.free_speed - least_;
        if (!approaches) continue;
        approaching = true;
        if (set_.friction_per_increment) strike_as_written(m);
        else strike(m);
      }
      if (!approaching) break;
      ++report_.collision.used;
    }
  }

  // Joints take a part of the bounce of bodies that they hold, and the contact owes it: it is struck once more, until
  // hinged bodies part as fast as free ones. What another contact takes is not owed: so a row of balls passes its speed on.
  void stop_joints() {
    if (joints_in_step_.empty()) return;
    const auto each_struck = [&](auto visit) {
      for (ManifoldRow& m : manifolds_) {
        if (!m.struck) continue;
        const Moving &a = body(m.a).real, &b = body(m.b).real;
        for (PointRow& p : m.rows()) visit(m, p, relative_velocity(a, b, m, p)[0]);
      }
    };
    each_struck([&](ManifoldRow&, PointRow& p, Real speed) {
      p.unheld = speed;
      if (abs(speed - p.aim) > Real(1e-3) * fastest_) p.aim = speed;
    });
    visit_joints([&](JointSolve& j) { j.stop(memory_.bodies); });
    each_struck([&](ManifoldRow& m, PointRow& p, Real speed) {
      m.owes |= p.unheld - speed > least_ || (p.blow.x > 0 && speed - p.unheld > least_);
    });
  }

  // One impact of a manifold: all its points at once, with accumulated impulses that live in this impact only.
  void strike(ManifoldRow& m) {
    const Moving a0 = body(m.a).real, b0 = body(m.b).real;
    Moving a = a0, b = b0;
    std::array<Vec3, 4> blow{};
    if (m.owes) {
      for (std::size_t k = 0; k < m.count; ++k) blow[k] = m.points[k].blow;
    }
    const auto again = [&](Real restitution, Real friction) {
      a = a0, b = b0;
      for (std::size_t k = 0; k < m.count; ++k) m.points[k].blow = blow[k];
      return impact(m, a, b, restitution, friction, least_, report_.collision.visits);
    };
    // It sticks if it can: only when the static cone does not hold does it slip, under dynamic friction.
    Real friction = m.material.friction_static;
    Impact outcome = again(m.material.restitution, friction);
    if (outcome.slips && m.material.friction_dynamic != friction) {
      friction = m.material.friction_dynamic;
      outcome = again(m.material.restitution, friction);
    }
    if (outcome.made_energy) outcome = again(0, friction);  // friction made energy: take the bounce away instead
    put(memory_.bodies, m, a, b);
    m.struck = true, m.owes = false;
  }

  // Option friction_per_increment: thesis (3.16), (3.18) nearly as written, each increment against its own cone. It serves to show
  // what goes wrong: a train moves that static friction should hold.
  void strike_as_written(ManifoldRow& m) {
    for (PointRow& p : m.rows()) p.hit |= increment_as_written(m, p, m.material.restitution) > 0;
    report_.collision.visits += m.count;
  }

  Real increment_as_written(const ManifoldRow& m, const PointRow& p, Real restitution) {
    Moving a = body(m.a).real, b = body(m.b).real;
    const Vec3 u = vector(relative_velocity(a, b, m, p));
    if (u.x >= p.free_speed) return 0;
    const Mat3 k = matrix(m.to_frame) * (matrix(m.mass_a) + matrix(m.mass_b)) + matrix(p.arm_a) * matrix(p.turn_a) +
                   matrix(p.arm_b) * matrix(p.turn_b);
    Vec3 impulse = inverse(k) * (Vec3{-restitution * u.x, 0, 0} - u);                         // thesis (3.16)
    if (impulse.x < 0 || slide(impulse) > m.material.friction_static * impulse.x) {
      const Real fast = slide(u);
      const Real share = fast > 0 ? m.material.friction_dynamic / fast : Real(0);
      const Vec3 direction{1, -share * u.y, -share * u.z};
      const Real denominator = dot(k.c0, direction);
      if (denominator <= 0) return 0;                                                         // jamming
      impulse = direction * (-(1 + restitution) * u.x / denominator);                         // thesis (3.17), (3.18)
    }
    apply(a, b, m, p, impulse);
    put(memory_.bodies, m, a, b);
    return impulse.x;
  }

  // --- between collisions and contacts ---

  // Static or dynamic friction is decided once a sub-step, since a decision inside the passes flickers. Who stuck goes
  // on sticking until the static cone was reached; who slipped sticks again once it is slow. Speed alone must not decide:
  // the foot of a turning body seems to move by ω²rh/2, only because its arm turned during the last sub-step.
  Real choose_friction(const ManifoldRow& m) {
    const auto rows = m.rows();
    const bool held = std::any_of(rows.begin(), rows.end(), [](const PointRow& p) { return p.impulse.x > 0; });
    if (held && contacts_.slipping[in_.contacts[m.contact].slot] == 0) return m.material.friction_static;
    const Moving &a = body(m.a).real, &b = body(m.b).real;
    Real fastest = 0;
    for (const PointRow& p : rows) fastest = max(fastest, slide(vector(relative_velocity(a, b, m, p))));
    return fastest <= stick_speed() ? m.material.friction_static : m.material.friction_dynamic;
  }

  // What the contact passes aim at. A bounce won in the collisions must not be eaten by this step's gravity.
  void aim() {
    for (ManifoldRow& m : manifolds_) {
      m.friction = choose_friction(m);
      const Moving &a = body(m.a).real, &b = body(m.b).real;
      Real hardest = 0;
      const PointRow* where = nullptr;
      const bool on_a = points_are_a_s(m);
      for (PointRow& p : m.rows()) {
        const Real bounce = -m.material.restitution * p.start;
        p.target = p.free_speed;
        if (p.hit && bounce > g_ * h_) p.target = min(Real(relative_velocity(a, b, m, p)[0]), bounce);
        p.glide += half_way(m, p, on_a, a, b, h_);
        if (p.hit && -p.start > hardest) hardest = -p.start, where = &p;
      }
      if (where != nullptr && hardest > 2 * g_ * h_) report_.hits.push_back({m.contact, where->ra, hardest});
    }
  }

  void accelerate_all() {
    std::vector<Wrench>& load = memory_.loads;
    evaluate(in_.forces, bodies_, in_.awake, bodies_.position, bodies_.orientation, load);
    for (const std::uint32_t i : in_.awake) {
      if (free_.moves(i)) continue;
      SolverBody& s = body(i);
      accelerate(bodies_, i, load[i], drag_on(in_.forces, bodies_, i), h_, s);
      if (!is_finite(vector(s.real.v)) || !is_finite(vector(s.real.w))) give_up(i);  // before it can infect what it touches
    }
  }

  void give_up(std::uint32_t i) {
    SolverBody& s = body(i);
    s = {};
    bodies_.quarantined[i] = 1;
    report_.broken.push_back(i);
  }

  // --- contacts: thesis (3.19), restitution −1 … 0, that is 1 + e = ρ as a relaxation factor ---

  void hold() {
    passes(report_.contact, Real(1e-6) * g_ * h_, [&](JointSolve& j) { return j.hold(memory_.bodies); },
           [&](const ContactGroup& group, Real relaxation) {
             if (!set_.friction_per_increment) return hold(group, relaxation);
             return each(group, [&](ManifoldRow& m) { return hold_as_written(m, relaxation); });
           });
  }

  // Split impulse, thesis §3.7: overlap and gaps are removed in a pseudo velocity that moves bodies and is forgotten.
  void pull_back() {
    if (!needs_push()) return;
    passes(report_.correction, Real(1e-3) * slop() / h_, [&](JointSolve& j) { return j.push(memory_.bodies); },
           [&](const ContactGroup& group, Real) { return each(group, [&](ManifoldRow& m) { return push(m); }); });
  }
  template <class Visit>
  Real each(const ContactGroup& group, Visit visit) {
    Real change = 0;
    for (std::size_t n = 0; n < group.count; ++n) change = max(change, visit(manifolds_[group.members[n]]));
    return change;
  }

  // At most N₂ passes over joints and contacts, there and back, until no visit mends more than `enough`, m/s; the share ρ
  // rises to 1.
  template <class VisitJoint, class VisitContacts>
  void passes(Profile::Passes& used, Real enough, VisitJoint visit_joint, VisitContacts visit_contacts) {
    const std::vector<ContactGroup>& groups = memory_.groups;
    for (int pass = 1; pass <= set_.contact_passes; ++pass) {
      const Real relaxation = Real(pass) / Real(set_.contact_passes);
      Real change = 0;
      visit_joints([&](JointSolve& j) { change = max(change, visit_joint(j)); });
      const Stopwatch watch(used);
      const auto visit = [&](const ContactGroup& g) { change = max(change, visit_contacts(g, relaxation)); };
      if (pass % 2 == 1) std::for_each(groups.begin(), groups.end(), visit);
      else std::for_each(groups.rbegin(), groups.rend(), visit);
      ++used.used;
      if (change <= enough) break;
    }
  }

  // Option shock_propagation: one more round of contacts, level by level from the ground up, in which a body stands on
  // what lies below as on rock. Saves passes where weight presses on weight; wrong where the lower body should give way
  // (docs/shock_propagation.md).
  void propagate() {
    const std::vector<std::uint32_t> level = contact_levels(in_.contacts, bodies_);
    std::vector<ManifoldRow> frozen = manifolds_;  // the warm start of the next sub-step is that of the whole pile
    std::vector<std::vector<ManifoldRow*>> by_level;
    for (ManifoldRow& m : frozen) {
      const std::uint32_t upper = max(level[m.a], level[m.b]);
      if (upper == no_level) continue;
      if (upper >= by_level.size()) by_level.resize(upper + 1);
      by_level[upper].push_back(&m);
    }
    constexpr int passes = 10;  // a level's own contacts; what lies below does not answer
    for (const std::vector<ManifoldRow*>& rows : by_level) {
      for (ManifoldRow* m : rows) freeze_lower(*m, level);
      for (int pass = 0; pass < passes; ++pass) {
        for (ManifoldRow* m : rows) {
          hold_together(memory_.bodies, 1, *m);
          push(*m);
        }
      }
    }
  }

  void freeze_lower(ManifoldRow& m, const std::vector<std::uint32_t>& level) {
    if (level[m.a] == level[m.b]) return;
    SolverBody a = body(m.a), b = body(m.b);
    SolverBody& lower = level[m.a] < level[m.b] ? a : b;
    lower.inverse_mass = 0, lower.inverse_inertia = {};
    m.mass_a = lanes(m.frame * a.inverse_mass), m.mass_b = lanes(m.frame * b.inverse_mass);
    for (PointRow& p : m.rows()) prepare_masses(p, transpose(m.frame), a, b);
    if (m.resists_turning()) prepare_turning(m.turn, m.frame, a, b);
  }

  void warm_start() {
    for (ManifoldRow& m : manifolds_) {
      Moving a = body(m.a).real, b = body(m.b).real;
      for (PointRow& p : m.rows()) {
        if (p.target > 0 || set_.friction_per_increment) p.impulse = {};
        apply(a, b, m, p, p.impulse);
      }
      if (m.resists_turning()) apply_turning(a, b, m.turn, m.turn.impulse);
      put(memory_.bodies, m, a, b);
      report_.points += m.count;
    }
    for (JointSolve& j : joints_in_step_) {
      if (!j.free) j.warm_start(memory_.bodies);
    }
  }

  bool needs_push() const {
    if (!set_.joint_correction_in_velocity) {
      for (const JointSolve& j : joints_in_step_) {
        if (!j.free) return true;
      }
    }
    for (const ManifoldRow& m : manifolds_) {
      for (const PointRow& p : m.rows()) {
        if (p.push_target > 0) return true;
      }
    }
    return false;
  }

  // Returns the largest change of a relative velocity, unrelaxed, m/s.
  Real hold(const ContactGroup& group, Real relaxation) {
    const auto contact = [&](std::size_t n) -> ManifoldRow& {
      ManifoldRow& m = manifolds_[group.members[n]];
      report_.contact.visits += m.count;
      return m;
    };
    SolverBodies& on = memory_.bodies;
    switch (group.count) {
      case 1: return hold_together(on, relaxation, contact(0));
      case 2: return hold_together(on, relaxation, contact(0), contact(1));
      case 3: return hold_together(on, relaxation, contact(0), contact(1), contact(2));
      default: return hold_together(on, relaxation, contact(0), contact(1), contact(2), contact(3));
    }
  }

  Real hold_as_written(ManifoldRow& m, Real relaxation) {
    Real change = 0;
    for (PointRow& p : m.rows()) {
      const Real impulse = increment_as_written(m, p, relaxation - 1);
      p.impulse.x += impulse;
      change = max(change, impulse * p.normal_response);
    }
    report_.contact.visits += m.count;
    return change;
  }

  Real push(ManifoldRow& m) {
    Moving &a = body(m.a).push, &b = body(m.b).push;
    Real change = 0;
    for (PointRow& p : m.rows()) {
      if (p.push_target <= 0) continue;
      const Real left = p.push_target - relative_velocity(a, b, m, p)[0];
      const Real step = max(-p.push, left * p.normal_mass);
      apply(a, b, m, p, {step, 0, 0});
      change = max(change, abs(step) * p.normal_response);
      p.push += step;
      ++report_.correction.visits;
    }
    return change;
  }

  // --- the end of the sub-step ---

  void store() {
    for (const ManifoldRow& m : manifolds_) {
      const ActiveContact& c = in_.contacts[m.contact];
      ContactImpulse& out = contacts_.impulse[c.slot];
      out = {};
      if (m.resists_turning()) out.turning = m.frame * m.turn.impulse;
      std::array<Vec3, 4> impulse;
      for (std::size_t k = 0; k < m.count; ++k) {
        const Vec3& p = impulse[k] = m.points[k].impulse;
        out.normal[k] = p.x;
        out.friction[k] = m.frame.c1 * p.y + m.frame.c2 * p.z;
      }
      contacts_.slipping[c.slot] = slips(std::span<const Vec3>(impulse).first(m.count), m.friction) ? 1 : 0;
    }
    for (const JointSolve& j : joints_in_step_) j.store(joints_);
  }

  // thesis (3.21), with the exponential map for the turn.
  void move() {
    std::vector<std::uint8_t> integrated(bodies_.size(), 0);
    for (const std::uint32_t i : in_.smooth) integrated[i] = 1;
    std::vector<std::uint32_t> smooth(in_.smooth.begin(), in_.smooth.end());
    std::erase_if(smooth, [&](std::uint32_t i) { return bodies_.quarantined[i] != 0; });
    for (const std::uint32_t i : runge_kutta_4(bodies_, in_.forces, smooth, h_)) give_up(i);
    for (const std::uint32_t i : in_.awake) {
      if (integrated[i] != 0 || bodies_.quarantined[i] != 0 || free_.moves(i)) continue;
      if (!drift(bodies_, i, body(i), h_)) give_up(i);
    }
    free_.commit(bodies_);
    for (const std::uint32_t i : in_.kinematic) carry(bodies_, i, h_);
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
  Impulse2007Solver::Memory& memory_;
  std::vector<ManifoldRow>& manifolds_;
  std::vector<JointSolve>& joints_in_step_;
  FreeJoints& free_;
};

}

Impulse2007Solver::Impulse2007Solver() : memory_(std::make_unique<Memory>()) {}
Impulse2007Solver::Impulse2007Solver(Impulse2007Solver&&) noexcept = default;
Impulse2007Solver& Impulse2007Solver::operator=(Impulse2007Solver&&) noexcept = default;
Impulse2007Solver::~Impulse2007Solver() = default;

void Impulse2007Solver::sub_step(const SolveInput& input, Bodies& bodies, Joints& joints, Contacts& contacts,
                                 SolveReport& report) {
  SubStep(input, bodies, joints, contacts, report, *memory_).run();
}

}
