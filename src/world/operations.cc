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
void World::Impl::require(ShapeId s, const char* what) const { require_alive(*this, bodies.shapes.slots, s, what); }
void World::Impl::require(ForceId f, const char* what) const { require_alive(*this, forces.slots, f, what); }
void World::Impl::require(SensorId s, const char* what) const { require_alive(*this, sensor_slots, s, what); }

// --- bodies ---

namespace {

// A hollow collides with spheres only (shape.h): better refused than passed through in silence. Looks at the hollows, or
// for a new hollow at all shapes but those of its own body.
void check_hollows(const World::Impl& w, const ShapeDef& part, Motion motion, std::uint32_t own, const std::string& field) {
  const auto check = [&](std::uint32_t s) {
    const ShapeKind mine = part.shape.kind(), other = w.geometry_of(s).kind;
    const bool strange = (is_hollow(mine) && other != ShapeKind::sphere) || (is_hollow(other) && mine != ShapeKind::sphere);
    const bool one_moves = motion == Motion::dynamic || w.bodies.dynamic(w.body_of(s));
    if (strange && one_moves && w.body_of(s) != own && may_touch(*part.filter, w.bodies.shapes.filter[s])) {
      throw Error(field, "would meet a hollow, or is one that would meet a body, and only spheres collide with "
                         "hollows: let the filters keep the two apart");
    }
  };
  if (!is_hollow(part.shape.kind())) {
    for (const std::uint32_t s : w.hollows) check(s);
    return;
  }
  for (std::uint32_t s = 0; s < w.bodies.shapes.size(); ++s) {
    if (w.bodies.shapes.slots.used(s)) check(s);
  }
}

Surroundings around(const World::Impl& w) { return surroundings(w.forces, w.config, w.config.dt); }

void insert(std::vector<std::uint32_t>& ascending, std::uint32_t i) {
  ascending.insert(std::ranges::lower_bound(ascending, i), i);
}

PlaneProxy plane_of(const World::Impl& w, std::uint32_t s) {
  const Pose pose = w.bodies.shape_pose(s);
  return {s, rotate(pose.q, Vec3{0, 1, 0}), pose.p};
}

}

void World::Impl::enter(std::uint32_t s) {
  pairs.reserve(s + 1);
  if (s == proxies.size()) proxies.emplace_back(), shape_poses.emplace_back(), geometries.emplace_back(), way.push_back(0);
  geometries[s] = &geometry_of(s);
  if (is_hollow(geometries[s]->kind)) insert(hollows, s);
  if (geometries[s]->kind == ShapeKind::mesh) insert(meshes, s);
  if (is_half_space(s)) planes.insert(std::ranges::lower_bound(planes, s, {}, &PlaneProxy::proxy), plane_of(*this, s));
  proxies[s] = {};
  touch_proxy(s, true);
}

void World::Impl::leave(std::uint32_t s) {
  std::vector<std::uint32_t> own;
  pairs.each(s, [&](std::uint32_t p) { own.push_back(p); });
  std::ranges::sort(own, {}, [&](std::uint32_t p) { return pairs[p].order(); });
  for (const std::uint32_t p : own) end_pair(p);
  std::erase_if(planes, [&](const PlaneProxy& p) { return p.proxy == s; });
  std::erase(hollows, s);
  std::erase(meshes, s);
  proxies[s] = {};
  changed.push_back(s);
}

Body World::Impl::perform(const AddBody& op) {
  const BodyDef& def = op.def;
  validate("", def);
  if (!def.shape && def.shapes.empty()) throw Error("shape", "is missing");
  if (def.shape && !def.shapes.empty()) throw Error("shapes", "are given besides a shape: put that among them");
  const std::vector<ShapeDef> shapes = shapes_of(def);
  check_body(def, shapes, around(*this));
  for (std::size_t k = 0; k < shapes.size(); ++k) {
    const std::string field = def.shape ? "shape" : std::string("shapes[").append(std::to_string(k)).append("].shape");
    check_hollows(*this, shapes[k], def.motion, no_body, field);
  }
  std::vector<std::uint32_t> numbers;
  for (const ShapeDef& part : shapes) numbers.push_back(geometry.number_of(part.shape));
  const std::uint32_t i = bodies.add(def, shapes, numbers);
  if (i == body_names.size()) body_names.emplace_back();
  body_names[i] = def.name;
  if (!def.name.empty()) insert(named[def.name], i);
  bodies.each_shape(i, [&](std::uint32_t s) { enter(s); });
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
  bodies.each_shape(i, [&](std::uint32_t s) { leave(s); });
  std::erase_if(pair_materials, [&](const PairMaterial& m) { return m.key.a == i || m.key.b == i; });
  if (const auto at = named.find(body_names[i]); at != named.end()) {
    std::erase(at->second, i);
    if (at->second.empty()) named.erase(at);
  }
  body_names[i].clear();
  bodies.remove(i);
}

// --- shapes of a body ---

namespace {

// What body i would weigh with one shape more, or without one that it has.
std::optional<MassSum> weigh(const World::Impl& w, std::uint32_t i, const ShapeDef* more, std::uint32_t without) {
  std::vector<MassPart> parts;
  const Shapes& shapes = w.bodies.shapes;
  w.bodies.each_shape(i, [&](std::uint32_t s) {
    if (s == without || !has_mass(w.geometry_of(s).kind)) return;
    parts.push_back({&w.geometry_of(s).mass, shapes.pose[s], double(shapes.density[s])});
  });
  if (more != nullptr && has_mass(more->shape.kind())) {
    parts.push_back({&more->shape.geometry().mass, {more->at, more->turn}, double(*more->density)});
  }
  if (parts.empty()) return {};
  return sum_masses(parts);
}

// Body i has got its shapes: all that is told in its body frame, or about its centre, is told anew.
void renew_mass(World::Impl& w, std::uint32_t i, const std::optional<MassSum>& sum) {
  Bodies& b = w.bodies;
  std::vector<const Geometry*> geometries;
  b.each_shape(i, [&](std::uint32_t s) { geometries.push_back(&w.geometry_of(s)); });
  const Pos center = b.position[i];
  const Vec3 velocity = b.velocity[i];
  const Transform to_new = b.renew_mass(i, sum, geometries), to_old = inverse(to_new);
  w.joint_graph.each_joint(i, [&](std::uint32_t j) { w.joints.turn_frame(j, i, to_new); });
  for (const std::uint32_t p : w.pairs_of(i)) {
    const PairRow& row = w.pairs[p];
    if (row.row == no_row) continue;
    Pose& then = w.body_of(row.key.a) == i ? w.contacts.place[row.row].a : w.contacts.place[row.row].b;
    then = {then.point(to_old.p), normalize(then.q * to_old.q)};
  }
  for (std::uint32_t s = 0; s < w.sensor_slots.size(); ++s) {
    if (!w.sensor_slots.used(s) || w.sensors[s].a.index != i) continue;
    w.sensor_memory[s].position = w.sensor_memory[s].position + (b.position[i] - center);
    w.sensor_memory[s].velocity += convert<double>(b.velocity[i] - velocity);
  }
}

}

ShapeId World::Impl::perform(const AddShape& op) {
  require(op.body, "body");
  validate("", op.def);
  const std::uint32_t i = op.body.index;
  const ShapeDef part = bodies.complete(i, op.def);
  if (!may_have(bodies.motion[i], part.shape.kind())) {
    throw Error("shape", "has no mass: a half space or a hollow is for fixed bodies only, a mesh for kinematic ones, too");
  }
  check_hollows(*this, part, bodies.motion[i], i, "shape");
  const std::optional<MassSum> sum = weigh(*this, i, &part, no_shape);
  if (sum) check_shape(bodies, i, *sum, around(*this));
  wake_island(i);
  const std::uint32_t s = bodies.add_shape(i, part, geometry.number_of(part.shape));
  renew_mass(*this, i, sum);
  bodies.each_shape(i, [&](std::uint32_t one) {
    if (one == s) enter(one);
    else touch_proxy(one, false);
  });
  wake_around(i);
  return bodies.shapes.slots.handle<ShapeTag>(s);
}

void World::Impl::perform(const RemoveShape& op) {
  require(op.shape, "shape");
  const std::uint32_t s = op.shape.index, i = body_of(s);
  if (bodies.first_shape[i] == s && bodies.shapes.next[s] == no_shape) {
    throw Error("shape", "is the only one of its body: remove the body");
  }
  const std::optional<MassSum> sum = weigh(*this, i, nullptr, s);
  if (sum) check_shape(bodies, i, *sum, around(*this));
  wake_island(i);
  leave(s);
  bodies.remove_shape(s);
  renew_mass(*this, i, sum);
  bodies.each_shape(i, [&](std::uint32_t one) { touch_proxy(one, false); });
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
    wake_island(body_of(row.key.a));
    wake_island(body_of(row.key.b));
  }
  bodies.set_given_pose(i, {op.at, normalize(op.turn)});
  bodies.angular_momentum[i] = bodies.inertia_world(i) * bodies.spin[i];
  for (PlaneProxy& p : planes) {
    if (body_of(p.proxy) == i) p = plane_of(*this, p.proxy);
  }
  bodies.each_shape(i, [&](std::uint32_t s) { touch_proxy(s, true); });
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
  bodies.each_shape(op.body.index, [&](std::uint32_t s) {
    bodies.shapes.surface_velocity[s] = rotate_back(bodies.shapes.pose[s].q, op.velocity);
  });
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
    bodies.each_shape(body.index, [&](std::uint32_t s) { changed.push_back(s); });  // the two may have to part
  }
  return joints.slots.handle<JointTag>(j);
}

void World::Impl::perform(const RemoveJoint& op) {
  require(op.joint, "joint");
  const std::uint32_t j = op.joint.index;
  for (const std::uint32_t body : {joints.a[j], joints.b[j]}) {
    if (body == no_body) continue;
    wake_island(body);
    if (may_collide(joints.definition[j])) continue;
    bodies.each_shape(body, [&](std::uint32_t s) { changed.push_back(s); });  // the two may touch from now on
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
  for (std::uint32_t s = 0; s < bodies.shapes.size(); ++s) {
    if (bodies.shapes.slots.used(s)) touch_proxy(s, false);
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
