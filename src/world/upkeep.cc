// What several operations and stages need: boxes, sleep, pairs, and all that is a function of the state.
#include <algorithm>

#include "dynamics/rest.h"
#include "world/impl.h"

namespace sudar::inline SUDAR_PRECISION {

Material World::Impl::pair_material(const ProxyPair& key) const {
  const auto at = std::lower_bound(pair_materials.begin(), pair_materials.end(), key,
                                   [](const PairMaterial& m, const ProxyPair& k) { return m.key < k; });
  if (at != pair_materials.end() && at->key == key) return at->material;
  return mix(config, bodies.material[key.a], bodies.material[key.b]);
}

void World::Impl::settle_boxes() {
  if (changed.empty()) return;
  std::sort(changed.begin(), changed.end());
  changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
  broad->update(proxies, changed, found);
  searched.insert(searched.end(), changed.begin(), changed.end());
  changed.clear();
}

Real World::Impl::contact_margin(std::uint32_t i) const {
  const Real unit = config.length_unit;
  if (detects_each_substep()) return config.impulse_2007.slop * unit;
  const Real near = Real(0.01) * unit;
  return bodies.dynamic(i) ? min(near, Real(0.125) * bodies.radius[i]) : near;
}

// Who is looked at once a step must be seen before it arrives.
Real World::Impl::pair_margin(std::uint32_t a, std::uint32_t b) const {
  if (detects_each_substep()) return contact_margin(a);
  const Real way = length(bodies.velocity[a] - bodies.velocity[b]) * step_length();
  return contact_margin(a) + contact_margin(b) + min(way, smaller_radius(a, b));  // a thin body sees no farther than it is thick
}

// By its spin, and by what an end gains that comes on when the other is stopped.
Real World::Impl::pair_turn(std::uint32_t a, std::uint32_t b) const {
  if (detects_each_substep()) return 0;
  constexpr Real most = Real(0.25);
  const Real way = length(bodies.velocity[a] - bodies.velocity[b]) * step_length();
  return min(most, length(bodies.spin[a] - bodies.spin[b]) * step_length() + way / smaller_radius(a, b));
}

Real World::Impl::smaller_radius(std::uint32_t a, std::uint32_t b) const {
  Real least = std::numeric_limits<Real>::infinity();
  for (const std::uint32_t i : {a, b}) {
    if (bodies.dynamic(i)) least = min(least, bodies.radius[i]);
  }
  return least;
}

// The way of the coming step, m; none where contacts are looked for again before a body gets far.
Vec3 World::Impl::coming_way(std::uint32_t i) const {
  if (detects_each_substep()) return {};
  const Vec3 way = bodies.velocity[i] * step_length();
  const Real far = length(way), most = 4 * bodies.radius[i];
  return bodies.dynamic(i) && far > most ? way * (most / far) : way;
}

namespace {

Box stretched(Box box, const Vec3& along) {
  for (int k = 0; k < 3; ++k) (along[k] < 0 ? box.low : box.high)[k] += double(along[k]);
  return box;
}

}

bool World::Impl::renew_box(std::uint32_t i, bool force) {
  Proxy& proxy = proxies[i];
  proxy.filter = bodies.filter[i];
  proxy.fixed = bodies.motion[i] == Motion::fixed;
  proxy.present = bodies.slots.used(i) && bodies.quarantined[i] == 0 && !is_half_space(i);
  const Pose pose = bodies.shape_pose(i), before = std::exchange(shape_poses[i], pose);
  if (!proxy.present) return true;
  const Quat turn = pose.q * conjugate(before.q);  // twice its sine is the chord of a circle of radius 1
  way[i] += double(length(pose.p - before.p)) + 2 * double(length(turn.vector()) * geometry_of(i).bounding_radius);
  // The box holds the margin within which contacts are made, and room to move before it must be renewed.
  const Real margin = contact_margin(i);
  const Vec3 way = coming_way(i);
  if (!force && contains(proxy.box, stretched(bounds(geometry_of(i), pose, margin), way))) return false;
  const Real room = min(Real(0.125) * bodies.radius[i], Real(0.05) * config.length_unit);
  constexpr Real steps = 3;  // for which the box should do
  proxy.box = stretched(bounds(geometry_of(i), pose, margin + room), way * steps);
  return true;
}

void World::Impl::touch_proxy(std::uint32_t i, bool force) {
  if (renew_box(i, force)) changed.push_back(i);
}

void World::Impl::enlist(std::uint32_t i) {
  if (bodies.motion[i] == Motion::kinematic) moving_kinematic.add(i);
  else if (bodies.motion[i] == Motion::dynamic) awake_bodies.add(i);
  else return;
  pairs.each(i, [&](std::uint32_t p) { pairs.activate(p); });
  joint_graph.each_joint(i, [&](std::uint32_t j) { awake_joints.add(j); });
}

void World::Impl::enlist_joint(std::uint32_t j) {
  joint_graph.add(joints, j);
  awake_joints.add(j);
  const std::uint32_t a = joints.a[j], b = joints.b[j];
  if (a != no_body && b != no_body && !may_collide(joints.definition[j])) parted.push_back({min(a, b), max(a, b)});
}

void World::Impl::wake_island(std::uint32_t i) {
  if (bodies.asleep[i] == 0) {
    disturb(bodies, i);
    return;
  }
  sleepers.each_with(i, [&](std::uint32_t k) {
    bodies.asleep[k] = 0;
    disturb(bodies, k);
    enlist(k);
  });
}

// A body that does not move wakes nobody by moving. (A dynamic one is awake, and meets whom it meets.)
void World::Impl::wake_around(std::uint32_t i) {
  if (bodies.dynamic(i)) return;
  const auto asleep = [&](std::uint32_t k) { return bodies.asleep[k] != 0; };
  const auto plane = std::find_if(planes.begin(), planes.end(), [&](const PlaneProxy& p) { return p.proxy == i; });
  if (sleepers.none()) {
  } else if (plane == planes.end()) {
    std::vector<std::uint32_t> near;
    broad->search(proxies, proxies[i].box, near);
    for (const std::uint32_t k : near) {
      if (asleep(k) && may_pair(proxies[i], proxies[k])) wake_island(k);
    }
  } else {
    for (const std::uint32_t one : sleepers.one_of_each(asleep)) {
      bool meets = false;
      sleepers.each_with(one, [&](std::uint32_t k) { meets |= may_pair(*plane, proxies[i], proxies[k]); });
      if (meets) wake_island(one);
    }
  }
  joint_graph.each_joint(i, [&](std::uint32_t j) {
    const std::uint32_t other = joints.a[j] == i ? joints.b[j] : joints.a[j];
    if (other != no_body) wake_island(other);
  });
}

std::vector<std::uint32_t> World::Impl::pairs_of(std::uint32_t body) const {
  std::vector<std::uint32_t> own;
  pairs.each(body, [&](std::uint32_t p) { own.push_back(p); });
  std::ranges::sort(own, {}, [&](std::uint32_t p) { return pairs[p].key; });
  return own;
}

void World::Impl::end_pair(std::uint32_t pair) {
  const PairRow row = pairs[pair];
  pairs.remove(pair);
  if (row.row == no_row) return;
  contacts.remove(row.row);
  wake_island(row.key.a);
  wake_island(row.key.b);
}

void World::Impl::wake_all() {
  for (const std::uint32_t i : awake_bodies.settle([&](std::uint32_t k) { return bodies.slots.used(k); }))
    disturb(bodies, i);
  for (const std::uint32_t i : sleepers.one_of_each([&](std::uint32_t k) { return bodies.asleep[k] != 0; }))
    wake_island(i);
}

bool World::Impl::forbidden(const ProxyPair& key) const {
  const bool a_has_fewer = joint_graph.count(key.a) < joint_graph.count(key.b);
  const std::uint32_t one = a_has_fewer ? key.a : key.b, other = a_has_fewer ? key.b : key.a;
  bool found = false;
  joint_graph.each_joint(one, [&](std::uint32_t j) {
    found |= joints.touches(j, other) && !may_collide(joints.definition[j]);
  });
  return found;
}

void World::Impl::rebuild() {
  pool->resize(std::uint32_t(config.workers));
  h = clock_step / substeps();
  planes.clear(), parted.clear(), named.clear(), hollows.clear(), pushed.clear();
  awake_bodies.clear(), moving_kinematic.clear(), awake_joints.clear(), sleepers.clear();
  changed.clear(), searched.clear(), found.clear();
  shape_poses.resize(bodies.size()), geometries.resize(bodies.size());
  joint_graph = {};
  for (std::uint32_t j = 0; j < joints.size(); ++j) {
    if (joints.slots.used(j)) enlist_joint(j);
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> asleep;  // island, body
  for (std::uint32_t i = 0; i < bodies.size(); ++i) {
    if (!bodies.slots.used(i)) continue;
    changed.push_back(i);
    shape_poses[i] = bodies.shape_pose(i), geometries[i] = &geometry_of(i);
    if (!body_names[i].empty()) named[body_names[i]].push_back(i);
    if (is_hollow(geometries[i]->kind)) hollows.push_back(i);
    if (bodies.force[i] != Vec3{} || bodies.torque[i] != Vec3{}) pushed.push_back(i);
    if (bodies.asleep[i] != 0) asleep.emplace_back(bodies.sleep_island[i], i);
    else if (bodies.moves(i)) enlist(i);
    if (is_half_space(i)) planes.push_back({i, rotate(shape_poses[i].q, Vec3{0, 1, 0}), shape_poses[i].p});
  }
  std::sort(asleep.begin(), asleep.end());
  for (std::size_t k = 0; k < asleep.size();) {
    std::vector<std::uint32_t> island;
    const std::uint32_t number = asleep[k].first;
    while (k < asleep.size() && asleep[k].first == number) island.push_back(asleep[k++].second);
    sleepers.add(island);
  }
  broad = make_broad_phase(config.broad);
  settle_boxes();
}

}
