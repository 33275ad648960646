#include "dynamics/free_joints.h"

#include <algorithm>

#include "dynamics/integrate.h"
#include "dynamics/islands.h"

namespace sudar::inline SUDAR_PRECISION {

namespace {

constexpr std::int64_t most_cost = 100'000;  // multiplications: chains, trees, small nets
// What a part of a sub-step resolves, as an angle: a turn, and a swing ωh (which grows without bound from 2 on).
constexpr Real widest_turn = Real(0.25), widest_swing = Real(0.5);
constexpr int most_for_turn = 16, most_for_swing = 2;  // tauter: as a chain that snaps straight, which no step resolves

int parts_for(Real angle, Real widest, int most) {
  const Real parts = angle / widest;
  return parts < Real(most) ? 1 + int(parts) : most + 1;
}

}

void FreeJoints::advance(std::vector<JointSolve>& joints, const Joints& state, Bodies& bodies, const Forces& forces,
                         std::span<const std::uint8_t> touched, Real length_unit, Real h) {
  std::vector<JointSystem::Joint> list;
  const auto answers = [&](std::uint32_t i) { return i != no_body && bodies.dynamic(i) ? i : JointSystem::nobody; };
  for (const JointSolve& j : joints) list.push_back({answers(j.a), answers(j.b), int(j.rows().size())});
  if (list != list_) regroup(list, joints, bodies.size());
  list_ = std::move(list);

  const Scene scene{joints, state, bodies, forces, Real(0.02) * length_unit};
  on_.reset(bodies.size());
  tension_.resize(bodies.size()), pulls_.resize(bodies.size());
  for (Group& g : groups_) {
    const bool hindered = !g.system || std::any_of(g.joints.begin(), g.joints.end(), [&](std::uint32_t k) {
      return joints[k].rows().empty() || joints[k].bounded() || joints[k].error() > scene.wide;
    }) || std::any_of(g.moving.begin(), g.moving.end(), [&](std::uint32_t i) { return touched[i] != 0; });
    if (hindered) continue;
    // The tension is known only afterwards; where it was more than the parts could resolve, once more with more of
    // them.
    const int for_turn = min(most_for_turn, parts_for(fastest_turn(g, bodies) * h, widest_turn, most_for_turn));
    int for_swing = parts_for(swing(g, scene, h), widest_swing, most_for_swing), tried = 0;
    bool well = true;
    while (well && for_swing > tried) {
      tried = for_swing;
      well = for_swing <= most_for_swing && move(g, scene, h, max(for_turn, for_swing));
      for_swing = parts_for(swing(g, scene, h), widest_swing, most_for_swing);
    }
    if (!well) {
      gather(g, scene);
      for (const std::uint32_t k : g.joints) joints[k].restart(state, bodies, on_);
      continue;
    }
    for (const std::uint32_t k : g.joints) joints[k].free = true;
    for (const std::uint32_t i : g.dynamic) moves_[i] = 1;
    moved_.insert(moved_.end(), after_.begin(), after_.end());
  }
}

void FreeJoints::commit(Bodies& bodies) { restore(moved_, bodies); }

Real FreeJoints::fastest_turn(const Group& g, const Bodies& bodies) {
  Real fastest = 0;
  for (const std::uint32_t i : g.dynamic) fastest = max(fastest, length(bodies.spin[i]));
  return fastest;
}

// A link pulled on both sides swings to and fro about its middle, Iω² = r·F (Tournier et al. 2015, geometric
// stiffness). By the impulses of the joints; the largest ωh.
Real FreeJoints::swing(const Group& g, const Scene& s, Real h) {
  for (const std::uint32_t i : g.moving) tension_[i] = 0, pulls_[i] = 0;
  for (const std::uint32_t k : g.joints) {
    const JointSolve& j = s.joints[k];
    const Vec3 pull = j.linear_impulse();
    const auto add = [&](std::uint32_t body, const Pos& anchor, Real sign) {
      if (body == no_body) return;
      const Real moment = sign * dot(anchor - s.bodies.position[body], pull);
      if (moment > 0) tension_[body] += moment, ++pulls_[body];
    };
    add(j.a, anchor_a(s.state, s.bodies, j.joint()), 1);
    add(j.b, anchor_b(s.state, s.bodies, j.joint()), -1);
  }
  Real largest = 0;  // (ωh)²
  for (const std::uint32_t i : g.dynamic) {
    if (pulls_[i] > 1) largest = max(largest, h * tension_[i] / max_component(s.bodies.inertia[i]));
  }
  return sqrt(largest);
}

// Leaves the bodies where they were and their motion in after_. False: it did not succeed.
bool FreeJoints::move(Group& g, const Scene& s, Real h, int parts) {
  save(g.moving, s.bodies, before_);
  for (const std::uint32_t k : g.joints) s.joints[k].forget_impulse();
  gather(g, s);
  bool well = true;
  prepare(g, s);
  for (int n = 0; n < parts && well; ++n) well = part(g, s, h / Real(parts));
  for (const std::uint32_t i : g.dynamic)
    well = well && sudar::drift(s.bodies, i, on_[i], 0);  // takes over the last kick
  for (const std::uint32_t k : g.joints) well = well && s.joints[k].error() <= s.wide;
  const auto carried = [&](std::uint32_t i) { return !s.bodies.dynamic(i) && s.bodies.moves(i); };
  const bool closed = std::none_of(g.moving.begin(), g.moving.end(), carried);  // else the carrier does work
  well = well && (!closed || energy_made(s, h) <= 1e-3);
  save(g.dynamic, s.bodies, after_);
  restore(before_, s.bodies);
  return well;
}

// Kinetic energy that no force brought, as a share of the kinetic energy and what the forces do over a radius. Some
// tenths of a thousandth are the method's; more comes where links snap straight, which no step resolves.
double FreeJoints::energy_made(const Scene& s, Real h) const {
  const Bodies& b = s.bodies;
  double made = 0, all = 0;
  const auto kinetic = [&](std::uint32_t i, const Vec3& v, const Vec3& w, const Vec3& angular_momentum) {
    return 0.5 * (double(b.mass[i]) * double(dot(v, v)) + double(dot(w, angular_momentum)));
  };
  for (const Saved& m : before_) {
    if (!b.dynamic(m.body)) continue;
    const Wrench& load = loads_[m.body];
    const double work = double(dot(load.force, b.position[m.body] - m.position)) +
                        double(dot(load.torque, (b.spin[m.body] + m.spin) * (h / 2)));
    const double before = kinetic(m.body, m.velocity, m.spin, m.angular_momentum);
    const double after = kinetic(m.body, b.velocity[m.body], b.spin[m.body], b.angular_momentum[m.body]);
    made += after - before - work;
    all += after + double(length(load.force) * b.radius[m.body]);
  }
  return all > 0 ? made / all : 0;
}

bool FreeJoints::part(Group& g, const Scene& s, Real h) {
  kick(g, s, h / 2);
  solve(g, s, [&](const PreparedRow& row, Real speed) { return -speed - row.error / h; });
  constexpr int repeats = 2;  // the second keeps a double pendulum's energy to 0.1 % over a minute, one to 1 %
  for (int repeat = 0; repeat < repeats; ++repeat) {
    save(g.moving, s.bodies, trial_);
    const bool well = drift(g, s, h);
    for (std::size_t n = 0; n < g.joints.size(); ++n) {
      const JointRows end = rows_of(s.state, s.bodies, s.joints[g.joints[n]].joint());
      for (std::size_t r = 0; r < std::size_t(end.count); ++r) impulses_[n][r] = -end.rows[r].error / h;
    }
    restore(trial_, s.bodies);
    if (!well) return false;
    apply(g, s);
  }
  if (!drift(g, s, h)) return false;
  gather(g, s);
  kick(g, s, h / 2);
  prepare(g, s);
  solve(g, s, [](const PreparedRow&, Real speed) { return -speed; });
  return true;
}

bool FreeJoints::drift(const Group& g, const Scene& s, Real h) {
  bool well = true;
  for (const std::uint32_t i : g.moving) {
    if (s.bodies.dynamic(i))
      well = well && sudar::drift(s.bodies, i, on_[i], h);
    else
      carry(s.bodies, i, h);
  }
  return well;
}

void FreeJoints::gather(const Group& g, const Scene& s) {
  for (const std::uint32_t i : g.moving) on_[i] = solver_body(s.bodies, i);
}

void FreeJoints::kick(const Group& g, const Scene& s, Real h) {
  evaluate(s.forces, s.bodies, g.dynamic, s.bodies.position, s.bodies.orientation, loads_);
  for (const std::uint32_t i : g.dynamic) accelerate(s.bodies, i, loads_[i], drag_on(s.forces, s.bodies, i), h, on_[i]);
}

// Rows and system where the bodies are now.
void FreeJoints::prepare(Group& g, const Scene& s) {
  rows_.clear();
  for (const std::uint32_t k : g.joints) {
    s.joints[k].renew_rows(s.state, s.bodies, on_);
    rows_.push_back(s.joints[k].rows());
  }
  g.system->factor(rows_);
  impulses_.assign(g.joints.size(), {});
}

template <class Ask>
void FreeJoints::solve(Group& g, const Scene& s, Ask ask) {
  for (std::size_t n = 0; n < g.joints.size(); ++n) {
    const JointSolve& j = s.joints[g.joints[n]];
    for (std::size_t r = 0; r < j.rows().size(); ++r) {
      impulses_[n][r] = ask(j.rows()[r], j.rows()[r].speed(on_[j.a].real, on_[j.b].real));
    }
  }
  apply(g, s);
}

// What impulses_ asks for.
void FreeJoints::apply(Group& g, const Scene& s) {
  g.system->solve(impulses_);
  for (std::size_t n = 0; n < g.joints.size(); ++n) s.joints[g.joints[n]].apply(on_, impulses_[n]);
}

void FreeJoints::save(std::span<const std::uint32_t> bodies, const Bodies& b, std::vector<Saved>& to) {
  to.clear();
  for (const std::uint32_t i : bodies) {
    to.push_back({i, b.position[i], b.orientation[i], b.velocity[i], b.angular_momentum[i], b.spin[i]});
  }
}

void FreeJoints::restore(const std::vector<Saved>& from, Bodies& b) {
  for (const Saved& m : from) {
    b.position[m.body] = m.position, b.orientation[m.body] = m.orientation;
    b.velocity[m.body] = m.velocity, b.angular_momentum[m.body] = m.angular_momentum, b.spin[m.body] = m.spin;
  }
}

void FreeJoints::regroup(const std::vector<JointSystem::Joint>& list, const std::vector<JointSolve>& joints,
                         std::uint32_t slots) {
  Islands islands;
  islands.reset(slots);
  for (const JointSystem::Joint& j : list) {
    if (j.a != JointSystem::nobody && j.b != JointSystem::nobody) islands.unite(j.a, j.b);
  }
  groups_.clear();
  constexpr std::uint32_t none = 0xffffffffu;
  std::vector<std::uint32_t> group_of(slots, none);
  for (std::uint32_t k = 0; k < list.size(); ++k) {
    const std::uint32_t some = list[k].a != JointSystem::nobody ? list[k].a : list[k].b;
    std::uint32_t& group = group_of[islands.root(some)];
    if (group == none) group = std::uint32_t(groups_.size()), groups_.emplace_back();
    Group& g = groups_[group];
    g.joints.push_back(k);
    for (const std::uint32_t i : {joints[k].a, joints[k].b}) {
      if (i != no_body) g.moving.push_back(i);
    }
    for (const std::uint32_t i : {list[k].a, list[k].b}) {
      if (i != JointSystem::nobody) g.dynamic.push_back(i);
    }
  }
  const auto tidy = [](std::vector<std::uint32_t>& bodies) {
    std::sort(bodies.begin(), bodies.end());
    bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
  };
  for (Group& g : groups_) {
    tidy(g.moving), tidy(g.dynamic);
    std::vector<JointSystem::Joint> own;
    for (const std::uint32_t k : g.joints) own.push_back(list[k]);
    g.system = JointSystem::plan(own, most_cost);
  }
}

}
