#include "dynamics/exact_joints.h"

#include <algorithm>

#include "dynamics/integrate.h"

namespace sudar::inline SUDAR_PRECISION {

namespace {

// What a part of a sub-step resolves, as an angle: a turn, and a swing ωh (which grows without bound from 2 on).
constexpr Real widest_turn = Real(0.25), widest_swing = Real(0.5);
constexpr int most_for_turn = 16, most_for_swing = 2;

int parts_for(Real angle, Real widest, int most) {
  const Real parts = angle / widest;
  return parts < Real(most) ? 1 + int(parts) : most + 1;
}

}

void ExactJoints::advance(SubStep& s, std::span<const JointGroup> groups, const Drives& drives) {
  for (const JointGroup& group : groups) {
    const Group g{s, *group.component, group.joints, drives, Real(0.02) * s.in.config.length_unit};
    if (hindered(g)) continue;
    if (!advance(g)) {
      gather(g);
      for (std::size_t n = 0; n < g.joints.size(); ++n) g.joint(n).restart(s.in.joint_state, s.in.bodies, s.on);
      continue;
    }
    for (std::size_t n = 0; n < g.joints.size(); ++n) {
      g.joint(n).exact = true;
      if (g.joint(n).driven()) g.joint(n).set_drive_impulse(drives.impulse(g.joints[n]));
    }
    for (const std::uint32_t i : g.component.dynamic) g.on(i).settled = true;
    moved_.insert(moved_.end(), after_.begin(), after_.end());
  }
}

void ExactJoints::commit(Bodies& bodies) { restore(moved_, bodies); }

bool ExactJoints::hindered(const Group& g) {
  const auto joint = [&](std::uint32_t k) {
    const JointSolve& j = g.s.joint_rows[k];
    return (j.rows().empty() && !j.driven()) || j.sprung() || j.near_limit() || j.error() > g.wide;
  };
  const auto touches = [&](std::uint32_t i) { return g.on(i).touches; };
  return !g.component.system || std::ranges::any_of(g.joints, joint) ||
         std::ranges::any_of(g.component.dynamic, touches);
}

// The tension is known only afterwards; where it was more than the parts could resolve, once more with more of them.
bool ExactJoints::advance(const Group& g) {
  const Real h = g.s.h;
  const int for_turn = min(most_for_turn, parts_for(fastest_turn(g) * h, widest_turn, most_for_turn));
  int for_swing = parts_for(swing(g, h), widest_swing, most_for_swing), tried = 0;
  bool well = true;
  added_.clear();
  while (well && for_swing > tried) {
    tried = for_swing;
    well = for_swing <= most_for_swing && move(g, max(for_turn, for_swing));
    for_swing = parts_for(swing(g, h), widest_swing, most_for_swing);
  }
  if (for_swing <= most_for_swing) return well;
  // What goes round may be exactly as long as its span: then no motion is free, and no inertia is enough.
  if (g.component.system->loops()) return false;
  constexpr int most_tries = 3;  // tension comes with a jerk
  for (int n = 0; n < most_tries && (n == 0 || (well && swings_beyond(g))); ++n) {
    slow_swings(g);
    well = move(g, for_turn);
    swing(g, h);
  }
  return well;
}

Real ExactJoints::fastest_turn(const Group& g) {
  Real fastest = 0;
  for (const std::uint32_t i : g.component.dynamic) fastest = max(fastest, length(g.bodies().spin[i]));
  return fastest;
}

// A link pulled on both sides swings to and fro about its middle, Iω² = r·F (Tournier et al. 2015, geometric
// stiffness). By the impulses of the joints; the largest ωh.
Real ExactJoints::swing(const Group& g, Real h) {
  const Bodies& bodies = g.bodies();
  const Joints& state = g.s.in.joint_state;
  tension_.assign(g.component.dynamic.size(), 0), pulls_.assign(g.component.dynamic.size(), 0);
  for (std::size_t n = 0; n < g.joints.size(); ++n) {
    const std::uint32_t joint = g.component.joints[n];
    const Vec3 pull = g.joint(n).linear_impulse();
    const auto add = [&](std::uint32_t body, const Pos& anchor, Real sign) {
      const auto at = std::ranges::lower_bound(g.component.dynamic, body);
      if (at == g.component.dynamic.end() || *at != body) return;
      const Real moment = sign * dot(anchor - bodies.position[body], pull);
      const std::size_t k = std::size_t(at - g.component.dynamic.begin());
      if (moment > 0) tension_[k] += moment, ++pulls_[k];
    };
    add(state.a[joint], anchor_a(state, bodies, joint), 1);
    add(state.b[joint], anchor_b(state, bodies, joint), -1);
  }
  Real largest = 0;  // (ωh)²
  for (std::size_t k = 0; k < tension_.size(); ++k) {
    const Vec3& inertia = bodies.inertia[g.component.dynamic[k]];
    if (pulls_[k] > 1) largest = max(largest, h * tension_[k] / max_component(inertia));
  }
  return sqrt(largest);
}

// Leaves the bodies where they were and their motion in after_. False: it did not succeed.
bool ExactJoints::move(const Group& g, int parts) {
  Bodies& bodies = g.bodies();
  const JointComponent& c = g.component;
  save(c.bodies, bodies, before_);
  for (std::size_t n = 0; n < g.joints.size(); ++n) g.joint(n).forget_impulse();
  take_up(g);
  constexpr Real damping = Real(0.25);  // of what implicit Euler would take from such a swing
  for (std::size_t k = 0; k < added_.size(); ++k) {
    g.on(c.dynamic[k]).real.w *= broadcast(1 / (1 + damping * added_[k] / largest_inertia(g, k)));
  }
  bool well = true;
  prepare(g);
  rates_before_ = rates(g);
  for (int n = 0; n < parts && well; ++n) well = part(g, g.s.h / Real(parts));
  for (const std::uint32_t i : c.dynamic)
    well = well && sudar::drift(bodies, i, g.on(i), 0);  // takes over the last kick
  for (std::size_t n = 0; n < g.joints.size(); ++n) well = well && g.joint(n).error() <= g.wide;
  const auto carried = [&](std::uint32_t i) { return !bodies.dynamic(i) && bodies.moves(i); };
  const bool closed = std::ranges::none_of(c.bodies, carried);  // else the carrier does work
  well = well && (!closed || energy_made(g) <= 1e-3);
  save(c.dynamic, bodies, after_);
  restore(before_, bodies);
  return well;
}

// Kinetic energy that no force brought, as a share of the kinetic energy and what the forces do over a radius. Some
// tenths of a thousandth are the method's; more comes where links snap straight, which no step resolves.
double ExactJoints::energy_made(const Group& g) const {
  const Bodies& b = g.bodies();
  double made = 0, all = 0;
  const auto kinetic = [&](std::uint32_t i, const Vec3& v, const Vec3& w, const Vec3& angular_momentum) {
    return 0.5 * (double(b.mass[i]) * double(dot(v, v)) + double(dot(w, angular_momentum)));
  };
  std::size_t k = 0;  // in the loads: both lists ascend
  for (const Saved& m : before_) {
    if (!b.dynamic(m.body)) continue;
    const Wrench& load = loads_[k++];
    const double work = double(dot(load.force, b.position[m.body] - m.position)) +
                        double(dot(load.torque, (b.spin[m.body] + m.spin) * (g.s.h / 2)));
    const double before = kinetic(m.body, m.velocity, m.spin, m.angular_momentum);
    const double after = kinetic(m.body, b.velocity[m.body], b.spin[m.body], b.angular_momentum[m.body]);
    made += after - before - work;
    all += after + double(length(load.force) * b.radius[m.body]);
  }
  const std::vector<Real> after = rates(g);
  for (std::size_t n = 0; n < g.joints.size(); ++n) {
    const double work = 0.5 * double(g.drives.impulse(g.joints[n])) * double(rates_before_[n] + after[n]);
    made -= work;
    all += work > 0 ? work : -work;
  }
  return all > 0 ? made / all : 0;
}

std::vector<Real> ExactJoints::rates(const Group& g) {
  std::vector<Real> rates;
  for (std::size_t n = 0; n < g.joints.size(); ++n) {
    rates.push_back(g.joint(n).driven() ? g.joint(n).rate(g.s.on) : Real(0));
  }
  return rates;
}

bool ExactJoints::part(const Group& g, Real h) {
  Bodies& bodies = g.bodies();
  kick(g, h / 2);
  solve(g, [&](const PreparedRow& row, Real speed) { return -speed - row.error / h; });
  constexpr int repeats = 2;  // the second keeps a double pendulum's energy to 0.1 % over a minute, one to 1 %
  for (int repeat = 0; repeat < repeats; ++repeat) {
    save(g.component.bodies, bodies, trial_);
    const bool well = drift(g, h);
    for (std::size_t n = 0; n < g.joints.size(); ++n) {
      const JointRows end = rows_of(g.s.in.joint_state, bodies, g.component.joints[n]);
      for (std::size_t r = 0; r < std::size_t(end.count); ++r) impulses_[n][r] = -end.rows[r].error / h;
    }
    restore(trial_, bodies);
    if (!well) return false;
    apply(g);
  }
  if (!drift(g, h)) return false;
  take_up(g);
  kick(g, h / 2);
  prepare(g);
  solve(g, [](const PreparedRow&, Real speed) { return -speed; });
  return true;
}

bool ExactJoints::drift(const Group& g, Real h) {
  bool well = true;
  for (const std::uint32_t i : g.component.bodies) {
    if (g.bodies().dynamic(i))
      well = well && sudar::drift(g.bodies(), i, g.on(i), h);
    else if (g.bodies().moves(i))
      carry(g.bodies(), i, h);
  }
  return well;
}

void ExactJoints::gather(const Group& g) {
  for (const std::uint32_t i : g.component.dynamic) g.on(i) = solver_body(g.bodies(), i);
}

// What a body k of the group must have besides its inertia so that its swing about its middle is slow enough. As the
// implicit Euler method sees it, tension is stiffness: I + h² r·F for I (Tournier et al. 2015).
Real ExactJoints::inertia_for_swing(const Group& g, std::size_t k) const {
  constexpr Real resolved = Real(0.1);  // of the inertia: what SHAKE and RATTLE resolve themselves
  return max(Real(0), Real(0.5) * g.s.h * tension_[k] - resolved * largest_inertia(g, k));
}

void ExactJoints::slow_swings(const Group& g) {
  added_.resize(tension_.size(), 0);
  for (std::size_t k = 0; k < added_.size(); ++k) added_[k] = max(added_[k], inertia_for_swing(g, k));
}

bool ExactJoints::swings_beyond(const Group& g) const {
  for (std::size_t k = 0; k < added_.size(); ++k) {
    if (inertia_for_swing(g, k) > 2 * added_[k] + largest_inertia(g, k)) return true;
  }
  return false;
}

Real ExactJoints::largest_inertia(const Group& g, std::size_t k) {
  return max_component(g.bodies().inertia[g.component.dynamic[k]]);
}

void ExactJoints::take_up(const Group& g) {
  gather(g);
  for (std::size_t k = 0; k < added_.size(); ++k) {
    if (added_[k] == 0) continue;
    const std::uint32_t i = g.component.dynamic[k];
    const Mat3 whole = g.bodies().inertia_world(i) + Mat3::diagonal({added_[k], added_[k], added_[k]});
    g.on(i).inverse_inertia = lanes(inverse(whole));
  }
}

void ExactJoints::kick(const Group& g, Real h) {
  evaluate(g.s.in.forces, g.bodies(), g.component.dynamic, loads_);
  for (std::size_t k = 0; k < loads_.size(); ++k) {
    const std::uint32_t i = g.component.dynamic[k];
    accelerate(g.bodies(), i, loads_[k], drag_on(g.s.in.forces, g.bodies(), i), h, g.on(i));
  }
  for (std::size_t n = 0; n < g.joints.size(); ++n) {
    const JointSolve& j = g.joint(n);
    if (j.driven()) j.apply_drive(g.s.on, g.drives.impulse(g.joints[n]) * (h / g.s.h));
  }
}

// Rows and system where the bodies are now.
void ExactJoints::prepare(const Group& g) {
  rows_.clear();
  for (std::size_t n = 0; n < g.joints.size(); ++n) {
    g.joint(n).renew_rows(g.s.in.joint_state, g.bodies(), g.s.on);
    rows_.push_back(g.joint(n).rows());
  }
  g.component.system->factor(rows_);
  impulses_.assign(g.joints.size(), {});
}

template <class Ask>
void ExactJoints::solve(const Group& g, Ask ask) {
  for (std::size_t n = 0; n < g.joints.size(); ++n) {
    const JointSolve& j = g.joint(n);
    for (std::size_t r = 0; r < j.rows().size(); ++r) {
      impulses_[n][r] = ask(j.rows()[r], j.rows()[r].speed(g.s.on[j.a].real, g.s.on[j.b].real));
    }
  }
  apply(g);
}

// What impulses_ asks for.
void ExactJoints::apply(const Group& g) {
  g.component.system->solve(impulses_);
  for (std::size_t n = 0; n < g.joints.size(); ++n) g.joint(n).apply(g.s.on, impulses_[n]);
}

void ExactJoints::save(std::span<const std::uint32_t> bodies, const Bodies& b, std::vector<Saved>& to) {
  to.clear();
  for (const std::uint32_t i : bodies) {
    if (b.moves(i)) to.push_back({i, b.position[i], b.orientation[i], b.velocity[i], b.angular_momentum[i], b.spin[i]});
  }
}

void ExactJoints::restore(const std::vector<Saved>& from, Bodies& b) {
  for (const Saved& m : from) {
    b.position[m.body] = m.position, b.orientation[m.body] = m.orientation;
    b.velocity[m.body] = m.velocity, b.angular_momentum[m.body] = m.angular_momentum, b.spin[m.body] = m.spin;
  }
}

}
