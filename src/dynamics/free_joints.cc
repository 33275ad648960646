#include "dynamics/free_joints.h"

#include <algorithm>

#include "dynamics/integrate.h"

namespace sudar::inline SUDAR_PRECISION {

namespace {

// What a part of a sub-step resolves, as an angle: a turn, and a swing ωh (which grows without bound from 2 on).
constexpr Real widest_turn = Real(0.25), widest_swing = Real(0.5);
constexpr int most_for_turn = 16, most_for_swing = 2;  // tauter: as a chain that snaps straight, which no step resolves

int parts_for(Real angle, Real widest, int most) {
  const Real parts = angle / widest;
  return parts < Real(most) ? 1 + int(parts) : most + 1;
}

}

void FreeJoints::advance(std::vector<JointSolve>& joints, const Joints& state, Bodies& bodies, const Forces& forces,
                         const Drives& drives, JointGroups& groups, std::span<const std::uint8_t> touched,
                         Real length_unit, Real h) {
  const Scene scene{joints, state, bodies, forces, drives, Real(0.02) * length_unit, h};
  on_.reset(bodies.size());
  tension_.resize(bodies.size()), pulls_.resize(bodies.size());
  for (JointGroup& g : groups.all()) {
    const bool hindered = !g.system || std::any_of(g.joints.begin(), g.joints.end(), [&](std::uint32_t k) {
      const JointSolve& j = joints[k];
      return (j.rows().empty() && !j.driven()) || j.sprung() || j.near_limit() || j.error() > scene.wide;
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
    for (const std::uint32_t k : g.joints) {
      joints[k].free = true;
      if (joints[k].driven()) joints[k].set_drive_impulse(drives.impulse(k));
    }
    for (const std::uint32_t i : g.dynamic) moves_[i] = 1;
    moved_.insert(moved_.end(), after_.begin(), after_.end());
  }
}

void FreeJoints::commit(Bodies& bodies) { restore(moved_, bodies); }

Real FreeJoints::fastest_turn(const JointGroup& g, const Bodies& bodies) {
  Real fastest = 0;
  for (const std::uint32_t i : g.dynamic) fastest = max(fastest, length(bodies.spin[i]));
  return fastest;
}

// A link pulled on both sides swings to and fro about its middle, Iω² = r·F (Tournier et al. 2015, geometric
// stiffness). By the impulses of the joints; the largest ωh.
Real FreeJoints::swing(const JointGroup& g, const Scene& s, Real h) {
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
bool FreeJoints::move(JointGroup& g, const Scene& s, Real h, int parts) {
  save(g.moving, s.bodies, before_);
  for (const std::uint32_t k : g.joints) s.joints[k].forget_impulse();
  gather(g, s);
  bool well = true;
  prepare(g, s);
  rates_before_ = rates(g, s);
  for (int n = 0; n < parts && well; ++n) well = part(g, s, h / Real(parts));
  for (const std::uint32_t i : g.dynamic)
    well = well && sudar::drift(s.bodies, i, on_[i], 0);  // takes over the last kick
  for (const std::uint32_t k : g.joints) well = well && s.joints[k].error() <= s.wide;
  const auto carried = [&](std::uint32_t i) { return !s.bodies.dynamic(i) && s.bodies.moves(i); };
  const bool closed = std::none_of(g.moving.begin(), g.moving.end(), carried);  // else the carrier does work
  well = well && (!closed || energy_made(g, s, h) <= 1e-3);
  save(g.dynamic, s.bodies, after_);
  restore(before_, s.bodies);
  return well;
}

// Kinetic energy that no force brought, as a share of the kinetic energy and what the forces do over a radius. Some
// tenths of a thousandth are the method's; more comes where links snap straight, which no step resolves.
double FreeJoints::energy_made(const JointGroup& g, const Scene& s, Real h) const {
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
  const std::vector<Real> after = rates(g, s);
  for (std::size_t n = 0; n < g.joints.size(); ++n) {
    const double work = 0.5 * double(s.drives.impulse(g.joints[n])) * double(rates_before_[n] + after[n]);
    made -= work;
    all += work > 0 ? work : -work;
  }
  return all > 0 ? made / all : 0;
}

std::vector<Real> FreeJoints::rates(const JointGroup& g, const Scene& s) const {
  std::vector<Real> rates;
  for (const std::uint32_t k : g.joints) rates.push_back(s.joints[k].driven() ? s.joints[k].rate(on_) : 0);
  return rates;
}

bool FreeJoints::part(JointGroup& g, const Scene& s, Real h) {
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

bool FreeJoints::drift(const JointGroup& g, const Scene& s, Real h) {
  bool well = true;
  for (const std::uint32_t i : g.moving) {
    if (s.bodies.dynamic(i))
      well = well && sudar::drift(s.bodies, i, on_[i], h);
    else
      carry(s.bodies, i, h);
  }
  return well;
}

void FreeJoints::gather(const JointGroup& g, const Scene& s) {
  for (const std::uint32_t i : g.moving) on_[i] = solver_body(s.bodies, i);
}

void FreeJoints::kick(const JointGroup& g, const Scene& s, Real h) {
  evaluate(s.forces, s.bodies, g.dynamic, s.bodies.position, s.bodies.orientation, loads_);
  for (const std::uint32_t i : g.dynamic) accelerate(s.bodies, i, loads_[i], drag_on(s.forces, s.bodies, i), h, on_[i]);
  for (const std::uint32_t k : g.joints) {
    const JointSolve& j = s.joints[k];
    if (j.driven()) j.coordinate().apply(on_[j.a].real, on_[j.b].real, s.drives.impulse(k) * (h / s.h));
  }
}

// Rows and system where the bodies are now.
void FreeJoints::prepare(JointGroup& g, const Scene& s) {
  for (const std::uint32_t k : g.joints) s.joints[k].renew_rows(s.state, s.bodies, on_);
  rows_of(g, s.joints, rows_);
  g.system->factor(rows_);
  impulses_.assign(g.joints.size(), {});
}

template <class Ask>
void FreeJoints::solve(JointGroup& g, const Scene& s, Ask ask) {
  for (std::size_t n = 0; n < g.joints.size(); ++n) {
    const JointSolve& j = s.joints[g.joints[n]];
    for (std::size_t r = 0; r < j.rows().size(); ++r) {
      impulses_[n][r] = ask(j.rows()[r], j.rows()[r].speed(on_[j.a].real, on_[j.b].real));
    }
  }
  apply(g, s);
}

// What impulses_ asks for.
void FreeJoints::apply(JointGroup& g, const Scene& s) {
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

}
