#include "dynamics/impulse_2007.h"

#include <algorithm>

#include "dynamics/as_written.h"
#include "dynamics/collisions.h"
#include "dynamics/contact_prepare.h"
#include "dynamics/curving.h"
#include "dynamics/free_joints.h"
#include "dynamics/grouping.h"
#include "dynamics/integrate.h"
#include "dynamics/shock_propagation.h"

namespace sudar::inline SUDAR_PRECISION {

struct Impulse2007Solver::Memory {
  SolverBodies bodies;
  std::vector<Wrench> loads;
  std::vector<ManifoldRow> rows;
  std::vector<ContactGroup> groups;
  std::vector<JointSolve> joints;
  JointGroups joint_groups;
  Drives drives;
  FreeJoints free_joints;
  std::vector<std::uint8_t> touched;  // bodies in contacts
};

namespace {

class MainLoop {
 public:
  MainLoop(SubStep& s, Impulse2007Solver::Memory& memory) : s_(s), memory_(memory), free_(memory.free_joints) {}

  // Thesis §3.3, from the second step on (the first, detection, is done).
  void run() {
    gather();
    prepare_contacts(s_);
    look_back(s_);
    group();
    prepare_joints();
    collide(s_);
    aim();
    accelerate_all();
    warm_start();
    look_ahead(s_);
    hold();
    pull_back();
    if (s_.set.shock_propagation) propagate_shock(s_);
    store();
    move();
  }

 private:
  // --- preparation ---

  void gather() {
    s_.on.reset(s_.bodies.size());
    for (const std::uint32_t i : s_.in.awake) s_.on[i] = solver_body(s_.bodies, i);
    for (const std::uint32_t i : s_.in.kinematic) s_.on[i] = solver_body(s_.bodies, i);
  }

  void group() {
    constexpr std::uint32_t still = no_body;
    const auto sides = [&](std::uint32_t k) {
      const ManifoldRow& m = s_.rows[k];
      return std::array{m.a_answers ? m.a : still, m.b_answers ? m.b : still};
    };
    group_contacts(std::uint32_t(s_.rows.size()), still, sides, memory_.groups);
  }

  void prepare_joints() {
    s_.joint_rows.clear();
    for (const std::uint32_t j : s_.in.joints) s_.joint_rows.emplace_back(s_.joints, s_.bodies, j, s_.on, s_.h);
    free_.reset(s_.bodies.size());
    if (s_.joint_rows.empty()) return;
    memory_.joint_groups.renew(s_.joint_rows, s_.bodies);
    memory_.drives.prepare(s_.joint_rows, s_.joints, memory_.joint_groups, s_.bodies, s_.in.forces, s_.on, s_.h);
    if (s_.set.exact_joints && !s_.set.joint_correction_in_velocity) {
      memory_.touched.assign(s_.bodies.size(), 0);
      for (const ActiveContact& c : s_.in.contacts) memory_.touched[c.a] = memory_.touched[c.b] = 1;
      const Stopwatch watch(s_.report.joint.microseconds);
      free_.advance(s_.joint_rows, s_.joints, s_.bodies, s_.in.forces, memory_.drives, memory_.joint_groups,
                    memory_.touched, s_.in.config.length_unit, s_.h);
    }
    const JointPull pull{s_.set.joint_correction / s_.h, s_.set.joint_correction_in_velocity};
    for (JointSolve& j : s_.joint_rows) {
      if (!j.free) j.prepare_visits(pull);
    }
  }

  // --- between collisions and contacts ---

  // Static or dynamic friction is decided once a sub-step, since a decision inside the passes flickers. Who stuck goes
  // on sticking until the static cone was reached; who slipped sticks again once it is slow. Speed alone must not
  // decide: the foot of a turning body seems to move by ω²rh/2, only because its arm turned during the last sub-step.
  Real choose_friction(const ManifoldRow& m) {
    const auto rows = m.rows();
    const bool held = std::any_of(rows.begin(), rows.end(), [](const PointRow& p) { return p.impulse.x > 0; });
    if (held && s_.contacts.slipping[s_.in.contacts[m.contact].slot] == 0) return m.material.friction_static;
    const Moving &a = s_.on[m.a].real, &b = s_.on[m.b].real;
    Real fastest = 0;
    for (const PointRow& p : rows) fastest = max(fastest, slide(vector(relative_velocity(a, b, m, p))));
    const bool sticks = fastest <= Real(0.1) * s_.g * s_.h;
    return sticks ? m.material.friction_static : m.material.friction_dynamic;
  }

  // What the contact passes aim at. A bounce won in the collisions must not be eaten by this step's gravity.
  void aim() {
    const Real from_rest = s_.g * s_.h;  // speed that gravity gives in a sub-step, m/s
    for (ManifoldRow& m : s_.rows) {
      m.friction = choose_friction(m);
      const Moving &a = s_.on[m.a].real, &b = s_.on[m.b].real;
      Real hardest = 0;
      const PointRow* where = nullptr;
      for (PointRow& p : m.rows()) {
        const Real bounce = -m.material.restitution * p.start;
        p.target = p.free_speed;
        if (p.hit && bounce > from_rest) p.target = min(Real(relative_velocity(a, b, m, p)[0]), bounce);
        if (p.hit && -p.start > hardest) hardest = -p.start, where = &p;
      }
      if (where != nullptr && hardest > 2 * from_rest) s_.report.hits.push_back({m.contact, where->ra, hardest});
    }
  }

  void accelerate_all() {
    std::vector<Wrench>& load = memory_.loads;
    evaluate(s_.in.forces, s_.bodies, s_.in.awake, s_.bodies.position, s_.bodies.orientation, load);
    for (const std::uint32_t i : s_.in.awake) {
      if (free_.moves(i)) continue;
      SolverBody& body = s_.on[i];
      accelerate(s_.bodies, i, load[i], drag_on(s_.in.forces, s_.bodies, i), s_.h, body);
      // before it can infect what it touches
      if (!is_finite(vector(body.real.v)) || !is_finite(vector(body.real.w))) give_up(i);
    }
  }

  void give_up(std::uint32_t i) {
    s_.on[i] = {};
    s_.bodies.quarantined[i] = 1;
    s_.report.broken.push_back(i);
  }

  // --- contacts: thesis (3.19), restitution −1 … 0, that is 1 + e = ρ as a relaxation factor ---

  void warm_start() {
    for (ManifoldRow& m : s_.rows) {
      Moving a = s_.on[m.a].real, b = s_.on[m.b].real;
      for (PointRow& p : m.rows()) {
        if (p.target > 0 || s_.set.friction_per_increment) p.impulse = {};
        apply(a, b, m, p, p.impulse);
      }
      if (m.resists_turning()) apply_turning(a, b, m.turn, m.turn.impulse);
      put(s_.on, m, a, b);
      s_.report.points += m.count;
    }
    for (JointSolve& j : s_.joint_rows) {
      if (!j.free) j.warm_start(s_.on);
    }
  }

  void hold() {
    for (ManifoldRow& m : s_.rows) prepare_aim(m);
    passes(
        s_.report.contact, Real(1e-6) * s_.g * s_.h, [&](JointSolve& j) { return j.hold(s_.on); },
        [&](const ContactGroup& group, Real relaxation) {
          if (!s_.set.friction_per_increment) return hold(group, relaxation);
          return each(group, [&](ManifoldRow& m) { return hold_as_written(m, relaxation); });
        });
  }

  // Returns the largest change of a relative velocity, unrelaxed, m/s.
  Real hold(const ContactGroup& group, Real relaxation) {
    const auto contact = [&](std::size_t n) -> ManifoldRow& {
      ManifoldRow& m = s_.rows[group.members[n]];
      s_.report.contact.visits += m.count;
      return m;
    };
    switch (group.count) {
      case 1:
        return hold_together(s_.on, relaxation, contact(0));
      case 2:
        return hold_together(s_.on, relaxation, contact(0), contact(1));
      case 3:
        return hold_together(s_.on, relaxation, contact(0), contact(1), contact(2));
      default:
        return hold_together(s_.on, relaxation, contact(0), contact(1), contact(2), contact(3));
    }
  }

  Real hold_as_written(ManifoldRow& m, Real relaxation) {
    Real change = 0;
    for (PointRow& p : m.rows()) {
      const Real impulse = increment_as_written(s_.on, m, p, relaxation - 1);
      p.impulse.x += impulse;
      change = max(change, impulse * p.normal_response);
    }
    s_.report.contact.visits += m.count;
    return change;
  }

  // Split impulse, thesis §3.7: overlap and gaps are removed in a pseudo velocity that moves bodies and is forgotten.
  void pull_back() {
    if (!needs_push()) return;
    passes(
        s_.report.correction, Real(1e-3) * s_.slop() / s_.h, [&](JointSolve& j) { return j.push(s_.on); },
        [&](const ContactGroup& group, Real) {
          return each(group, [&](ManifoldRow& m) { return push(s_.on, m, s_.report.correction.visits); });
        });
  }

  bool needs_push() const {
    const auto visited = [](const JointSolve& j) { return !j.free; };
    const auto overlaps = [](const ManifoldRow& m) {
      return std::any_of(m.rows().begin(), m.rows().end(), [](const PointRow& p) { return p.push_target > 0; });
    };
    return (!s_.set.joint_correction_in_velocity && std::any_of(s_.joint_rows.begin(), s_.joint_rows.end(), visited)) ||
           std::any_of(s_.rows.begin(), s_.rows.end(), overlaps);
  }

  template <class Visit>
  Real each(const ContactGroup& group, Visit visit) {
    Real change = 0;
    for (std::size_t n = 0; n < group.count; ++n) change = max(change, visit(s_.rows[group.members[n]]));
    return change;
  }

  // At most N₂ passes over joints and contacts, there and back, until no visit mends more than `enough`, m/s; the share
  // ρ rises to 1.
  template <class VisitJoint, class VisitContacts>
  void passes(Profile::Passes& used, Real enough, VisitJoint visit_joint, VisitContacts visit_contacts) {
    const std::vector<ContactGroup>& groups = memory_.groups;
    for (int pass = 1; pass <= s_.set.contact_passes; ++pass) {
      const Real relaxation = Real(pass) / Real(s_.set.contact_passes);
      Real change = 0;
      s_.visit_joints([&](JointSolve& j) { change = max(change, visit_joint(j)); });
      const Stopwatch watch(used.microseconds);
      const auto visit = [&](const ContactGroup& g) { change = max(change, visit_contacts(g, relaxation)); };
      if (pass % 2 == 1)
        std::for_each(groups.begin(), groups.end(), visit);
      else
        std::for_each(groups.rbegin(), groups.rend(), visit);
      ++used.used;
      if (change <= enough) break;
    }
  }

  // --- the end of the sub-step ---

  void store() {
    for (const ManifoldRow& m : s_.rows) {
      const ActiveContact& c = s_.in.contacts[m.contact];
      ContactImpulse& out = s_.contacts.impulse[c.slot];
      out = {};
      if (m.resists_turning()) out.turning = m.frame * m.turn.impulse;
      std::array<Vec3, 4> impulse;
      for (std::size_t k = 0; k < m.count; ++k) {
        const Vec3& p = impulse[k] = m.points[k].impulse;
        out.normal[k] = p.x;
        out.friction[k] = m.frame.c1 * p.y + m.frame.c2 * p.z;
      }
      s_.contacts.slipping[c.slot] = slips(std::span<const Vec3>(impulse).first(m.count), m.friction) ? 1 : 0;
    }
    for (const JointSolve& j : s_.joint_rows) j.store(s_.joints);
  }

  // thesis (3.21), with the exponential map for the turn.
  void move() {
    std::vector<std::uint8_t> integrated(s_.bodies.size(), 0);
    for (const std::uint32_t i : s_.in.smooth) integrated[i] = 1;
    std::vector<std::uint32_t> smooth(s_.in.smooth.begin(), s_.in.smooth.end());
    std::erase_if(smooth, [&](std::uint32_t i) { return s_.bodies.quarantined[i] != 0; });
    for (const std::uint32_t i : runge_kutta_4(s_.bodies, s_.in.forces, smooth, s_.h)) give_up(i);
    for (const std::uint32_t i : s_.in.awake) {
      if (integrated[i] != 0 || s_.bodies.quarantined[i] != 0 || free_.moves(i)) continue;
      if (!drift(s_.bodies, i, s_.on[i], s_.h)) give_up(i);
    }
    free_.commit(s_.bodies);
    for (const std::uint32_t i : s_.in.kinematic) carry(s_.bodies, i, s_.h);
  }

  SubStep& s_;
  Impulse2007Solver::Memory& memory_;
  FreeJoints& free_;
};

}

Impulse2007Solver::Impulse2007Solver() : memory_(std::make_unique<Memory>()) {}
Impulse2007Solver::Impulse2007Solver(Impulse2007Solver&&) noexcept = default;
Impulse2007Solver& Impulse2007Solver::operator=(Impulse2007Solver&&) noexcept = default;
Impulse2007Solver::~Impulse2007Solver() = default;

void Impulse2007Solver::sub_step(const SolveInput& input, Bodies& bodies, Joints& joints, Contacts& contacts,
                                 SolveReport& report) {
  SubStep s{.in = input,
            .set = input.config.impulse_2007,
            .bodies = bodies,
            .joints = joints,
            .contacts = contacts,
            .report = report,
            .on = memory_->bodies,
            .rows = memory_->rows,
            .joint_rows = memory_->joints};
  MainLoop(s, *memory_).run();
}

}
