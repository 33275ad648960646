// The public functions: operations forward to Impl::operate, the rest only looks.
#include <sudar/world.h>

#include <algorithm>
#include <atomic>

#include "dynamics/integrate.h"
#include "world/impl.h"
#include "world/physical.h"
#include "world/validate.h"

namespace sudar::inline SUDAR_PRECISION {

std::uint32_t new_world_number() {
  static std::atomic<std::uint32_t> last = 0;  // reaches handles only, and of those no result
  return last++ % (Body::worlds - 1) + 1;  // 0 is that of a null handle
}

World::Impl::Impl(const Config& c, std::uint32_t n) : config(c), number(n) {
  for (Slots* slots : {&bodies.slots, &bodies.shapes.slots, &joints.slots, &forces.slots, &sensor_slots}) slots->belong_to(number);
  rebuild();
}

World::World(const Config& config) {
  validate("", config);
  check_config(config);
  impl_ = std::make_unique<Impl>(config, new_world_number());
}
World::Inside& World::Inside::operator=(std::unique_ptr<Impl> p) { return p_ = std::move(p), *this; }
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;
World::~World() = default;

Body World::add(const BodyDef& def) { return impl_->operate(AddBody{def}); }
ForceId World::add(const Force& def) { return impl_->operate(AddForce{def}); }
SensorId World::add(const Sensor& def) { return impl_->operate(AddSensor{def}); }
Joint World::join(const JointDef& def) { return impl_->operate(AddJoint{def}); }
ShapeId World::add(Body b, const ShapeDef& def) { return impl_->operate(AddShape{b, def}); }
void World::remove(ShapeId s) { impl_->operate(RemoveShape{s}); }
void World::remove(Body b) { impl_->operate(RemoveBody{b}); }
void World::remove(Joint j) { impl_->operate(RemoveJoint{j}); }
void World::remove(ForceId f) { impl_->operate(RemoveForce{f}); }
void World::remove(SensorId s) { impl_->operate(RemoveSensor{s}); }
void World::push(Body b, const Vec3& force, const Pos& at) { impl_->operate(Push{b, force, at}); }
void World::twist(Body b, const Vec3& torque) { impl_->operate(Torque{b, torque}); }
void World::place(Body b, const Pose& pose) { impl_->operate(Place{b, pose.p, pose.q}); }
void World::set_velocity(Body b, const Vec3& v, const Vec3& spin) { impl_->operate(SetVelocity{b, v, spin}); }
void World::set_surface_velocity(Body b, const Vec3& v) { impl_->operate(SetSurfaceVelocity{b, v}); }
void World::set_pair_material(Body a, Body b, const std::optional<Material>& material) {
  impl_->operate(SetPairMaterial{a, b, material});
}
void World::set_drive(Joint j, const Drive& drive) { impl_->operate(SetDrive{j, drive}); }
void World::set_config(const Config& config) { impl_->operate(SetConfig{config}); }
void World::wake(Body b) { impl_->operate(Wake{b}); }

const Events& World::step() { return step(impl_->config.dt); }
const Events& World::step(double dt) {
  impl_->step(dt);
  return impl_->events;
}

// --- looking ---

const Config& World::config() const { return impl_->config; }
double World::time() const { return impl_->time(); }
std::int64_t World::steps() const { return impl_->steps; }
const Events& World::events() const { return impl_->events; }
const Profile& World::profile() const { return impl_->profile; }
bool World::alive(Body b) const { return impl_->bodies.slots.alive(b); }
bool World::alive(Joint j) const { return impl_->joints.slots.alive(j); }
bool World::alive(ShapeId s) const { return impl_->bodies.shapes.slots.alive(s); }

namespace {
template <class Tag>
std::vector<Handle<Tag>> all(const Slots& slots) {
  std::vector<Handle<Tag>> handles;
  for (std::uint32_t i = 0; i < slots.size(); ++i) {
    if (slots.used(i)) handles.push_back(slots.handle<Tag>(i));
  }
  return handles;
}
}

std::vector<Body> World::bodies() const { return all<BodyTag>(impl_->bodies.slots); }
std::vector<Joint> World::joints() const { return all<JointTag>(impl_->joints.slots); }
std::vector<ForceId> World::forces() const { return all<ForceTag>(impl_->forces.slots); }
std::vector<SensorId> World::sensors() const { return all<SensorTag>(impl_->sensor_slots); }

Body World::find(std::string_view name) const {
  const Impl& w = *impl_;
  const auto at = w.named.find(std::string(name));
  return at == w.named.end() ? Body{} : w.bodies.slots.handle<BodyTag>(at->second.front());
}

BodyView World::operator[](Body b) const {
  impl_->require(b, "body");
  return {this, b.index};
}
ShapeView World::operator[](ShapeId s) const {
  impl_->require(s, "shape");
  return {this, s.index};
}
JointView World::operator[](Joint j) const {
  impl_->require(j, "joint");
  return {this, j.index};
}
const Force& World::operator[](ForceId f) const {
  impl_->require(f, "force");
  return impl_->forces.definition[f.index];
}
const Sensor& World::operator[](SensorId s) const {
  impl_->require(s, "sensor");
  return impl_->sensors[s.index];
}
double World::value(SensorId s) const {
  impl_->require(s, "sensor");
  return impl_->sensor_memory[s.index].value;
}

// --- bodies ---

Pose BodyView::pose() const { return world_->impl().bodies.given_pose(index_); }
Pos BodyView::center() const { return world_->impl().bodies.position[index_]; }
Vec3 BodyView::velocity() const { return world_->impl().bodies.velocity[index_]; }
Vec3 BodyView::spin() const { return world_->impl().bodies.spin[index_]; }
Vec3 BodyView::angular_momentum() const { return world_->impl().bodies.angular_momentum[index_]; }
Vec3 BodyView::velocity_at(const Pos& point) const { return velocity() + cross(spin(), point - center()); }
Real BodyView::mass() const { return world_->impl().bodies.mass[index_]; }
Mat3 BodyView::inertia() const { return world_->impl().bodies.inertia_world(index_); }
double BodyView::kinetic_energy() const {
  const Bodies& b = world_->impl().bodies;
  if (!b.dynamic(index_)) return 0;
  const Vec3d v = convert<double>(b.velocity[index_]);
  return 0.5 * (double(b.mass[index_]) * dot(v, v) +
                dot(convert<double>(b.spin[index_]), convert<double>(b.angular_momentum[index_])));
}
std::vector<ShapeId> BodyView::shapes() const {
  const Bodies& b = world_->impl().bodies;
  std::vector<ShapeId> shapes;
  b.each_shape(index_, [&](std::uint32_t s) { shapes.push_back(b.shapes.slots.handle<ShapeTag>(s)); });
  return shapes;
}
ShapeView BodyView::first() const { return {world_, world_->impl().bodies.first_shape[index_]}; }
const Shape& BodyView::shape() const { return first().shape(); }
const Material& BodyView::material() const { return first().material(); }
const Vec3& BodyView::surface_velocity() const { return first().surface_velocity(); }
Real BodyView::radius() const { return world_->impl().bodies.radius[index_]; }
const std::string& BodyView::name() const { return world_->impl().body_names[index_]; }
Motion BodyView::motion() const { return world_->impl().bodies.motion[index_]; }
Real BodyView::gravity_factor() const { return world_->impl().bodies.gravity_factor[index_]; }
bool BodyView::asleep() const { return world_->impl().bodies.asleep[index_] != 0; }
bool BodyView::quarantined() const { return world_->impl().bodies.quarantined[index_] != 0; }

// --- shapes ---

Body ShapeView::body() const {
  const Bodies& b = world_->impl().bodies;
  return b.slots.handle<BodyTag>(b.shapes.body[index_]);
}
Pose ShapeView::pose() const { return world_->impl().bodies.shape_pose(index_); }
Transform ShapeView::at() const { return world_->impl().bodies.shapes.pose[index_]; }
const Shape& ShapeView::shape() const { return world_->impl().geometry[world_->impl().bodies.shapes.geometry[index_]]; }
Real ShapeView::density() const { return world_->impl().bodies.shapes.density[index_]; }
const Material& ShapeView::material() const { return world_->impl().bodies.shapes.material[index_]; }
const Vec3& ShapeView::surface_velocity() const { return world_->impl().bodies.shapes.surface_velocity[index_]; }
const Filter& ShapeView::filter() const { return world_->impl().bodies.shapes.filter[index_]; }

// --- joints ---

const JointDef& JointView::definition() const { return world_->impl().joints.definition[index_]; }
Pos JointView::anchor_a() const { return sudar::anchor_a(world_->impl().joints, world_->impl().bodies, index_); }
Pos JointView::anchor_b() const { return sudar::anchor_b(world_->impl().joints, world_->impl().bodies, index_); }
Quat JointView::frame_a() const { return sudar::frame_a(world_->impl().joints, world_->impl().bodies, index_); }
Quat JointView::frame_b() const { return sudar::frame_b(world_->impl().joints, world_->impl().bodies, index_); }
Real JointView::gap() const { return gap_of(world_->impl().joints, world_->impl().bodies, index_); }
Real JointView::coordinate() const {
  const Joints& j = world_->impl().joints;
  const JointRows rows = rows_of(j, world_->impl().bodies, index_);
  return unwind(j.coordinate[index_], rows.value, rows.period);
}
Wrench JointView::load() const {
  const World::Impl& w = world_->impl();
  const JointRows rows = rows_of(w.joints, w.bodies, index_);
  const JointImpulse& impulse = w.joints.impulse[index_];
  Wrench on_b;
  const std::uint32_t b = w.joints.b[index_];
  const Vec3 arm = b == no_body ? Vec3{} : rotate(w.bodies.orientation[b], w.joints.anchor_b[index_]);
  const auto add = [&](const Row& row, Real lambda) {
    if (w.h <= 0) return;
    const Vec3 force = row.linear_b * (-lambda / Real(w.h));
    on_b.force += force;
    on_b.torque += row.angular_b * (-lambda / Real(w.h)) - cross(arm, force);
  };
  for (std::size_t r = 0; r < std::size_t(rows.count); ++r) add(rows.rows[r], impulse.rows[r] + impulse.struck[r]);
  if (rows.free) add(rows.rate, impulse.low + impulse.high + impulse.drive + impulse.struck_limit);
  return on_b;
}

// --- contacts and rays ---

namespace {

// Whether the surfaces move along each other there, by the 0.1 mm/s that also keep them from sleep. A contact that holds
// with all that its cone allows does not slip.
bool slides(const World& w, const Contact& c) {
  const Real still = Real(1e-4) * w.config().length_unit;
  const Bodies& b = w.impl().bodies;
  const Vec3 surfaces = b.surface_velocity_world(c.shape_a.index) - b.surface_velocity_world(c.shape_b.index);
  for (std::size_t k = 0; k < std::size_t(c.count); ++k) {
    const Vec3 u = w[c.a].velocity_at(c.points[k].at) - w[c.b].velocity_at(c.points[k].at) + surfaces;
    if (length(u - c.normal * dot(u, c.normal)) > still) return true;
  }
  return false;
}

}

std::vector<Contact> World::contacts() const {
  const Impl& w = *impl_;
  std::vector<Contact> contacts;
  for (const std::uint32_t pair : w.pairs.sorted()) {
    const PairRow& row = w.pairs[pair];
    if (row.row == no_row) continue;
    const auto [a, b] = w.bodies_of(row.key);
    const Material material = w.pair_material(row.key);
    const ContactImpulse& impulse = w.contacts.impulse[row.row];
    Contact c{w.bodies.slots.handle<BodyTag>(a), w.bodies.slots.handle<BodyTag>(b), row.manifold.normal, {},
              row.manifold.count, material.friction_static, material.friction_dynamic, material.restitution,
              false, w.bodies.shapes.slots.handle<ShapeTag>(row.key.a), w.bodies.shapes.slots.handle<ShapeTag>(row.key.b)};
    const Pos origin = w.bodies.shape_pose(row.key.a).p;
    for (std::size_t k = 0; k < std::size_t(c.count); ++k) {
      const ManifoldPoint& p = row.manifold.points[k];
      const Real cone = material.friction_static * impulse.normal[k];
      c.points[k] = {origin + p.at, p.separation, impulse.normal[k], impulse.friction[k],
                     cone > 0 ? length(impulse.friction[k]) / cone : Real(0)};
    }
    c.slipping = w.contacts.slipping[row.row] != 0 && slides(*this, c);
    contacts.push_back(c);
  }
  return contacts;
}

Material World::pair_material(Body a, Body b) const {
  impl_->require(a, "a");
  impl_->require(b, "b");
  const Bodies& all = impl_->bodies;
  return impl_->pair_material({all.first_shape[a.index], all.first_shape[b.index]});
}

bool World::touching(Body a, Body b) const {
  impl_->require(a, "a");
  impl_->require(b, "b");
  const Impl& w = *impl_;
  bool touch = false;
  w.bodies.each_shape(a.index, [&](std::uint32_t s) {
    w.pairs.each(s, [&](std::uint32_t p) {
      const auto [one, two] = w.bodies_of(w.pairs[p].key);
      touch |= w.pairs[p].row != no_row && (one == a.index ? two : one) == b.index;
    });
  });
  return touch;
}

std::optional<RayHit> World::ray_cast(const Pos& from, const Vec3& direction, Real reach) const {
  const std::vector<RayHit> hits = ray_cast(from, direction, reach, RayQuery{});
  return hits.empty() ? std::nullopt : std::optional(hits.front());
}

std::vector<RayHit> World::ray_cast(const Pos& from, const Vec3& direction, Real reach, const RayQuery& query) const {
  if (!is_finite(direction) || abs(length(direction) - 1) > Real(1e-3)) throw Error("direction", "must have length 1");
  if (!is_finite(from)) throw Error("from", "is not finite");
  if (!(reach >= 0)) throw Error("length", "must not be negative");
  Impl& w = *impl_;
  w.settle_boxes();
  std::vector<RayHit> hits;
  BoxRay ray(from, direction, reach);
  const auto look = [&](std::uint32_t i) {
    const Shapes& shapes = w.bodies.shapes;
    if (!shapes.slots.used(i) || !may_touch(query.filter, shapes.filter[i])) return;
    const Pose& pose = w.shape_poses[i];
    const Vec3 local = pose.local(from);
    RayOnGeometry hit{0, -direction};
    if (query.from_inside && contains(*w.geometries[i], local)) {
    } else if (sudar::ray_cast(*w.geometries[i], local, rotate_back(pose.q, direction), Real(ray.reach), hit)) {
      hit.normal = rotate(pose.q, hit.normal);
    } else {
      return;
    }
    hits.push_back({w.bodies.slots.handle<BodyTag>(shapes.body[i]), from + direction * hit.distance, hit.normal, hit.distance,
                    shapes.slots.handle<ShapeTag>(i)});
    if (!query.all) ray.reach = double(hit.distance);
  };
  for (const PlaneProxy& plane : w.planes) look(plane.proxy);
  w.broad->cast(w.proxies, ray, look);
  const auto order = [](const RayHit& p, const RayHit& q) {
    return p.distance != q.distance ? p.distance < q.distance : p.shape.index < q.shape.index;
  };
  std::sort(hits.begin(), hits.end(), order);
  hits.erase(std::unique(hits.begin(), hits.end(), [](auto& p, auto& q) { return p.shape == q.shape; }), hits.end());
  if (!query.all && hits.size() > 1) hits.resize(1);
  return hits;
}

SignedDistance World::distance(Body a, Body b) const {
  std::optional<SignedDistance> nearest;
  for (const ShapeId s : (*this)[a].shapes()) {
    for (const ShapeId t : (*this)[b].shapes()) {
      const ShapeView of_a = (*this)[s], of_b = (*this)[t];
      const SignedDistance d = sudar::distance(of_a.shape(), of_a.pose(), of_b.shape(), of_b.pose());
      if (!nearest || d.value < nearest->value) nearest = d;
    }
  }
  return *nearest;
}

// --- sums ---

std::vector<Box> World::fat_boxes() const {
  std::vector<Box> boxes;
  for (const Proxy& proxy : impl_->proxies) {
    if (proxy.present) boxes.push_back(proxy.box);
  }
  return boxes;
}

std::vector<Box> World::broad_boxes() const {
  std::vector<Box> boxes;
  impl_->broad->inner_boxes(boxes);
  return boxes;
}

std::vector<std::uint32_t> World::islands() const {
  const Impl& w = *impl_;
  std::vector<std::uint32_t> all;
  for (const Body b : bodies()) all.push_back(b.index);
  Unions islands;
  islands.reset(w.bodies.size(), all);
  const auto unite = [&](std::uint32_t a, std::uint32_t b) {
    if (a != no_body && b != no_body && w.bodies.dynamic(a) && w.bodies.dynamic(b)) islands.unite(a, b);
  };
  for (const std::uint32_t pair : w.pairs.sorted()) {
    const PairRow& row = w.pairs[pair];
    if (row.row != no_row) unite(w.body_of(row.key.a), w.body_of(row.key.b));
  }
  for (const Joint j : joints()) unite(w.joints.a[j.index], w.joints.b[j.index]);
  std::vector<std::uint32_t> roots;
  for (const Body b : bodies()) roots.push_back(islands.root(b.index));
  return roots;
}

Energy World::energy() const {
  Energy e;
  for (const Body b : bodies()) e.kinetic += (*this)[b].kinetic_energy();
  e.potential = potential_energy(impl_->forces, impl_->bodies);
  return e;
}

Momentum World::momentum() const {
  Momentum sum;
  const Bodies& b = impl_->bodies;
  for (std::uint32_t i = 0; i < b.size(); ++i) {
    if (!b.slots.used(i) || !b.dynamic(i)) continue;
    const Vec3d p = convert<double>(b.velocity[i]) * double(b.mass[i]);
    const Vec3d x{b.position[i].x, b.position[i].y, b.position[i].z};
    sum.linear += p;
    sum.angular += cross(x, p) + convert<double>(b.angular_momentum[i]);
  }
  return sum;
}

Quality World::quality() const {
  Quality q;
  Real sum = 0;
  int points = 0;
  for (const std::uint32_t pair : impl_->pairs.sorted()) {
    const PairRow& row = impl_->pairs[pair];
    if (row.row == no_row) continue;
    for (std::size_t k = 0; k < std::size_t(row.manifold.count); ++k) {
      const Real depth = max(Real(0), -row.manifold.points[k].separation);
      q.penetration_max = max(q.penetration_max, depth);
      sum += depth;
      ++points;
    }
  }
  if (points > 0) q.penetration_mean = sum / Real(points);
  sum = 0;
  for (const Joint j : joints()) {
    const Real gap = (*this)[j].gap();
    q.joint_gap_max = max(q.joint_gap_max, gap);
    sum += gap;
  }
  if (impl_->joints.slots.live() > 0) q.joint_gap_mean = sum / Real(impl_->joints.slots.live());
  return q;
}

}
