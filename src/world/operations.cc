// The operations: each validates, then changes; what throws has changed nothing.
#include "world/impl.h"
#include "world/physical.h"
#include "world/validate.h"

namespace sudar::inline SUDAR_PRECISION {

namespace {

template <class Id>
void require_alive(const World::Impl& w, const Slots& slots, Id h, const char* what) {
  if (slots.alive(h)) return;
  throw Error(what, h.null() ? "is null" : h.world != w.number ? "is of another world" : "is dead: it was removed");
}

}

void World::Impl::require(Body b, const char* what) const { require_alive(*this, bodies.slots, b, what); }
void World::Impl::require(Joint j, const char* what) const { require_alive(*this, joints.slots, j, what); }
void World::Impl::require(ForceId f, const char* what) const { require_alive(*this, forces.slots, f, what); }
void World::Impl::require(SensorId s, const char* what) const { require_alive(*this, sensor_slots, s, what); }

// --- bodies ---

namespace {

// A hollow collides with spheres only (shape.h): better refused than passed through in silence. Looks at the hollows, or
// for a new hollow at all bodies.
void check_hollows(const World::Impl& w, const BodyDef& def) {
  const auto check = [&](std::uint32_t i) {
    const ShapeKind mine = def.shape.kind(), other = w.geometry_of(i).kind;
    const bool strange = (is_hollow(mine) && other != ShapeKind::sphere) || (is_hollow(other) && mine != ShapeKind::sphere);
    const bool one_moves = def.motion == Motion::dynamic || w.bodies.dynamic(i);
    if (strange && one_moves && may_touch(def.filter, w.bodies.filter[i])) {
      throw Error("shape", "would meet a hollow, or is one that would meet a body, and only spheres collide with "
                           "hollows: let the filters keep the two apart");
    }
  };
  if (!is_hollow(def.shape.kind())) {
    for (const std::uint32_t i : w.hollows) check(i);
    return;
  }
  for (std::uint32_t i = 0; i < w.bodies.size(); ++i) {
    if (w.bodies.slots.used(i)) check(i);
  }
}

Surroundings around(const World::Impl& w) { return surroundings(w.forces, w.config, w.config.dt); }

void insert(std::vector<std::uint32_t>& ascending, std::uint32_t i) {
  ascending.insert(std::ranges::lower_bound(ascending, i), i);
}

}

Body World::Impl::perform(const AddBody& op) {
  validate("", op.def);
  check_body(op.def, around(*this));
  check_hollows(*this, op.def);
  const std::uint32_t i = bodies.add(op.def, geometry.number_of(op.def.shape));
  if (i == body_names.size()) {
    body_names.emplace_back(), proxies.emplace_back(), shape_poses.emplace_back(), geometries.emplace_back();
    way.push_back(0);
  }
  geometries[i] = &geometry_of(i);
  body_names[i] = op.def.name;
  if (!op.def.name.empty()) insert(named[op.def.name], i);
  if (is_hollow(op.def.shape.kind())) insert(hollows, i);
  proxies[i] = {};
  if (is_half_space(i)) {
    const Pose pose = bodies.shape_pose(i);
    const auto at = std::find_if(planes.begin(), planes.end(), [&](const PlaneProxy& p) { return p.proxy > i; });
    planes.insert(at, {i, rotate(pose.q, Vec3{0, 1, 0}), pose.p});
  }
  touch_proxy(i, true);
  if (bodies.moves(i)) enlist(i);
  wake_around(i);
  return bodies.slots.handle<BodyTag>(i);
}

void World::Impl::perform(const RemoveBody& op) {
  require(op.body, "body");
  const std::uint32_t i = op.body.index;
  wake_island(i);
  std::vector<std::uint32_t> hanging;
  joint_graph.each_joint(i, [&](std::uint32_t j) { hanging.push_back(j); });
  std::ranges::sort(hanging);
  for (const std::uint32_t j : hanging) perform(RemoveJoint{joints.slots.handle<JointTag>(j)});
  for (std::uint32_t f = 0; f < forces.slots.size(); ++f) {
    if (!forces.slots.used(f)) continue;
    const Body on = std::visit(
        [](const auto& force) {
          if constexpr (requires { force.body; }) return force.body;
          else return Body{};
        },
        forces.definition[f]);
    if (on == op.body) forces.remove(f);
  }
  for (std::uint32_t s = 0; s < sensor_slots.size(); ++s) {
    if (sensor_slots.used(s) && (sensors[s].a == op.body || sensors[s].b == op.body)) sensor_slots.give_back(s);
  }
  for (const std::uint32_t p : pairs_of(i)) end_pair(p);
  std::erase_if(planes, [&](const PlaneProxy& p) { return p.proxy == i; });
  std::erase_if(pair_materials, [&](const PairMaterial& m) { return m.key.a == i || m.key.b == i; });
  proxies[i] = {};
  changed.push_back(i);
  if (const auto at = named.find(body_names[i]); at != named.end()) {
    std::erase(at->second, i);
    if (at->second.empty()) named.erase(at);
  }
  std::erase(hollows, i);
  body_names[i].clear();
  bodies.remove(i);
}

void World::Impl::perform(const Push& op) {
  require(op.body, "body");
  validate("", op);
  const std::uint32_t i = op.body.index;
  const Vec3 arm = op.at - bodies.position[i], torque = cross(arm, op.force);
  const Real lever = min(bodies.radius[i], length(arm));
  check_force("force", bodies, i, op.force, around(*this));
  check_torque("force", bodies, i, cross(normalize(arm) * lever, op.force), around(*this));
  check_torque("at", bodies, i, torque, around(*this));
  bodies.force[i] += op.force;
  bodies.torque[i] += torque;
  pushed.push_back(i);
  wake_island(i);
}

void World::Impl::perform(const Torque& op) {
  require(op.body, "body");
  validate("", op);
  check_torque("torque", bodies, op.body.index, op.torque, around(*this));
  bodies.torque[op.body.index] += op.torque;
  pushed.push_back(op.body.index);
  wake_island(op.body.index);
}

void World::Impl::perform(const Place& op) {
  require(op.body, "body");
  validate("", op);
  const std::uint32_t i = op.body.index;
  wake_island(i);
  for (const std::uint32_t p : pairs_of(i)) {
    const PairRow& row = pairs[p];
    if (row.row == no_row) continue;
    contacts.impulse[row.row] = {};  // what it carried, it carried elsewhere
    wake_island(row.key.a);
    wake_island(row.key.b);
  }
  bodies.set_shape_pose(i, {op.at, normalize(op.turn)});
  bodies.angular_momentum[i] = bodies.inertia_world(i) * bodies.spin[i];
  for (PlaneProxy& p : planes) {
    if (p.proxy == i) p.normal = rotate(normalize(op.turn), Vec3{0, 1, 0}), p.point = op.at;
  }
  touch_proxy(i, true);
  wake_around(i);
}

void World::Impl::perform(const SetVelocity& op) {
  require(op.body, "body");
  validate("", op);
  if (bodies.motion[op.body.index] == Motion::fixed) throw Error("body", "is fixed: it has no velocity");
  check_velocity(bodies, op.body.index, op.velocity, op.spin, around(*this));
  bodies.set_velocity(op.body.index, op.velocity, op.spin);
  if (bodies.motion[op.body.index] == Motion::kinematic && bodies.moves(op.body.index)) enlist(op.body.index);
  wake_island(op.body.index);
}

void World::Impl::perform(const SetSurfaceVelocity& op) {
  require(op.body, "body");
  validate("", op);
  bodies.surface_velocity[op.body.index] = op.velocity;
  wake_island(op.body.index);
  wake_around(op.body.index);
}

void World::Impl::perform(const SetPairMaterial& op) {
  require(op.a, "a");
  require(op.b, "b");
  if (op.a == op.b) throw Error("b", "is the same body as a");
  validate("", op);
  const ProxyPair key{min(op.a.index, op.b.index), max(op.a.index, op.b.index)};
  const auto at = std::find_if(pair_materials.begin(), pair_materials.end(),
                               [&](const PairMaterial& m) { return !(m.key < key); });
  const bool known = at != pair_materials.end() && at->key == key;
  if (op.material && known) at->material = *op.material;
  else if (op.material) pair_materials.insert(at, {key, *op.material});
  else if (known) pair_materials.erase(at);
  wake_island(key.a);
  wake_island(key.b);
}

void World::Impl::perform(const Wake& op) {
  require(op.body, "body");
  wake_island(op.body.index);
}

// --- joints ---

Joint World::Impl::perform(const AddJoint& op) {
  const std::string kind = kind_of(op.def);
  std::visit([&](const auto& d) { validate(kind.c_str(), d); }, op.def);
  const Body a = body_a(op.def), b = body_b(op.def);
  if (!a.null()) require(a, (kind + ".a").c_str());
  if (!b.null()) require(b, (kind + ".b").c_str());
  check_joint(op.def, bodies);
  const std::uint32_t j = joints.add(op.def, bodies);
  enlist_joint(j);
  for (const Body body : {a, b}) {
    if (body.null()) continue;
    wake_island(body.index);
    changed.push_back(body.index);  // the two may have to part
  }
  return joints.slots.handle<JointTag>(j);
}

void World::Impl::perform(const RemoveJoint& op) {
  require(op.joint, "joint");
  const std::uint32_t j = op.joint.index;
  for (const std::uint32_t body : {joints.a[j], joints.b[j]}) {
    if (body == no_body) continue;
    wake_island(body);
    if (!may_collide(joints.definition[j])) changed.push_back(body);  // the two may touch from now on
  }
  joint_graph.remove(j);
  joints.remove(j);
}

void World::Impl::perform(const SetDrive& op) {
  require(op.joint, "joint");
  validate("", op);
  Drive* drive = drive_of(joints.definition[op.joint.index]);
  if (drive == nullptr) throw Error("joint", "has no drive: only hinges, sliders and muscles have");
  *drive = op.drive;
  for (const std::uint32_t body : {joints.a[op.joint.index], joints.b[op.joint.index]}) {
    if (body != no_body) wake_island(body);
  }
}

// --- forces, sensors, settings ---

ForceId World::Impl::perform(const AddForce& op) {
  std::visit(
      [&](const auto& force) {
        validate("", force);
        if constexpr (requires { force.body; }) {
          if (!force.body.null() || std::is_same_v<decltype(force), const Thruster&>) require(force.body, "body");
        }
      },
      op.def);
  if (const auto* more = std::get_if<Gravity>(&op.def)) {
    Surroundings heavier = around(*this);
    heavier.gravity = double(length(gravity(forces) + more->acceleration));
    check_surroundings("acceleration", bodies, heavier);
  }
  wake_all();
  return forces.slots.handle<ForceTag>(forces.add(op.def));
}

void World::Impl::perform(const RemoveForce& op) {
  require(op.force, "force");
  forces.remove(op.force.index);
  wake_all();
}

SensorId World::Impl::perform(const AddSensor& op) {
  validate("", op.def);
  require(op.def.a, "a");
  if (!op.def.b.null()) require(op.def.b, "b");
  const std::uint32_t i = sensor_slots.take();
  if (i == sensors.size()) sensors.emplace_back(), sensor_memory.emplace_back();
  sensors[i] = op.def;
  const std::uint32_t a = op.def.a.index;
  sensor_memory[i] = {0, bodies.position[a], convert<double>(bodies.velocity[a])};
  return sensor_slots.handle<SensorTag>(i);
}

void World::Impl::perform(const RemoveSensor& op) {
  require(op.sensor, "sensor");
  sensor_slots.give_back(op.sensor.index);
}

void World::Impl::perform(const SetConfig& op) {
  validate("", op.config);
  check_config(op.config);
  check_surroundings(name_of_step(op.config), bodies, surroundings(forces, op.config, op.config.dt));
  const bool other_broad = op.config.broad != config.broad;
  config = op.config;
  wake_all();
  for (std::uint32_t i = 0; i < bodies.size(); ++i) {
    if (bodies.slots.used(i)) touch_proxy(i, false);
  }
  pool->resize(std::uint32_t(config.workers));
  if (other_broad) rebuild();
}

void World::Impl::replay(const Operation& op) {
  std::visit(
      [&](const auto& o) {
        if constexpr (std::is_same_v<decltype(o), const SetConfig&>) {
          SetConfig here = o;
          here.config.workers = config.workers;  // how many there are is the machine's
          operate(here);
        } else if constexpr (!std::is_same_v<decltype(o), const std::monostate&>) {
          operate(o);
        }
      },
      op);
}

}
