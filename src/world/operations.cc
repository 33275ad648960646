// The operations: each validates, then changes; what throws has changed nothing.
#include "base/text.h"
#include "geometry/principal.h"
#include "world/impl.h"
#include "world/validate.h"

namespace sudar::inline SUDAR_PRECISION {

namespace {

template <class Id>
[[noreturn]] void dead(const char* what, const Id& h) {
  throw Error(what, h.null() ? "is null" : "is dead: it was removed, or belongs to another world");
}

// A spin whose angular momentum about any axis is finite in this precision.
void validate_spin(const Vec3& spin, const Vec3& inertia) {
  if (!std::isfinite(length(spin)) || !std::isfinite(length(spin) * max_component(inertia))) {
    throw Error("spin", "makes an angular momentum that the precision cannot hold");
  }
}

void validate_mass(const BodyDef& def) {
  const double density = density_of(def);
  const MassProperties m = mass_properties(def);
  const auto fits = [](double x) { return std::isfinite(Real(x)) && Real(x) > 0 && std::isfinite(1 / Real(x)); };
  if (!fits(density * m.volume)) {
    throw Error(def.mass > 0 ? "mass" : "density",
                "makes a mass of " + text(density * m.volume) + " kg, which the precision cannot hold");
  }
  const Vec3d moments = principal_frame(m).moments * density;
  if (def.motion == Motion::dynamic && !(fits(moments.x) && fits(moments.y) && fits(moments.z))) {
    throw Error(def.inertia ? "inertia" : "shape", "makes an inertia that the precision cannot hold");
  }
  const double largest = max_component(moments);
  if (def.inertia && largest > 1.001 * (moments.x + moments.y + moments.z - largest)) {
    throw Error("inertia", "is of no body: a principal moment is greater than the sum of the others");
  }
  validate_spin(def.spin, def.motion == Motion::dynamic ? convert<Real>(moments) : Vec3{});
}

void validate_body(const BodyDef& def) {
  validate("", def);
  if (def.shape.kind() == ShapeKind::half_space && def.motion != Motion::fixed) {
    throw Error("motion", "must be fixed: a half space has no mass");
  }
  if (def.motion == Motion::fixed && (def.velocity != Vec3{} || def.spin != Vec3{})) {
    throw Error(def.velocity != Vec3{} ? "velocity" : "spin", "must be zero: the body is fixed");
  }
  if (def.shape.kind() != ShapeKind::half_space) validate_mass(def);
  else if (def.center || def.inertia)
    throw Error(def.center ? "center" : "inertia", "is given, but a half space has none");
}

const char* kind_name(const JointDef& def) {
  constexpr const char* names[] = {"bar", "rope", "ball", "hinge", "slider", "fixed", "plane"};
  return names[def.index()];
}

}

void World::Impl::require(Body b, const char* what) const {
  if (!bodies.slots.alive(b)) dead(what, b);
}
void World::Impl::require(Joint j, const char* what) const {
  if (!joints.slots.alive(j)) dead(what, j);
}

// --- bodies ---

Body World::Impl::perform(const AddBody& op) {
  validate_body(op.def);
  const std::uint32_t i = bodies.add(op.def, geometry.number_of(op.def.shape));
  if (i >= body_names.size()) body_names.resize(i + 1), proxies.resize(i + 1);
  body_names[i] = op.def.name;
  proxies[i] = {};
  if (is_half_space(i)) {
    const Pose pose = bodies.shape_pose(i);
    const auto at = std::find_if(planes.begin(), planes.end(), [&](const PlaneProxy& p) { return p.proxy > i; });
    planes.insert(at, {i, rotate(pose.q, Vec3{0, 1, 0}), pose.p});
  }
  touch_proxy(i, true);
  wake_around(i);
  return bodies.slots.handle<BodyTag>(i);
}

void World::Impl::perform(const RemoveBody& op) {
  require(op.body, "body");
  const std::uint32_t i = op.body.index;
  wake_island(i);
  for (std::uint32_t j = 0; j < joints.size(); ++j) {
    if (joints.slots.used(j) && joints.touches(j, i)) perform(RemoveJoint{joints.slots.handle<JointTag>(j)});
  }
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
  drop_pairs(i);
  std::erase_if(planes, [&](const PlaneProxy& p) { return p.proxy == i; });
  proxies[i] = {};
  changed.push_back(i);
  body_names[i].clear();
  bodies.remove(i);
}

void World::Impl::perform(const Push& op) {
  require(op.body, "body");
  validate("", op);
  const std::uint32_t i = op.body.index;
  bodies.force[i] += op.force;
  bodies.torque[i] += cross(op.at - bodies.position[i], op.force);
  wake_island(i);
}

void World::Impl::perform(const Place& op) {
  require(op.body, "body");
  validate("", op);
  const std::uint32_t i = op.body.index;
  wake_island(i);
  for (const PairRow& row : pairs) {
    if ((row.key.a != i && row.key.b != i) || row.row == no_row) continue;
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
  validate_spin(op.spin, bodies.inertia[op.body.index]);
  bodies.set_velocity(op.body.index, op.velocity, op.spin);
  wake_island(op.body.index);
}

void World::Impl::perform(const Wake& op) {
  require(op.body, "body");
  wake_island(op.body.index);
}

// --- joints ---

namespace {

void validate_limit(const Limit& limit, const std::string& field) {
  if (limit.low > limit.high) throw Error(field + ".low", "is above limit.high");
  if (limit.low > 0 && std::isinf(limit.low)) throw Error(field + ".low", "is infinite: nothing meets it");
  if (limit.high < 0 && std::isinf(limit.high)) throw Error(field + ".high", "is minus infinite: nothing meets it");
}

// An anchor must be a finite arm in this precision, seen from the body that it is on.
void validate_anchors(const std::string& kind, const JointDef& def, const Bodies& bodies) {
  const auto check = [&](const char* name, Body body, const Pos& at) {
    if (!body.null() && !std::isfinite(length(at - bodies.position[body.index]))) {
      throw Error(kind + "." + name, "is farther from the body than the precision can tell");
    }
  };
  std::visit(
      [&](const auto& d) {
        if constexpr (requires { d.at; }) check("at", d.a, d.at), check("at", d.b, d.at);
        else check("at_a", d.a, d.at_a), check("at_b", d.b, d.at_b);
      },
      def);
}

}

Joint World::Impl::perform(const AddJoint& op) {
  const char* kind = kind_name(op.def);
  std::visit([&](const auto& d) { validate(kind, d); }, op.def);
  const auto field = [&](const char* name) { return std::string(kind) + "." + name; };
  const Body a = body_a(op.def), b = body_b(op.def);
  if (!a.null()) require(a, field("a").c_str());
  if (!b.null()) require(b, field("b").c_str());
  if (a == b) throw Error(field("b"), "is the same body as a");
  validate_anchors(kind, op.def, bodies);
  const bool moves = (!a.null() && bodies.dynamic(a.index)) || (!b.null() && bodies.dynamic(b.index));
  if (!moves) throw Error(field("a"), "and b are both unable to move: nothing to join");
  std::visit(
      [&](const auto& d) {
        if constexpr (requires { d.limit; }) validate_limit(d.limit, field("limit"));
      },
      op.def);
  if (const auto* bar = std::get_if<Bar>(&op.def); bar != nullptr && bar->at_a == bar->at_b) {
    throw Error("bar.at_b", "is the same point as at_a: use a ball joint");
  }
  const std::uint32_t j = joints.add(op.def, bodies);
  for (const Body body : {a, b}) {
    if (body.null()) continue;
    wake_island(body.index);
    changed.push_back(body.index);  // the two may have to part
  }
  list_never_touch();
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
  joints.remove(j);
  list_never_touch();
}

void World::Impl::perform(const SetDrive& op) {
  require(op.joint, "joint");
  validate("", op);
  Drive* drive = drive_of(joints.definition[op.joint.index]);
  if (drive == nullptr) throw Error("joint", "has no drive: only hinges and sliders have");
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
  wake_all();
  return forces.slots.handle<ForceTag>(forces.add(op.def));
}

void World::Impl::perform(const RemoveForce& op) {
  if (!forces.slots.alive(op.force)) dead("force", op.force);
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
  if (!sensor_slots.alive(op.sensor)) dead("sensor", op.sensor);
  sensor_slots.give_back(op.sensor.index);
}

void World::Impl::perform(const SetConfig& op) {
  validate("", op.config);
  const bool other_broad = op.config.broad != config.broad;
  config = op.config;
  wake_all();
  for (std::uint32_t i = 0; i < bodies.size(); ++i) {
    if (bodies.slots.used(i)) touch_proxy(i, false);
  }
  if (other_broad) rebuild();
}

void World::Impl::replay(const Operation& op) {
  std::visit(
      [&](const auto& o) {
        if constexpr (!std::is_same_v<decltype(o), const std::monostate&>) operate(o);
      },
      op);
}

// --- what several operations need ---

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
  never_touch_grew = true;
}

void World::Impl::rebuild() {
  broad = make_broad_phase(config.broad);
  h = clock_step / config.substeps;
  planes.clear();
  changed.clear();
  list_never_touch();
  for (std::uint32_t i = 0; i < bodies.size(); ++i) {
    if (!bodies.slots.used(i)) continue;
    changed.push_back(i);
    if (!is_half_space(i)) continue;
    const Pose pose = bodies.shape_pose(i);
    planes.push_back({i, rotate(pose.q, Vec3{0, 1, 0}), pose.p});
  }
}

}
