// What several operations and stages need: boxes, sleep, pairs, and all that is a function of the state.
#include <algorithm>

#include "dynamics/rest.h"
#include "world/impl.h"

namespace sudar::inline SUDAR_PRECISION {

Material World::Impl::pair_material(const ProxyPair& key) const {
  const auto [a, b] = bodies_of(key);
  const ProxyPair of_bodies{min(a, b), max(a, b)};
  const auto at = std::lower_bound(pair_materials.begin(), pair_materials.end(), of_bodies,
                                   [](const PairMaterial& m, const ProxyPair& k) { return m.key < k; });
  if (at != pair_materials.end() && at->key == of_bodies) return at->material;
  return mix(config, bodies.shapes.material[key.a], bodies.shapes.material[key.b]);
}

StepView World::Impl::view() {
  return {.config = config,
          .h = Real(h),
          .substeps = substeps_at_once(),
          .forces = forces,
          .islands = islands,
          .awake = awake,
          .contacts = active_contacts,
          .near = near_contacts,
          .joints = active_joints,
          .smooth = smooth,
          .kinematic = kinematic,
          .geometries = geometries,
          .bodies = bodies,
          .joint_state = joints,
          .joint_graph = joint_graph,
          .contact_state = contacts,
          .pool = *pool};
}

void World::Impl::settle_boxes() {
  if (changed.empty()) return;
  std::sort(changed.begin(), changed.end());
  changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
  broad->update(proxies, changed, found);
  searched.insert(searched.end(), changed.begin(), changed.end());
  changed.clear();
}

Vec3 World::Impl::velocity_of(std::uint32_t s) const {
  const std::uint32_t i = body_of(s);
  const Vec3& center = bodies.shapes.center[s];
  if (center == Vec3{}) return bodies.velocity[i];
  return bodies.velocity[i] + cross(bodies.spin[i], rotate(bodies.orientation[i], center));
}

Real World::Impl::contact_margin(std::uint32_t s) const {
  const Real unit = config.length_unit;
  if (detects_each_substep()) return config.impulse_2007.slop * unit;
  const Real near = Real(0.01) * unit;
  return bodies.dynamic(body_of(s)) ? min(near, Real(0.125) * bodies.shapes.radius[s]) : near;
}

// Who is looked at once a step must be seen before it arrives.
Real World::Impl::pair_margin(std::uint32_t a, std::uint32_t b) const {
  if (detects_each_substep()) return contact_margin(a);
  const Real way = length(velocity_of(a) - velocity_of(b)) * step_length();
  return contact_margin(a) + contact_margin(b) + min(way, smaller_radius(a, b));  // a thin body sees no farther than it is thick
}

// By its spin, and by what an end gains that comes on when the other is stopped.
Real World::Impl::pair_turn(std::uint32_t a, std::uint32_t b) const {
  if (detects_each_substep()) return 0;
  constexpr Real most = Real(0.25);
  const Real way = length(velocity_of(a) - velocity_of(b)) * step_length();
  return min(most, length(bodies.spin[body_of(a)] - bodies.spin[body_of(b)]) * step_length() + way / smaller_radius(a, b));
}

Real World::Impl::unseen_depth(std::uint32_t a, std::uint32_t b) const {
  Real least = std::numeric_limits<Real>::infinity();
  for (const std::uint32_t s : {a, b}) {
    if (bodies.dynamic(body_of(s))) least = min(least, inner_radius(geometry_of(s)));
  }
  return unseen_share * least;
}

Real World::Impl::smaller_radius(std::uint32_t a, std::uint32_t b) const {
  Real least = std::numeric_limits<Real>::infinity();
  for (const std::uint32_t s : {a, b}) {
    if (bodies.dynamic(body_of(s))) least = min(least, bodies.shapes.radius[s]);
  }
  return least;
}

// The way of the coming step, m; none where contacts are looked for again before a shape gets far.
Vec3 World::Impl::coming_way(std::uint32_t s) const {
  if (detects_each_substep()) return {};
  const Vec3 way = velocity_of(s) * step_length();
  const Real far = length(way), most = 4 * bodies.shapes.radius[s];
  return bodies.dynamic(body_of(s)) && far > most ? way * (most / far) : way;
}

namespace {

Box stretched(Box box, const Vec3& along) {
  for (int k = 0; k < 3; ++k) (along[k] < 0 ? box.low : box.high)[k] += double(along[k]);
  return box;
}

}

void World::Impl::describe_proxy(std::uint32_t s) {
  Proxy& proxy = proxies[s];
  const std::uint32_t i = body_of(s);
  proxy.filter = bodies.shapes.filter[s];
  proxy.owner = i;
  proxy.fixed = bodies.motion[i] == Motion::fixed;
  proxy.present = bodies.shapes.slots.used(s) && bodies.quarantined[i] == 0 && !is_half_space(s);
}

bool World::Impl::renew_box(std::uint32_t s, bool force) {
  Proxy& proxy = proxies[s];
  describe_proxy(s);
  const Pose pose = bodies.shape_pose(s), before = std::exchange(shape_poses[s], pose);
  if (!proxy.present) return true;
  const Geometry& shape = geometry_of(s);
  const Quat turn = pose.q * conjugate(before.q);  // twice its sine is the chord of a circle of radius 1
  way[s] += double(length(pose.p - before.p)) + 2 * double(length(turn.vector()) * shape.bounding_radius);
  // The box holds the margin within which contacts are made, and room to move before it must be renewed.
  const Real margin = contact_margin(s);
  const Vec3 way = coming_way(s);
  if (!force && contains(proxy.box, stretched(bounds(shape, pose, margin), way))) return false;
  const Real room = min(Real(0.125) * bodies.shapes.radius[s], Real(0.05) * config.length_unit);
  constexpr Real steps = 3;  // for which the box should do
  proxy.box = stretched(bounds(shape, pose, margin + room), way * steps);
  return true;
}

void World::Impl::touch_proxy(std::uint32_t s, bool force) {
  if (renew_box(s, force)) changed.push_back(s);
}

void World::Impl::enlist(std::uint32_t i) {
  if (bodies.motion[i] == Motion::kinematic) moving_kinematic.add(i);
  else if (bodies.motion[i] == Motion::dynamic) awake_bodies.add(i);
  else return;
  bodies.each_shape(i, [&](std::uint32_t s) { pairs.each(s, [&](std::uint32_t p) { pairs.activate(p); }); });
  joint_graph.each_joint(i, [&](std::uint32_t j) { awake_joints.add(j); });
}

void World::Impl::enlist_joint(std::uint32_t j) {
  joint_graph.add(joints, j);
  awake_joints.add(j);
  const std::uint32_t a = joints.a[j], b = joints.b[j];
  if (a != no_body && b != no_body && !may_collide(joints.definition[j])) parted.push_back({a, b});
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

void World::Impl::wake_near(std::uint32_t s) {
  const auto asleep = [&](std::uint32_t k) { return bodies.asleep[k] != 0; };
  const auto plane = std::ranges::find(planes, s, &PlaneProxy::proxy);
  if (plane == planes.end()) {
    std::vector<std::uint32_t> near;
    broad->search(proxies, proxies[s].box, near);
    for (const std::uint32_t k : near) {
      if (asleep(body_of(k)) && may_pair(proxies[s], proxies[k])) wake_island(body_of(k));
    }
    return;
  }
  for (const std::uint32_t one : sleepers.one_of_each(asleep)) {
    bool meets = false;
    sleepers.each_with(one, [&](std::uint32_t i) {
      bodies.each_shape(i, [&](std::uint32_t k) { meets |= may_pair(*plane, proxies[s], proxies[k]); });
    });
    if (meets) wake_island(one);
  }
}

// A body that does not move wakes nobody by moving. (A dynamic one is awake, and meets whom it meets.)
void World::Impl::wake_around(std::uint32_t i) {
  if (bodies.dynamic(i)) return;
  if (!sleepers.none()) bodies.each_shape(i, [&](std::uint32_t s) { wake_near(s); });
  joint_graph.each_joint(i, [&](std::uint32_t j) {
    const std::uint32_t other = joints.a[j] == i ? joints.b[j] : joints.a[j];
    if (other != no_body) wake_island(other);
  });
}

std::vector<std::uint32_t> World::Impl::pairs_of(std::uint32_t body) const {
  std::vector<std::uint32_t> own;
  bodies.each_shape(body, [&](std::uint32_t s) { pairs.each(s, [&](std::uint32_t p) { own.push_back(p); }); });
  std::ranges::sort(own, {}, [&](std::uint32_t p) { return pairs[p].order(); });
  return own;
}

void World::Impl::end_pair(std::uint32_t pair) {
  const PairRow row = pairs[pair];
  pairs.remove(pair);
  if (row.row == no_row) return;
  if (row.part != no_part) --pairs[pairs.find(row.key)].touching;
  contacts.remove(row.row);
  wake_island(body_of(row.key.a));
  wake_island(body_of(row.key.b));
}

void World::Impl::note_touch(const ProxyPair& key) {
  const std::uint32_t pair = pairs.find(key);
  if (std::ranges::find(touched_before, pair, &TouchBefore::pair) != touched_before.end()) return;
  touched_before.push_back({pair, pairs[pair].touching > 0});
}

void World::Impl::wake_all() {
  for (const std::uint32_t i : awake_bodies.settle([&](std::uint32_t k) { return bodies.slots.used(k); }))
    disturb(bodies, i);
  for (const std::uint32_t i : sleepers.one_of_each([&](std::uint32_t k) { return bodies.asleep[k] != 0; }))
    wake_island(i);
}

bool World::Impl::forbidden(const BodyPair& key) const {
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
  planes.clear(), parted.clear(), named.clear(), hollows.clear(), meshes.clear(), pushed.clear();
  awake_bodies.clear(), moving_kinematic.clear(), awake_joints.clear(), sleepers.clear();
  changed.clear(), searched.clear(), found.clear();
  const Shapes& shapes = bodies.shapes;
  proxies.resize(shapes.size()), shape_poses.resize(shapes.size()), geometries.resize(shapes.size());
  joint_graph = {};
  for (std::uint32_t j = 0; j < joints.size(); ++j) {
    if (joints.slots.used(j)) enlist_joint(j);
  }
  for (std::uint32_t s = 0; s < shapes.size(); ++s) {
    if (!shapes.slots.used(s)) continue;
    changed.push_back(s);
    describe_proxy(s);
    shape_poses[s] = bodies.shape_pose(s), geometries[s] = &geometry_of(s);
    if (is_hollow(geometries[s]->kind)) hollows.push_back(s);
    if (geometries[s]->kind == ShapeKind::mesh) meshes.push_back(s);
    if (is_half_space(s)) planes.push_back({s, rotate(shape_poses[s].q, Vec3{0, 1, 0}), shape_poses[s].p});
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> asleep;  // island, body
  for (std::uint32_t i = 0; i < bodies.size(); ++i) {
    if (!bodies.slots.used(i)) continue;
    if (!body_names[i].empty()) named[body_names[i]].push_back(i);
    if (bodies.force[i] != Vec3{} || bodies.torque[i] != Vec3{}) pushed.push_back(i);
    if (bodies.asleep[i] != 0) asleep.emplace_back(bodies.sleep_island[i], i);
    else if (bodies.moves(i)) enlist(i);
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
