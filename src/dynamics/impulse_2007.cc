#include "dynamics/impulse_2007.h"

#include <algorithm>
#include <functional>

#include "dynamics/as_written.h"
#include "dynamics/collisions.h"
#include "dynamics/contact_prepare.h"
#include "dynamics/curving.h"
#include "dynamics/exact_joints.h"
#include "dynamics/grouping.h"
#include "dynamics/integrate.h"
#include "dynamics/shock_propagation.h"

namespace sudar::inline SUDAR_PRECISION {

namespace {

// What solving one island needs; used again for the next.
struct Workspace {
  std::vector<ManifoldRow> rows;
  std::vector<ManifoldStart> starts;
  std::vector<ManifoldPush> pushes;
  std::vector<TurnRow> turns;
  std::vector<ContactGroup> groups;
  std::vector<JointSolve> joints;
  std::vector<Wrench> loads;
  Drives drives;
  ExactJoints exact_joints;
};

class IslandSolver {
 public:
  IslandSolver(SubStep& s, Workspace& work) : s_(s), work_(work) {}

  // Thesis §3.3, from the second step on (the first, detection, is done) until only the motion is left.
  void run() {
    gather();
    prepare_contacts(s_);
    look_back(s_);
    group();
    prepare_joints();
    strike_contacts(s_);
    aim();
    accelerate_all();
    warm_start();
    look_ahead(s_);
    hold();
    pull_back();
    store();
    if (s_.set.shock_propagation) propagate_shock(s_);
  }

 private:
  // --- preparation ---

  std::span<const std::uint32_t> bodies() const { return s_.island.bodies.of(s_.in.awake); }
  SolverBody& on(std::uint32_t slot) { return s_.on[s_.on.number(slot)]; }

  void gather() {
    for (const std::uint32_t i : bodies()) on(i) = solver_body(s_.in.bodies, i);
  }

  void group() {
    constexpr std::uint32_t still = no_body;
    const auto sides = [&](std::uint32_t k) {
      const ManifoldRow& m = s_.rows[k];
      return std::array{m.a_answers ? m.a : still, m.b_answers ? m.b : still};
    };
    group_contacts(std::uint32_t(s_.rows.size()), still, sides, work_.groups);
  }

  void prepare_joints() {
    s_.joint_rows.clear();
    for (const std::uint32_t j : s_.island.joints.of(s_.in.joints)) {
      s_.joint_rows.emplace_back(s_.in.joint_state, s_.in.bodies, j, s_.on, s_.h);
    }
    if (s_.joint_rows.empty()) return;
    const std::vector<JointGroup> groups = joint_groups(s_);
    work_.drives.prepare(s_, groups);
    if (s_.set.exact_joints && !s_.set.joint_correction_in_velocity) {
      for (const ManifoldRow& m : s_.rows) {
        if (m.a_answers) s_.on[m.a].touches = true;
        if (m.b_answers) s_.on[m.b].touches = true;
      }
      const Stopwatch watch(s_.out.joint.microseconds);
      work_.exact_joints.advance(s_, groups, work_.drives);
    }
    const JointPull pull{s_.set.joint_correction / s_.h, s_.set.joint_correction_in_velocity};
    for (JointSolve& j : s_.joint_rows) {
      if (!j.exact) j.prepare_visits(pull);
    }
  }

  // --- between collisions and contacts ---

  // Static or dynamic friction is decided once a sub-step, since a decision inside the passes flickers. Who stuck goes
  // on sticking until the static cone was reached; who slipped sticks again once it is slow. Speed alone must not
  // decide: the foot of a turning body seems to move by ω²rh/2, only because its arm turned during the last sub-step.
  // Slow is a tenth of what a sub-step's weight gives, or where nothing weighs, of what pressed the bodies together.
  Real choose_friction(const ManifoldRow& m, const ManifoldStart& start) {
    const RelativeMotion motion = s_.motion(m);
    bool held = false;
    Real fastest = 0, load = s_.g * s_.h;
    for (const PointRow& p : m.rows()) {
      held |= p.impulse.x > 0;
      fastest = max(fastest, slide(vector(relative_velocity(motion, p))));
      if (s_.g == 0) load = max(load, p.impulse.x * p.normal_response);
    }
    if (held && s_.in.contact_state.slipping[s_.contact(m).slot] == 0) return start.friction_static;
    return fastest <= Real(0.1) * load ? start.friction_static : start.friction_dynamic;
  }

  // What the contact passes aim at. A bounce won in the collisions must not be eaten by this step's gravity.
  void aim() {
    const Real from_rest = s_.g * s_.h;  // speed that gravity gives in a sub-step, m/s
    for (std::size_t n = 0; n < s_.rows.size(); ++n) {
      ManifoldRow& m = s_.rows[n];
      const ManifoldStart& start = s_.starts[n];
      m.friction = choose_friction(m, start);
      const RelativeMotion motion = s_.motion(m);
      Real hardest = 0;
      std::size_t where = 0;
      for (std::size_t k = 0; k < m.count; ++k) {
        PointRow& p = m.points[k];
        const ManifoldStart::Point& from = start.points[k];
        const Real bounce = -start.restitution * from.speed;
        p.target = from.free_speed;
        if (from.hit && bounce > from_rest) p.target = min(Real(relative_velocity(motion, p)[0]), bounce);
        if (from.hit && -from.speed > hardest) hardest = -from.speed, where = k;
      }
      if (hardest > 2 * from_rest) s_.out.hits.push_back({m.contact, vector(m.ra + m.frame * m.points[where].at), hardest});
    }
  }

  void accelerate_all() {
    evaluate(s_.in.forces, s_.in.bodies, bodies(), work_.loads);
    for (std::size_t k = 0; k < bodies().size(); ++k) {
      const std::uint32_t i = bodies()[k];
      SolverBody& body = on(i);
      if (body.settled) continue;
      accelerate(s_.in.bodies, i, work_.loads[k], drag_on(s_.in.forces, s_.in.bodies, i), s_.h, body);
      // before it can infect what it touches
      if (is_finite(vector(body.real.v)) && is_finite(vector(body.real.w))) continue;
      body = {};
      s_.in.bodies.quarantined[i] = 1;
      s_.out.broken.push_back(i);
    }
  }

  // --- contacts: thesis (3.19), restitution −1 … 0, that is 1 + e = ρ as a relaxation factor ---

  void warm_start() {
    for (std::size_t k = 0; k < s_.rows.size(); ++k) {
      ManifoldRow& m = s_.rows[k];
      const SolverBody &on_a = s_.on[m.a], &on_b = s_.on[m.b];
      WrenchImpulse sum;
      for (PointRow& p : m.rows()) {
        if (p.target > 0 || s_.set.friction_per_increment) p.impulse = {};
        sum += to_middle(p, p.impulse);
      }
      if (m.resists_turning) sum.moment += lanes(s_.turns[k].impulse);
      Moving a = on_a.real, b = on_b.real;
      apply(a, b, on_a, on_b, m, sum);
      put(s_.on, m, a, b);
      s_.out.points += m.count;
    }
    for (JointSolve& j : s_.joint_rows) {
      if (!j.exact) j.warm_start(s_.on);
    }
  }

  // Until what is left is a millionth of what a sub-step's weight gives, or where nothing weighs, of the strongest impulse.
  void hold() {
    for (ManifoldRow& m : s_.rows) prepare_aim(m);
    const auto settled = [&](Real change) {
      return change <= Real(1e-6) * s_.g * s_.h || (s_.g == 0 && change <= Real(1e-6) * strongest());
    };
    passes(
        s_.out.contact, settled, [&](JointSolve& j) { return j.hold(s_.on); },
        [&](const ContactGroup& group, Real relaxation) {
          if (!s_.set.friction_per_increment) return hold(group, relaxation);
          return each(group, [&](std::size_t k) { return hold_as_written(k, relaxation); });
        });
  }

  // The strongest impulse, as the change of relative velocity that it is, m/s.
  Real strongest() const {
    Real most = 0;
    for (const ManifoldRow& m : s_.rows) {
      for (const PointRow& p : m.rows()) most = max(most, p.impulse.x * p.normal_response);
    }
    for (const JointSolve& j : s_.joint_rows) {
      if (!j.exact) most = max(most, j.strongest());
    }
    return most;
  }

  // Returns the largest change of a relative velocity, unrelaxed, m/s.
  Real hold(const ContactGroup& group, Real relaxation) {
    const auto contact = [&](std::size_t n) {
      const std::uint32_t k = group.members[n];
      s_.out.contact.visits += s_.rows[k].count;
      return Holding(s_.on, s_.rows[k], s_.turn(k), relaxation);
    };
    switch (group.count) {
      case 1: return hold_together(std::array{contact(0)}, relaxation);
      case 2: return hold_together(std::array{contact(0), contact(1)}, relaxation);
      case 3: return hold_together(std::array{contact(0), contact(1), contact(2)}, relaxation);
      default: return hold_together(std::array{contact(0), contact(1), contact(2), contact(3)}, relaxation);
    }
  }

  Real hold_as_written(std::size_t number, Real relaxation) {
    ManifoldRow& m = s_.rows[number];
    Real change = 0;
    for (std::size_t k = 0; k < m.count; ++k) {
      const Real impulse = increment_as_written(s_.on, m, s_.starts[number], k, relaxation - 1);
      m.points[k].impulse.x += impulse;
      change = max(change, impulse * m.points[k].normal_response);
    }
    s_.out.contact.visits += m.count;
    return change;
  }

  // Split impulse, thesis §3.7: overlap and gaps are removed in a pseudo velocity that moves bodies and is forgotten.
  void pull_back() {
    const bool joints = !s_.set.joint_correction_in_velocity &&
                        std::ranges::any_of(s_.joint_rows, [](const JointSolve& j) { return !j.exact; });
    if (!joints && std::ranges::none_of(s_.pushes, &ManifoldPush::needed)) return;
    passes(
        s_.out.correction, [&](Real change) { return change <= Real(1e-3) * s_.slop() / s_.h; },
        [&](JointSolve& j) { return j.push(s_.on); },
        [&](const ContactGroup& group, Real) {
          return each(group, [&](std::size_t k) {
            return separate(s_.on, s_.rows[k], s_.pushes[k], s_.out.correction.visits);
          });
        });
  }

  template <class Visit>
  Real each(const ContactGroup& group, Visit visit) {
    Real change = 0;
    for (std::size_t n = 0; n < group.count; ++n) change = max(change, visit(group.members[n]));
    return change;
  }

  // At most N₂ passes over joints and contacts, there and back, until `settled` says that no visit mends more than
  // matters, m/s; the share ρ rises to 1.
  template <class Settled, class VisitJoint, class VisitContacts>
  void passes(Profile::Passes& used, Settled settled, VisitJoint visit_joint, VisitContacts visit_contacts) {
    const std::vector<ContactGroup>& groups = work_.groups;
    const Timer timer;
    const double of_joints = s_.out.joint.microseconds;
    for (int pass = 1; pass <= s_.set.contact_passes; ++pass) {
      const Real relaxation = Real(pass) / Real(s_.set.contact_passes);
      Real change = 0;
      s_.visit_joints([&](JointSolve& j) { change = max(change, visit_joint(j)); });
      const auto visit = [&](const ContactGroup& g) { change = max(change, visit_contacts(g, relaxation)); };
      if (pass % 2 == 1)
        std::for_each(groups.begin(), groups.end(), visit);
      else
        std::for_each(groups.rbegin(), groups.rend(), visit);
      ++used.used;
      if (settled(change)) break;
    }
    used.microseconds += timer.microseconds() - (s_.out.joint.microseconds - of_joints);
  }

  // --- the end of the sub-step ---

  void store() {
    for (std::size_t n = 0; n < s_.rows.size(); ++n) {
      const ManifoldRow& m = s_.rows[n];
      const std::uint32_t slot = s_.contact(m).slot;
      ContactImpulse& out = s_.in.contact_state.impulse[slot];
      out = {};
      const Mat3 frame = matrix(m.frame);
      if (m.resists_turning) out.turning = frame * s_.turns[n].impulse;
      std::array<Vec3, 4> impulse;
      for (std::size_t k = 0; k < m.count; ++k) {
        const Vec3& p = impulse[k] = m.points[k].impulse;
        out.normal[k] = p.x;
        out.friction[k] = frame.c1 * p.y + frame.c2 * p.z;
      }
      const bool slipping = slips(std::span<const Vec3>(impulse).first(m.count), m.friction);
      s_.in.contact_state.slipping[slot] = slipping ? 1 : 0;
    }
    for (const JointSolve& j : s_.joint_rows) j.store(s_.in.joint_state);
  }

  SubStep& s_;
  Workspace& work_;
};

}

namespace {

// A worker's own.
struct Bench {
  Workspace work;
  StepOutcome out;
};

// Islands in runs of about the same cost, the dearest first, so that workers end together.
struct Jobs {
  std::vector<std::uint32_t> islands;            // numbers, by cost
  std::vector<std::pair<std::uint32_t, std::uint32_t>> runs;  // first, end in that list

  void plan(std::span<const Island> all) {
    constexpr std::uint32_t enough = 200;  // about that of 50 contacts: less is not worth a trip to the pool
    const auto cost = [&](std::uint32_t i) {
      return 4 * (all[i].contacts.count + all[i].joints.count) + all[i].bodies.count;
    };
    islands.resize(all.size());
    for (std::uint32_t i = 0; i < islands.size(); ++i) islands[i] = i;
    std::ranges::stable_sort(islands, std::greater(), cost);
    runs.clear();
    std::uint32_t sum = 0, first = 0;
    for (std::uint32_t k = 0; k < islands.size(); ++k) {
      sum += cost(islands[k]);
      if (sum < enough && k + 1 < islands.size()) continue;
      runs.emplace_back(first, k + 1);
      first = k + 1, sum = 0;
    }
  }
};

// Whether islands reach into each other while they are solved: bodies attract each other from afar, or exact joints
// move a common carrier to and fro. Then they take turns.
bool take_turns(const StepView& in) {
  const auto carries = [&](std::uint32_t i) { return in.joint_graph.count(i) > 0; };
  return act_from_afar(in.forces) || std::ranges::any_of(in.kinematic, carries);
}

}

struct Impulse2007Solver::Memory {
  SolverBodies bodies;
  std::vector<Bench> benches;  // by worker
  Jobs jobs;
};

Impulse2007Solver::Impulse2007Solver() : memory_(std::make_unique<Memory>()) {}
Impulse2007Solver::Impulse2007Solver(Impulse2007Solver&&) noexcept = default;
Impulse2007Solver& Impulse2007Solver::operator=(Impulse2007Solver&&) noexcept = default;
Impulse2007Solver::~Impulse2007Solver() = default;

namespace {

void solve(const StepView& in, const Island& island, SolverBodies& on, Bench& bench) {
  Workspace& work = bench.work;
  SubStep s{.in = in,
            .island = island,
            .set = in.config.impulse_2007,
            .on = on,
            .out = bench.out,
            .rows = work.rows,
            .starts = work.starts,
            .pushes = work.pushes,
            .turns = work.turns,
            .joint_rows = work.joints};
  IslandSolver(s, work).run();
}

// thesis (3.21), with the exponential map for the turn. All bodies move after all islands are solved, so that they see
// each other where the sub-step began.
void move(const StepView& in, SolverBodies& on, std::vector<Bench>& benches) {
  Bodies& bodies = in.bodies;
  const auto give_up = [&](std::uint32_t i, std::uint32_t worker) {
    bodies.quarantined[i] = 1;
    benches[worker].out.broken.push_back(i);
  };
  std::vector<std::uint32_t> smooth(in.smooth.begin(), in.smooth.end());
  std::erase_if(smooth, [&](std::uint32_t i) { return bodies.quarantined[i] != 0; });
  for (const std::uint32_t i : smooth) on[on.number(i)].settled = true;
  for (const std::uint32_t i : runge_kutta_4(bodies, in.forces, smooth, in.h)) give_up(i, 0);
  const auto drift_all = [&](std::uint32_t worker, std::uint32_t first, std::uint32_t end) {
    for (const std::uint32_t i : in.awake.subspan(first, end - first)) {
      const SolverBody& body = on[on.number(i)];
      if (body.settled || bodies.quarantined[i] != 0) continue;
      if (!drift(bodies, i, body, in.h)) give_up(i, worker);
    }
  };
  in.pool.for_ranges(std::uint32_t(in.awake.size()), 64, drift_all);
  for (Bench& bench : benches) bench.work.exact_joints.commit(bodies);
  for (const std::uint32_t i : in.kinematic) carry(bodies, i, in.h);
}

}

void Impulse2007Solver::reserve(std::uint32_t slots) { memory_->bodies.reserve(slots); }

void Impulse2007Solver::advance(const StepView& in, StepOutcome& out) {
  SolverBodies& on = memory_->bodies;
  std::vector<Bench>& benches = memory_->benches;
  benches.resize(in.pool.workers());
  for (Bench& bench : benches) bench.out.clear(), bench.work.exact_joints.reset();
  on.reset(in.awake, in.kinematic, in.bodies.size());
  for (const std::uint32_t i : in.kinematic) on[on.number(i)] = solver_body(in.bodies, i);
  if (in.pool.workers() == 1 || take_turns(in)) {
    for (const Island& island : in.islands) solve(in, island, on, benches[0]);
  } else {
    Jobs& jobs = memory_->jobs;
    jobs.plan(in.islands);
    in.pool.for_each(std::uint32_t(jobs.runs.size()), [&](std::uint32_t worker, std::uint32_t run) {
      const auto [first, end] = jobs.runs[run];
      for (std::uint32_t k = first; k < end; ++k) solve(in, in.islands[jobs.islands[k]], on, benches[worker]);
    });
  }
  move(in, on, benches);
  for (const Bench& bench : benches) out.add(bench.out);
  std::ranges::sort(out.hits, {}, &StepOutcome::Hit::contact);
  std::ranges::sort(out.broken);
}

}
