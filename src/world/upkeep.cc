// What several operations and stages need: boxes, sleep, pairs, and all that is a function of the state.
#include "world/impl.h"

namespace sudar::inline SUDAR_PRECISION {

Material World::Impl::pair_material(const ProxyPair& key) const {
  const auto at = std::lower_bound(pair_materials.begin(), pair_materials.end(), key,
                                   [](const PairMaterial& m, const ProxyPair& k) { return m.key < k; });
  if (at != pair_materials.end() && at->key == key) return at->material;
  return mix(config, bodies.material[key.a], bodies.material[key.b]);
}

void World::Impl::touch_proxy(std::uint32_t i, bool force) {
  Proxy& proxy = proxies[i];
  proxy.filter = bodies.filter[i];
  proxy.fixed = bodies.motion[i] == Motion::fixed;
  proxy.present = bodies.slots.used(i) && bodies.quarantined[i] == 0 && !is_half_space(i);
  if (proxy.present) {
    // The box holds the margin within which contacts are made, and room to move before it must be renewed.
    const Real unit = config.length_unit, contact_margin = config.impulse_2007.slop * unit;
    const Pose pose = bodies.shape_pose(i);
    if (!force && contains(proxy.box, bounds(geometry_of(i), pose, contact_margin))) return;
    const Real room = min(Real(0.125) * bodies.radius[i], Real(0.05) * unit);
    proxy.box = bounds(geometry_of(i), pose, contact_margin + room);
  }
  changed.push_back(i);
}

void World::Impl::wake_island(std::uint32_t i) {
  if (bodies.asleep[i] == 0) {
    bodies.quiet_steps[i] = 0;
    return;
  }
  const std::uint32_t island = bodies.sleep_island[i];
  for (std::uint32_t k = 0; k < bodies.size(); ++k) {
    if (!bodies.slots.used(k) || bodies.asleep[k] == 0 || bodies.sleep_island[k] != island) continue;
    bodies.asleep[k] = 0;
    bodies.quiet_steps[k] = 0;
  }
}

// A body that does not move wakes nobody by moving. (A dynamic one is awake, and meets whom it meets.)
void World::Impl::wake_around(std::uint32_t i) {
  if (bodies.dynamic(i)) return;
  const auto plane = std::find_if(planes.begin(), planes.end(), [&](const PlaneProxy& p) { return p.proxy == i; });
  for (std::uint32_t k = 0; k < bodies.size(); ++k) {
    if (!bodies.slots.used(k) || bodies.asleep[k] == 0) continue;
    if (plane != planes.end() ? may_pair(*plane, proxies[i], proxies[k]) : may_pair(proxies[i], proxies[k]))
      wake_island(k);
  }
  for (std::uint32_t j = 0; j < joints.size(); ++j) {
    if (!joints.slots.used(j) || !joints.touches(j, i)) continue;
    const std::uint32_t other = joints.a[j] == i ? joints.b[j] : joints.a[j];
    if (other != no_body) wake_island(other);
  }
}

void World::Impl::drop_pairs(std::uint32_t i) {
  std::vector<EndedPair> lost;
  erase_pairs(pairs, lost, [&](const ProxyPair& p) { return p.a == i || p.b == i; });
  for (const EndedPair& pair : lost) release(pair);
}

void World::Impl::release(const EndedPair& pair) {
  contacts.remove(pair.row);
  wake_island(pair.key.a);
  wake_island(pair.key.b);
}

void World::Impl::wake_all() {
  for (std::uint32_t i = 0; i < bodies.size(); ++i) {
    if (bodies.slots.used(i)) bodies.asleep[i] = 0, bodies.quiet_steps[i] = 0;
  }
}

void World::Impl::list_never_touch() {
  never_touch.clear();
  for (std::uint32_t j = 0; j < joints.size(); ++j) {
    if (!joints.slots.used(j) || may_collide(joints.definition[j])) continue;
    if (joints.a[j] == no_body || joints.b[j] == no_body) continue;
    never_touch.push_back({min(joints.a[j], joints.b[j]), max(joints.a[j], joints.b[j])});
  }
  std::sort(never_touch.begin(), never_touch.end());
}

void World::Impl::rebuild() {
  broad = make_broad_phase(config.broad);
  h = clock_step / config.substeps;
  planes.clear();
  changed.clear();
  joints_changed = true;
  joint_graph.rebuild(joints);
  for (std::uint32_t i = 0; i < bodies.size(); ++i) {
    if (!bodies.slots.used(i)) continue;
    changed.push_back(i);
    if (!is_half_space(i)) continue;
    const Pose pose = bodies.shape_pose(i);
    planes.push_back({i, rotate(pose.q, Vec3{0, 1, 0}), pose.p});
  }
}

}
