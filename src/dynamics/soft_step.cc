#include "dynamics/soft_step.h"

#include <algorithm>

#include "base/room.h"
#include "dynamics/integrate.h"
#include "dynamics/reference_islands.h"
#include "dynamics/soft_contacts.h"
#include "dynamics/soft_impacts.h"
#include "dynamics/soft_joints.h"

namespace sudar::inline SUDAR_PRECISION {

namespace {

class BatchSolver : public SoftBatch {
 public:
  explicit BatchSolver(const SoftBatch& batch)
      : SoftBatch(batch), joint_(softness(min(set_.joint_frequency, Real(0.25) / h_), set_.joint_damping, h_)) {}

  void run(std::span<const std::uint32_t> islands) {
    gather_bodies(islands);
    prepare_contacts(*this, islands);
    prepare_joints(*this, islands);
    const SoftPassTable& passes = soft_passes(set_.lanes);
    const PassSettings set{h_, set_.push_speed * unit_, set_.carry_loads ? soft_reach * unit_ : Real(0),
                           joint_.bias_rate, joint_.mass_scale, joint_.impulse_scale};
    const auto bodies = [&](auto pass) { pass(w_.motions.data(), w_.motions.size(), w_.bodies.data(), set); };
    const auto contacts = [&](auto pass) { pass(w_.rows.data(), w_.rows.size(), w_.bodies.data(), set); };
    const auto joints = [&](auto pass) { pass(w_.ball_rows.data(), w_.ball_rows.size(), w_.bodies.data(), set); };
    contacts(passes.answer);
    for (int k = 0; k < in_.substeps; ++k) {
      if (k > 0 && vary(in_.forces)) publish(), load_forces();
      strike_contacts(*this);
      bodies(passes.begin);
      leave_bouncing_alone(*this);
      if (k == 0) joints(passes.warm_balls), contacts(passes.warm);
      joints(passes.solve_balls);
      contacts(passes.solve);
      bodies(passes.drift);
      carry_kinematic();
      if (turned_far()) contacts(passes.answer_again);
      joints(passes.relax_balls);
      contacts(passes.relax);
      bodies(passes.settle);
    }
    publish();
    store_contacts(*this);
    store_joints(*this);
  }

 private:
  void gather_bodies(std::span<const std::uint32_t> islands) {
    w_.slots.assign(1, no_body);
    w_.slots.insert(w_.slots.end(), in_.kinematic.begin(), in_.kinematic.end());
    for (const std::uint32_t k : islands) {
      const auto bodies = in_.islands[k].bodies.of(in_.awake);
      w_.slots.insert(w_.slots.end(), bodies.begin(), bodies.end());
    }
    w_.bodies.assign(end() + SoftLanes::count, {});  // so that the last lanes have a place
    w_.motions.clear();
    for (std::uint32_t n = 1; n < first_mover(); ++n) {
      w_.bodies[n].v = in_.bodies.velocity[w_.slots[n]];
      w_.bodies[n].w = in_.bodies.spin[w_.slots[n]];
      w_.bodies[n].most_turn = std::numeric_limits<Real>::max();
    }
    w_.places.resize(end());
    for (std::uint32_t n = first_mover(); n < end(); ++n) gather(n);
    load_forces();
  }

  void gather(std::uint32_t n) {
    const Bodies& b = in_.bodies;
    const std::uint32_t slot = w_.slots[n], lane = lane_of(n);
    if (lane == 0) add_motion(n);
    SoftMotion& m = motion(n);
    ++m.used;
    if (!b.dynamic(slot)) return;
    SoftBody& body = w_.bodies[n];
    const Vec3 spin = spin_of(b, slot);
    const Quat& q = b.orientation[slot];
    w_.places[n] = b.position[slot];
    body.inverse_mass = b.inverse_mass[slot];
    body.v = b.velocity[slot], body.w = spin;
    set_inertia(body, b.inverse_inertia_world(slot));
    m.orientation.x[lane] = q.x, m.orientation.y[lane] = q.y, m.orientation.z[lane] = q.z, m.orientation.w[lane] = q.w;
    set(m.momentum, lane, b.angular_momentum[slot]), set(m.spin, lane, spin);
    set(m.inertia, lane, b.inertia[slot]), set(m.inverse_inertia, lane, b.inverse_inertia[slot]);
    body.most_turn = most_turn(b.inertia[slot]);
  }

  // Turned by θ, a body answers in a direction by up to (Imax / Imin − 1) θ² more than it did. What contacts know of it may
  // be wrong by a tenth: an answer twice as large would make passes diverge.
  static Real most_turn(const Vec3& inertia) {
    const Real largest = max(max(inertia.x, inertia.y), inertia.z), least = min(min(inertia.x, inertia.y), inertia.z);
    return Real(0.1) * least / max(largest - least, std::numeric_limits<Real>::min());
  }

  // Lanes without a body turn, too, and must stay finite.
  void add_motion(std::uint32_t first) {
    SoftMotion& m = w_.motions.emplace_back();
    m.first = first;
    for (std::uint32_t lane = 0; lane < SoftLanes::count; ++lane) {
      m.orientation.w[lane] = 1, m.falls[lane] = 1;
      set(m.inertia, lane, {1, 1, 1});
    }
  }

  void load_forces() {
    const auto slots = std::span(w_.slots).subspan(first_mover());
    evaluate(in_.forces, in_.bodies, slots, w_.loads);
    for (std::uint32_t n = first_mover(); n < end(); ++n) {
      if (!moves(n)) continue;
      SoftMotion& m = motion(n);
      SoftBody& body = w_.bodies[n];
      const std::uint32_t lane = lane_of(n);
      const Wrench& load = w_.loads[n - first_mover()];
      const Vec3 a = load.force * body.inverse_mass, turning = inverse_inertia(body) * load.torque;
      const DragRates drag = drag_on(in_.forces, in_.bodies, w_.slots[n]);
      set(m.acceleration, lane, a), set(m.angular_acceleration, lane, turning);
      m.drag[lane] = drag.linear, m.quadratic_drag[lane] = drag.quadratic;
      m.angular_drag[lane] = drag.angular, m.quadratic_angular_drag[lane] = drag.angular_quadratic;
      const Real step = h_ * Real(in_.substeps);
      if (!is_finite(body.v + a * step) || !is_finite(body.w + turning * step)) {
        give_up(n);  // before it can infect what it touches
        set(m.acceleration, lane, {}), set(m.angular_acceleration, lane, {}), set(m.momentum, lane, {}), set(m.spin, lane, {});
      }
    }
  }

  // Whether some body has in the last drift.
  bool turned_far() {
    bool far = false;
    for (SoftMotion& m : w_.motions) far |= std::exchange(m.turned_far, false);
    return far;
  }

  void give_up(std::uint32_t n) {
    const std::uint32_t slot = w_.slots[n];
    w_.bodies[n] = {};
    in_.bodies.quarantined[slot] = 1;
    w_.out.broken.push_back(slot);
  }

  void carry_kinematic() {
    for (std::uint32_t n = 1; n < first_mover(); ++n) {
      SoftBody& body = w_.bodies[n];
      body.shift += body.v * h_, body.turn += body.w * h_;
    }
  }

  // Motions → the bodies' state.
  void publish() {
    for (std::uint32_t n = first_mover(); n < end(); ++n) {
      if (!moves(n)) continue;
      const SoftMotion& m = motion(n);
      const std::uint32_t lane = lane_of(n), slot = w_.slots[n];
      const Quat q{m.orientation.x[lane], m.orientation.y[lane], m.orientation.z[lane], m.orientation.w[lane]};
      const BodyMotion at{w_.places[n] + w_.bodies[n].shift, q, w_.bodies[n].v, get(m.momentum, lane)};
      if (!place(in_.bodies, slot, at)) give_up(n);
    }
  }

  Softness joint_;
};

// Islands that are solved at once: enough to fill the lanes, few enough to stay in the caches and to share among workers.
// An island's bits do not depend on what is solved beside it.
struct Plan {
  std::vector<std::uint32_t> islands;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> batches;  // first, end in that list

  void make(const StepView& in) {
    constexpr std::uint32_t most = 2000, least = 200;
    const std::span<const Island> all = in.islands;
    const auto whole = std::uint32_t(in.contacts.size() + in.awake.size());
    const std::uint32_t workers = in.pool.workers();
    const std::uint32_t enough = workers == 1 ? most : std::clamp(whole / (4 * workers), least, most);
    const bool at_once = act_from_afar(in.forces);
    islands.clear(), batches.clear();
    std::uint32_t first = 0, cost = 0;
    for (std::uint32_t i = 0; i < all.size(); ++i) {
      if (ReferenceIslands::belongs(in, all[i])) continue;
      islands.push_back(i);
      cost += all[i].contacts.count + all[i].bodies.count;
      if (at_once || cost < enough) continue;
      batches.emplace_back(first, std::uint32_t(islands.size()));
      first = std::uint32_t(islands.size()), cost = 0;
    }
    if (first < islands.size()) batches.emplace_back(first, std::uint32_t(islands.size()));
  }
};

}

struct SoftStepSolver::Memory {
  std::vector<std::uint32_t> number_of;  // by slot: number in its batch; 0 but for what moves
  std::vector<SoftWorkspace> work;           // by worker
  Plan plan;
  ReferenceIslands reference;
};

SoftStepSolver::SoftStepSolver() : memory_(std::make_unique<Memory>()) {}
SoftStepSolver::SoftStepSolver(SoftStepSolver&&) noexcept = default;
SoftStepSolver& SoftStepSolver::operator=(SoftStepSolver&&) noexcept = default;
SoftStepSolver::~SoftStepSolver() = default;

void SoftStepSolver::advance(const StepView& in, StepOutcome& out) {
  Memory& m = *memory_;
  m.work.resize(in.pool.workers());
  for (SoftWorkspace& w : m.work) w.out.clear();
  ReferenceIslands::watch_crowds(in);
  m.plan.make(in);
  const bool carried = m.reference.advance(in, out);
  make_room(m.number_of, in.bodies.size());
  for (std::uint32_t k = 0; k < in.kinematic.size(); ++k) m.number_of[in.kinematic[k]] = k + 1;
  for (const auto& [first, end] : m.plan.batches) {
    auto next = std::uint32_t(in.kinematic.size()) + 1;
    for (std::uint32_t k = first; k < end; ++k) {
      for (const std::uint32_t i : in.islands[m.plan.islands[k]].bodies.of(in.awake)) m.number_of[i] = next++;
    }
  }
  in.pool.for_each(std::uint32_t(m.plan.batches.size()), [&](std::uint32_t worker, std::uint32_t k) {
    const auto [first, end] = m.plan.batches[k];
    BatchSolver(SoftBatch(in, m.number_of, m.work[worker])).run(std::span(m.plan.islands).subspan(first, end - first));
  });
  for (const auto& list : {in.awake, in.kinematic}) {
    for (const std::uint32_t i : list) m.number_of[i] = 0;
  }
  for (const std::uint32_t i : in.kinematic) {
    for (int k = 0; k < in.substeps && !carried; ++k) carry(in.bodies, i, in.h);
  }
  for (const SoftWorkspace& w : m.work) out.add(w.out);
  std::ranges::sort(out.hits, {}, &StepOutcome::Hit::contact);
  std::ranges::sort(out.broken);
}

}
