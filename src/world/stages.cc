#include "world/stages.h"

#include <algorithm>

#include "base/float_state.h"
#include "base/room.h"
#include "base/text.h"
#include "base/timer.h"
#include "dynamics/rest.h"
#include "world/crowds.h"
#include "world/triangles.h"
#include "world/physical.h"

namespace sudar::inline SUDAR_PRECISION {

namespace {

Body handle(const World::Impl& w, std::uint32_t i) { return w.bodies.slots.handle<BodyTag>(i); }
ShapeId shape_handle(const World::Impl& w, std::uint32_t s) { return w.bodies.shapes.slots.handle<ShapeTag>(s); }

Events::Touch touch(const World::Impl& w, const ProxyPair& key) {
  const auto [a, b] = w.bodies_of(key);
  return {handle(w, a), handle(w, b), shape_handle(w, key.a), shape_handle(w, key.b)};
}

// Whether the pair can change in this sub-step: somebody dynamic is in it, and somebody moves.
bool can_change(const Bodies& b, const BodyPair& p) {
  return (b.dynamic(p.a) || b.dynamic(p.b)) && (b.moves(p.a) || b.moves(p.b));
}

bool touching(const PairRow& row) { return (row.manifold.bits & Manifold::touching) != 0; }

bool carries(const Bodies& b, std::uint32_t i) {
  return i != no_body && b.motion[i] == Motion::kinematic && b.moves(i);
}

// Wakes the sleeping side of a touching pair whose other side moves. What a kinematic body or a surface carries does not
// even grow quiet, however slow the journey.
void wake_sides(World::Impl& w, const ProxyPair& p) {
  const Bodies& b = w.bodies;
  const bool driven = b.shapes.surface_velocity[p.a] != Vec3{} || b.shapes.surface_velocity[p.b] != Vec3{};
  const auto [one, two] = w.bodies_of(p);
  for (const auto& [side, other] : {BodyPair{one, two}, BodyPair{two, one}}) {
    if (b.asleep[side] != 0 ? !b.moves(other) : !driven && !carries(b, other)) continue;
    w.wake_island(side);
  }
}

// The same along joints.
void wake_carried(World::Impl& w) {
  for (const std::uint32_t carrier : w.kinematic) {
    w.joint_graph.each_joint(carrier, [&](std::uint32_t j) {
      const std::uint32_t other = w.joints.a[j] == carrier ? w.joints.b[j] : w.joints.a[j];
      if (other != no_body) w.wake_island(other);
    });
  }
}

// Pairs whose boxes part, or whose bodies a joint forbids to touch, in the order of keys.
void end_pairs(World::Impl& w) {
  std::vector<std::uint32_t> ended;
  for (const std::uint32_t i : w.searched) {
    w.pairs.each(i, [&](std::uint32_t p) {
      if (!goes_on(w.pairs[p].key, w.proxies, w.planes)) ended.push_back(p);
    });
  }
  for (const BodyPair& parted : w.parted) {
    if (!w.bodies.slots.used(parted.a) || !w.bodies.slots.used(parted.b) || !w.forbidden(parted)) continue;
    w.bodies.each_shape(parted.a, [&](std::uint32_t s) {
      w.pairs.each(s, [&](std::uint32_t p) {
        const auto [a, b] = w.bodies_of(w.pairs[p].key);
        if (a == parted.b || b == parted.b) ended.push_back(p);
      });
    });
  }
  w.parted.clear();
  std::ranges::sort(ended, {}, [&](std::uint32_t p) { return w.pairs[p].order(); });
  ended.erase(std::unique(ended.begin(), ended.end()), ended.end());
  bool touched = false;  // any part of the pair whose parts go first
  for (const std::uint32_t p : ended) {
    const PairRow& row = w.pairs[p];
    touched |= row.row != no_row;
    if (row.part == no_part && std::exchange(touched, false)) w.events.ended.push_back(touch(w, row.key));
    w.end_pair(p);
  }
}

}

namespace {

// What was appended last is often the only part that is not in order.
template <class T>
void sort_once(std::vector<T>& list) {
  const auto rest = std::is_sorted_until(list.begin(), list.end());
  std::sort(rest, list.end());
  std::inplace_merge(list.begin(), rest, list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

}

void find_pairs(World::Impl& w) {
  w.settle_boxes();
  if (w.searched.empty()) return list_triangles(w);
  sort_once(w.searched);
  find_plane_pairs(w.planes, w.proxies, w.searched, w.found);
  sort_once(w.found);
  std::vector<std::uint32_t> partners;  // that `of` has already, ascending
  std::uint32_t of = no_body;
  for (const ProxyPair& key : w.found) {
    if (key.a != of) {
      of = key.a, partners.clear();
      w.pairs.each(of, [&](std::uint32_t p) { partners.push_back(w.pairs[p].key.b); });
      std::sort(partners.begin(), partners.end());
    }
    if (std::binary_search(partners.begin(), partners.end(), key.b) || w.forbidden(w.bodies_of(key))) continue;
    if (!goes_on(key, w.proxies, w.planes)) continue;  // was found, but moved on since
    const std::uint32_t pair = w.pairs.add(key);
    if (can_change(w.bodies, w.bodies_of(key))) w.pairs.activate(pair);
  }
  end_pairs(w);
  list_triangles(w);
  w.searched.clear(), w.found.clear();
}

namespace {

// A face that lies on another keeps its points while both hardly turn and hardly move along each other: points that
// wander with every rounding make stacks sway. (E. Catto's Box3D recycles contacts so.) Only separations follow.
bool keep_manifold(const World::Impl& w, PairRow& row, Real margin) {
  constexpr Real least_cosine = Real(0.9962);  // of half the turn: 10°
  Manifold& m = row.manifold;
  if (row.row == no_row || m.count < 3) return false;
  const Bodies& b = w.bodies;
  const ContactPlace& place = w.contacts.place[row.row];
  const auto [on_a, on_b] = w.bodies_of(row.key);
  const auto turn = [](const Quat& now, const Quat& then) { return now * conjugate(then); };
  const Quat turn_a = turn(b.orientation[on_a], place.a.q), turn_b = turn(b.orientation[on_b], place.b.q);
  if (abs(turn_a.w) < least_cosine || abs(turn_b.w) < least_cosine) return false;
  const Vec3 shift = (b.position[on_a] - place.a.p) - (b.position[on_b] - place.b.p);
  const Vec3 to_shape = rotate(place.a.q, b.shape_frame(row.key.a).p), apart = place.a.p - place.b.p;
  const Real radius = w.smaller_radius(row.key.a, row.key.b);
  const Real far = min(Real(0.02) * w.config.length_unit, Real(0.04) * radius);
  // Points along an edge stay where they are while all else of a box turns about it.
  const Vec3 turned = turn(turn_a, turn_b).vector();
  if (4 * length_squared(cross(turned, m.normal)) * square(radius) > square(far)) return false;
  std::array<Real, 4> separation;
  for (std::size_t k = 0; k < std::size_t(m.count); ++k) {
    const Vec3 ra = m.points[k].at + to_shape, rb = ra + apart;
    const Vec3 moved = shift + (rotate(turn_a, ra) - ra) - (rotate(turn_b, rb) - rb);
    if (length_squared(moved) > square(far)) return false;
    separation[k] = place.separation[k] + dot(m.normal, moved);
    if (separation[k] > margin) return false;
  }
  for (std::size_t k = 0; k < std::size_t(m.count); ++k) {
    m.points[k].separation = separation[k];
    m.points[k].match = std::int32_t(k);
  }
  m.bits = Manifold::touching | Manifold::kept;
  return true;
}

// Whether two that were apart come on so fast that their impact is left to stage `impact`, which knows its moment.
bool comes_fast(const World::Impl& w, const PairRow& row) {
  const Bodies& b = w.bodies;
  const auto [i, k] = w.bodies_of(row.key);
  const Manifold& m = row.manifold;
  const Pos origin = w.shape_poses[row.key.a].p;
  const Real time = Real(w.h * w.substeps_at_once());
  Real way = 0, gap = std::numeric_limits<Real>::infinity();
  for (std::size_t n = 0; n < std::size_t(m.count); ++n) {
    const Pos at = origin + m.points[n].at;
    const Vec3 u = (b.velocity[i] - b.velocity[k]) + (cross(b.spin[i], at - b.position[i]) - cross(b.spin[k], at - b.position[k]));
    way = max(way, -dot(u, m.normal) * time);
    gap = min(gap, m.points[n].separation);
  }
  if (!(way > gap)) return false;
  // Turned by so much, a body is not where a contact thinks that aims at the middle of the sub-step (curving.h).
  const bool whirls = w.detects_each_substep() && row.row == no_row && length(b.spin[i] - b.spin[k]) * time > Real(0.75);
  const Real unseen = w.unseen_depth(row.key.a, row.key.b);
  return (whirls && gap > -unseen) || (gap > 0 && way > World::Impl::leap * unseen);
}

void collide(World::Impl& w, std::uint32_t p) {
  PairWatch& watch = w.pairs.watches()[p];
  const std::uint32_t a = watch.a, b = watch.b;
  const Real margin = w.pair_margin(a, b);
  const double way = w.way[a] + w.way[b];
  if (watch.rests(way, double(margin))) return;
  w.looked_at[p] = 1;
  PairRow& row = w.pairs[p];
  if (!w.detects_each_substep() && keep_manifold(w, row, margin)) return;
  const Real apart = collide_pair(row, *w.geometries[a], w.shape_poses[a], *w.geometries[b], w.shape_poses[b],
                                  {margin, w.pair_turn(a, b)});
  constexpr double sure = 0.999;  // more than rounding takes away
  watch.until = apart < 0 ? -1 : way + sure * double(apart);
  if (row.manifold.count == 0 || !comes_fast(w, row)) return;
  row.manifold.count = 0;
  row.manifold.bits = row.row != no_row ? std::uint32_t(Manifold::ended) : 0;
  w.looked_at[p] = World::Impl::left_to_impact;
}

}

// Collides what can change; what that wakes can change too.
void collide(World::Impl& w) {
  const Bodies& b = w.bodies;
  w.kinematic = w.moving_kinematic.settle([&](std::uint32_t i) {
    return b.slots.used(i) && b.motion[i] == Motion::kinematic && b.moves(i);
  });
  wake_carried(w);
  std::vector<std::uint32_t> round = w.pairs.settle([&](const ProxyPair& key) { return can_change(b, w.bodies_of(key)); });
  w.looked_at.assign(w.pairs.rows().size(), 0);
  w.coming.clear();
  thin_crowds(w, round);
  while (!round.empty()) {
    w.pool->for_ranges(std::uint32_t(round.size()), 16, [&](std::uint32_t, std::uint32_t first, std::uint32_t end) {
      for (std::uint32_t k = first; k < end; ++k) collide(w, round[k]);
    });
    for (const std::uint32_t p : round) {
      if (w.looked_at[p] == World::Impl::left_to_impact) w.coming.push_back(p);
      if (w.looked_at[p] != 0 && touching(w.pairs[p])) wake_sides(w, w.pairs[p].key);
    }
    round = w.pairs.take_activated();
  }
}

namespace {

// Where its manifold was found.
void note_place(World::Impl& w, const PairRow& row) {
  ContactPlace& place = w.contacts.place[row.row];
  const auto [a, b] = w.bodies_of(row.key);
  place.a = w.bodies.center_pose(a), place.b = w.bodies.center_pose(b);
  for (std::size_t k = 0; k < 4; ++k) place.separation[k] = row.manifold.points[k].separation;
}

// Begin and end bits → events and contact rows; touching pairs → islands.
void link_contacts(World::Impl& w, std::vector<std::uint32_t>& touching_rows) {
  const Bodies& b = w.bodies;
  for (const std::uint32_t r : w.pairs.active()) {
    if (w.looked_at[r] == 0) continue;
    PairRow& row = w.pairs[r];
    const auto [a, c] = w.bodies_of(row.key);
    const bool is_part = row.part != no_part;
    if ((row.manifold.bits & (Manifold::began | Manifold::ended)) != 0 && is_part) w.note_touch(row.key);
    if ((row.manifold.bits & Manifold::began) != 0) {
      row.row = w.contacts.add();
      if (is_part) ++w.pairs[w.pairs.find(row.key)].touching;
      else w.events.begun.push_back(touch(w, row.key));
    }
    if ((row.manifold.bits & Manifold::ended) != 0) {
      w.contacts.remove(row.row);
      row.row = no_row;
      if (is_part) --w.pairs[w.pairs.find(row.key)].touching;
      else w.events.ended.push_back(touch(w, row.key));
    }
    if (!touching(row)) continue;
    if ((row.manifold.bits & Manifold::kept) == 0) note_place(w, row);
    touching_rows.push_back(r);
    if (b.dynamic(a) && b.dynamic(c)) w.unions.unite(a, c);
  }
}

// What a body will be over within the step is no contact yet, and the solver may look again in its sub-steps.
std::vector<std::uint32_t> near_rows(const World::Impl& w) {
  std::vector<std::uint32_t> near;
  if (w.detects_each_substep() || w.meshes.empty()) return near;
  for (const std::uint32_t r : w.pairs.active()) {
    const PairRow& row = w.pairs[r];
    if (row.part == no_part || touching(row) || w.looked_at[r] == World::Impl::left_to_impact) continue;
    const auto [a, b] = w.bodies_of(row.key);
    if (w.bodies.awake(a) || w.bodies.awake(b)) near.push_back(r);
  }
  return near;
}

// Of pairs of several parts: what began and ceased to touch as a whole.
void link_wholes(World::Impl& w) {
  std::ranges::sort(w.touched_before, {}, [&](const TouchBefore& t) { return w.pairs[t.pair].order(); });
  for (const TouchBefore& t : w.touched_before) {
    const PairRow& row = w.pairs[t.pair];
    if ((row.touching > 0) == t.touching) continue;
    (t.touching ? w.events.ended : w.events.begun).push_back(touch(w, row.key));
  }
  w.touched_before.clear();
}

// A body of the joint that is awake, or no_body.
std::uint32_t awake_side(const World::Impl& w, std::uint32_t j) {
  for (const std::uint32_t i : {w.joints.a[j], w.joints.b[j]}) {
    if (i != no_body && w.bodies.awake(i)) return i;
  }
  return no_body;
}

void link_joints(World::Impl& w, std::span<const std::uint32_t> active) {
  for (const std::uint32_t j : active) {
    const std::uint32_t a = w.joints.a[j], c = w.joints.b[j];
    if (a != no_body && c != no_body && w.bodies.dynamic(a) && w.bodies.dynamic(c)) w.unions.unite(a, c);
  }
}

// Islands in the order of their roots, and every list in that of islands.
void list_islands(World::Impl& w, std::span<const std::uint32_t> awake, std::span<const std::uint32_t> touching_rows,
                  std::span<const std::uint32_t> near_rows, std::span<const std::uint32_t> joints) {
  const Bodies& b = w.bodies;
  w.islands.clear();
  make_room(w.island_of, b.size());
  for (const std::uint32_t i : awake) {
    if (w.unions.root(i) != i) continue;
    w.island_of[i] = std::uint32_t(w.islands.size());
    w.islands.emplace_back();
  }
  for (const std::uint32_t i : awake) w.island_of[i] = w.island_of[w.unions.root(i)];
  const auto of_body = [&](std::uint32_t i) { return w.island_of[i]; };
  const auto of_pair = [&](std::uint32_t r) {
    const auto [one, two] = w.bodies_of(w.pairs[r].key);
    return w.island_of[b.dynamic(one) ? one : two];
  };
  const auto of_joint = [&](std::uint32_t j) { return w.island_of[awake_side(w, j)]; };
  sort_by_island(w.islands, &Island::bodies, awake, of_body, w.awake);
  sort_by_island(w.islands, &Island::contacts, touching_rows, of_pair, w.touching);
  sort_by_island(w.islands, &Island::near, near_rows, of_pair, w.near);
  sort_by_island(w.islands, &Island::joints, joints, of_joint, w.active_joints);
  for (Island& island : w.islands) island.linked = island.contacts.count > 0 || island.joints.count > 0;
  const auto list = [&](std::span<const std::uint32_t> pairs, std::vector<ActiveContact>& contacts) {
    contacts.clear();
    for (const std::uint32_t r : pairs) {
      const PairRow& row = w.pairs[r];
      const auto [one, two] = w.bodies_of(row.key);
      contacts.push_back({one, two, row.key.a, row.key.b, row.part, row.row, &row.manifold, w.pair_material(row.key)});
    }
  };
  list(w.touching, w.active_contacts), list(w.near, w.near_contacts);
}

// Free bodies whose forces are smooth enough for an explicit method of high order: it needs h · rate < 1.
void list_smooth(World::Impl& w) {
  w.smooth.clear();
  if (w.config.integrator != Integrator::rk4) return;
  for (const Island& island : w.islands) {
    if (island.linked) continue;
    for (const std::uint32_t i : island.bodies.of(std::span<const std::uint32_t>(w.awake))) {
      const DragRates drag = drag_on(w.forces, w.bodies, i);
      const Real linear = drag.linear + drag.quadratic * length(w.bodies.velocity[i]);
      const Real angular = drag.angular + drag.angular_quadratic * length(w.bodies.spin[i]);
      if (Real(w.h) * max(linear, angular) < 1) w.smooth.push_back(i);
    }
  }
}

}

void link(World::Impl& w) {
  const Bodies& b = w.bodies;
  std::vector<std::uint32_t> touching_rows;
  const auto& awake = w.awake_bodies.settle([&](std::uint32_t i) { return b.slots.used(i) && b.awake(i); });
  const auto& joints = w.awake_joints.settle([&](std::uint32_t j) {
    return w.joints.slots.used(j) && awake_side(w, j) != no_body;
  });
  w.unions.reset(b.size(), awake);
  link_contacts(w, touching_rows);
  link_wholes(w);
  link_joints(w, joints);
  w.joint_graph.settle(w.joints, b);
  list_islands(w, awake, touching_rows, near_rows(w), joints);
  list_smooth(w);
}

void solve(World::Impl& w) {
  StepOutcome& outcome = w.outcome;
  outcome.hits.clear(), outcome.broken.clear();
  outcome.points = 0;
  make_room(w.departures, w.bodies.size());
  for (const std::vector<std::uint32_t>* moving : {&w.awake, &w.kinematic}) {
    for (const std::uint32_t i : *moving) w.departures[i] = w.bodies.center_pose(i);
  }
  const StepView view = w.view();
  switch (w.config.solver) {
    case Solver::impulse_2007: w.impulse_2007.advance(view, outcome); break;
    case Solver::soft_step: w.soft_step.advance(view, outcome); break;
  }
  for (const StepOutcome::Hit& hit : outcome.hits) {
    const ActiveContact& c = w.active_contacts[hit.contact];
    w.events.hits.push_back(
        {handle(w, c.a), handle(w, c.b), w.bodies.position[c.a] + hit.at, c.manifold->normal, hit.speed});
  }
  for (const std::uint32_t i : outcome.broken) {
    w.bodies.velocity[i] = w.bodies.spin[i] = w.bodies.angular_momentum[i] = {};
    w.joint_graph.body_changed(i);
    w.events.quarantined.push_back({handle(w, i), "its velocity is not finite any more"});
  }
}

void refit(World::Impl& w) {
  std::vector<std::vector<std::uint32_t>> left(w.pool->workers());  // their boxes, by worker
  for (const std::vector<std::uint32_t>* moving : {&w.awake, &w.kinematic}) {
    const auto follow = [&](std::uint32_t worker, std::uint32_t first, std::uint32_t end) {
      for (std::uint32_t k = first; k < end; ++k) {
        w.bodies.each_shape((*moving)[k], [&](std::uint32_t s) {
          if (w.renew_box(s, false)) left[worker].push_back(s);
        });
      }
    };
    w.pool->for_ranges(std::uint32_t(moving->size()), 64, follow);
  }
  for (const std::vector<std::uint32_t>& some : left) w.changed.insert(w.changed.end(), some.begin(), some.end());
}

// An island sleeps when each of its bodies rests. A body that touches nothing and hangs on nothing has nothing to rest
// on: in a weak field it only begins to fall.
void sleep(World::Impl& w) {
  Bodies& b = w.bodies;
  const double advanced = w.h * w.substeps_at_once();
  watch_rest(b, w.awake, w.config.length_unit, Real(advanced));
  if (!w.config.sleep || w.awake.empty()) return;
  HeldByFaces& held = w.held_by_faces;
  held.reset(b.size(), w.awake);
  for (const ActiveContact& c : w.active_contacts) {
    held.contact(c.a, c.b, w.contacts.impulse[c.slot], w.contacts.slipping[c.slot] != 0);
  }
  for (const std::uint32_t j : w.active_joints) held.joint(w.joints.a[j], w.joints.b[j]);
  for (const Island& island : w.islands) {
    const auto bodies = island.bodies.of(std::span<const std::uint32_t>(w.awake));
    const auto restless = [&](std::uint32_t i) {
      return !rests(b, i, held[i]) || b.may_sleep[i] == 0 || !b.dynamic(i);
    };
    if (!island.linked || std::ranges::any_of(bodies, restless)) continue;
    w.sleepers.add(bodies);
    for (const std::uint32_t i : bodies) {
      b.asleep[i] = 1;
      b.sleep_island[i] = bodies.front();
      b.velocity[i] = b.spin[i] = b.angular_momentum[i] = {};
    }
  }
}

namespace {

void sense(World::Impl& w, double dt) {
  for (std::uint32_t s = 0; s < w.sensor_slots.size(); ++s) {
    if (!w.sensor_slots.used(s)) continue;
    const Sensor& sensor = w.sensors[s];
    SensorMemory& memory = w.sensor_memory[s];
    const std::uint32_t a = sensor.a.index;
    const Vec3d v = convert<double>(w.bodies.velocity[a]);
    const Pos p = w.bodies.position[a], other = sensor.b.null() ? Pos{} : w.bodies.position[sensor.b.index];
    const auto distance = [](const Pos& x, const Pos& y) {
      return sqrt(square(x.x - y.x) + square(x.y - y.y) + square(x.z - y.z));
    };
    switch (sensor.kind) {
      case SensorKind::acceleration: memory.value = length(v - memory.velocity) / dt; break;
      case SensorKind::distance: memory.value = distance(p, other); break;
      case SensorKind::maximum_speed: memory.value = max(memory.value, length(v)); break;
      case SensorKind::odometer: memory.value += distance(p, memory.position); break;
    }
    memory.position = p;
    memory.velocity = v;
  }
}

}

void World::Impl::step(double dt) {
  const FloatState defaults;
  const Surroundings around = surroundings(forces, config, dt);
  check_step("dt", around);
  if (dt > config.dt) check_surroundings("dt", bodies, around);  // else its sources were checked
  events = {};
  outcome.clear();
  profile.stages.clear();
  stage_hashes.clear();
  for (const Stage& stage : stages) profile.stages.push_back({stage.name, 0});
  last_dt = dt;
  h = around.sub_step;  // thesis (3.4)
  const int rounds = substeps() / substeps_at_once();
  for (int n = 0; n < rounds; ++n) {
    for (std::size_t s = 0; s < std::size(stages); ++s) {
      const Timer timer;
      stages[s].run(*this);
      profile.stages[s].microseconds += timer.microseconds();
      if (recording && n == rounds - 1) stage_hashes.push_back(hash());
    }
  }
  for (const std::uint32_t i : pushed) bodies.force[i] = bodies.torque[i] = {};
  pushed.clear();
  sense(*this, around.step);
  if (around.step != clock_step) clock_start = time(), clock_steps = 0, clock_step = around.step;
  ++clock_steps;
  ++steps;
  profile.contacts = std::int64_t(active_contacts.size());
  profile.points = outcome.points;
  profile.collision = outcome.collision;
  profile.contact = outcome.contact;
  profile.correction = outcome.correction;
  profile.joint = outcome.joint;
  profile.awake = std::int64_t(awake.size());
}

}
