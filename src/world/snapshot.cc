// Save, load, hash. A snapshot is a header, the world's number, the geometry, then the state in the order below; the hash
// is of the state.
#include "base/file_header.h"
#include "geometry/triangle_mesh.h"
#include "world/impl.h"
#include "world/validate.h"

namespace sudar::inline SUDAR_PRECISION {

namespace {

constexpr std::uint64_t magic = 0x31302e7261647573;  // "sudar.01" as bytes

}

// Of a proxy only its box is state: the rest follows from its shape and body.
void write(Writer& w, const Proxy& p) { w.named("low", p.box.low), w.named("high", p.box.high); }
void read(Reader& r, Proxy& p) { read(r, p.box.low), read(r, p.box.high); }

// Rows lie in the table as history left them; in a snapshot they lie by key.
void write(Writer& w, const PairTable& pairs) {
  const std::vector<std::uint32_t> all = pairs.sorted();
  w.rows<PairRow>(all.size(), [&](std::size_t i) -> const PairRow& { return pairs[all[i]]; });
}
void read(Reader& r, std::uint32_t shapes, PairTable& pairs) {
  std::vector<PairRow> rows;
  r.array(rows);
  pairs.clear();
  const PairRow* before = nullptr;
  for (const PairRow& row : rows) {
    if (row.key.a >= row.key.b || row.key.b >= shapes || (before != nullptr && !(before->order() < row.order())))
      throw Error("data", "holds a contact of shapes that it does not hold");
    before = &row;
    pairs[pairs.add(row.key, row.part)] = row;
  }
}

// Until when each pair is not looked at, in the same order.
std::vector<double> watches_of(const World::Impl& w) {
  std::vector<double> until;
  for (const std::uint32_t p : w.pairs.sorted()) until.push_back(w.pairs.watches()[p].until);
  return until;
}

void World::Impl::write_state(Writer& w) const {
  Config of_world = config;
  of_world.workers = 1;  // how many there are is the machine's, not the world's
  w.named("config", of_world);
  w.named("bodies", bodies);
  w.named("shapes", bodies.shapes);
  w.each("bodies.name", body_names);
  w.named("pair_materials", pair_materials);
  w.named("joints", joints);
  w.named("forces", forces);
  w.named("contacts", contacts);
  w.named("sensor_slots", sensor_slots);
  w.each("sensors", sensors);
  w.named("sensor_memory", sensor_memory);
  w.named("pairs", pairs);
  w.named("pairs.until", watches_of(*this));
  w.named("shapes.way", way);
  w.each("shapes.fat_box", proxies);
  w.named("steps", steps);
  w.named("clock_start", clock_start), w.named("clock_step", clock_step), w.named("clock_steps", clock_steps);
}

void World::Impl::read_state(Reader& r) {
  read(r, config);
  read(r, bodies);
  read(r, bodies.shapes);
  body_names.resize(bodies.size());
  for (std::string& name : body_names) name = r.text();
  r.array(pair_materials);
  read(r, joints);
  read(r, forces);
  read(r, contacts);
  read(r, sensor_slots);
  sensors.resize(sensor_slots.size());
  for (Sensor& s : sensors) read(r, s);
  r.array(sensor_memory);
  read(r, bodies.shapes.size(), pairs);
  std::vector<double> until;
  r.array(until);
  r.array(way);
  const std::vector<std::uint32_t> all = pairs.sorted();
  if (until.size() != all.size() || way.size() != bodies.shapes.size()) throw Error("data", "has arrays of different lengths");
  for (std::size_t i = 0; i < all.size(); ++i) pairs.watches()[all[i]].until = until[i];
  proxies.resize(bodies.shapes.size());
  for (Proxy& p : proxies) read(r, p);
  steps = r.value<std::int64_t>(), clock_start = r.value<double>(), clock_step = r.value<double>();
  clock_steps = r.value<std::int64_t>();
  if (r.left() != 0) throw Error("data", "goes on after its end");
  check_state();
  rebuild();
}

namespace {

[[noreturn]] void bad(const char* reason) { throw Error("data", reason); }

void check_body(const World::Impl& w, std::uint32_t i) {
  const Bodies& b = w.bodies;
  if (!b.slots.used(i)) return;
  if (int(b.motion[i]) >= count_of(b.motion[i])) bad("holds a body whose motion is unknown");
  if (b.motion[i] != Motion::dynamic && b.inverse_mass[i] != 0) bad("holds a fixed body that moves");
  const bool finite = is_finite(b.position[i]) && is_finite(b.orientation[i]) && is_finite(b.velocity[i]) &&
                      is_finite(b.angular_momentum[i]) && is_finite(b.spin[i]);
  if (!finite) bad("holds a body that is nowhere");
}

// Every shape in use is in the list of its body, once, and in no other.
void check_shapes(const World::Impl& w) {
  const Bodies& b = w.bodies;
  const Shapes& shapes = b.shapes;
  std::vector<std::uint8_t> listed(shapes.size(), 0);
  std::uint32_t count = 0;
  for (std::uint32_t i = 0; i < b.size(); ++i) {
    if (!b.slots.used(i)) continue;
    if (b.first_shape[i] == no_shape) bad("holds a body without a shape");
    for (std::uint32_t s = b.first_shape[i]; s != no_shape; s = shapes.next[s]) {
      if (!shapes.slots.used(s) || shapes.body[s] != i || listed[s]++ != 0) bad("holds a body of shapes that are not its own");
      ++count;
      if (shapes.geometry[s] >= w.geometry.size()) bad("names a geometry that it does not hold");
      if (!may_have(b.motion[i], w.geometry_of(s).kind)) bad("holds a moving body without mass");
      const Transform& pose = shapes.pose[s];
      const bool finite = is_finite(pose.p) && is_finite(pose.q) && is_finite(shapes.center[s]);
      if (!finite || !is_finite(w.proxies[s].box.low) || !is_finite(w.proxies[s].box.high)) bad("holds a shape that is nowhere");
    }
  }
  if (count != shapes.slots.live()) bad("holds a shape of no body");
}

void check_pair_materials(const World::Impl& w) {
  const PairMaterial* before = nullptr;
  for (const PairMaterial& m : w.pair_materials) {
    const auto [a, b] = m.key;
    const bool known = a < b && b < w.bodies.size() && w.bodies.slots.used(a) && w.bodies.slots.used(b);
    if (!known || (before != nullptr && !(before->key < m.key))) bad("holds a material of bodies that it does not hold");
    validate("material", m.material);
    before = &m;
  }
}

// Parts are triangles of a mesh, and stand before their whole, which counts those that touch.
void check_parts(const World::Impl& w) {
  std::uint32_t touching = 0;
  const PairRow* part = nullptr;
  for (const std::uint32_t p : w.pairs.sorted()) {
    const PairRow& row = w.pairs[p];
    if (part != nullptr && !(part->key == row.key)) bad("holds a part of a contact that it does not hold");
    const Geometry &a = w.geometry_of(row.key.a), &b = w.geometry_of(row.key.b);
    const TriangleMesh* mesh = a.kind == ShapeKind::mesh ? a.mesh.get() : b.mesh.get();
    if (row.part != no_part) {
      const bool convex = has_mass(a.kind) || has_mass(b.kind);
      if (mesh == nullptr || !convex || row.part >= mesh->triangles.size()) bad("holds a contact with a triangle that it does not hold");
      touching += row.row != no_row ? 1 : 0;
      part = &row;
      continue;
    }
    if (row.touching != touching || (mesh != nullptr && row.row != no_row)) bad("holds a broken contact");
    touching = 0, part = nullptr;
  }
  if (part != nullptr) bad("holds a part of a contact that it does not hold");
}

void check_pairs(const World::Impl& w) {
  std::vector<std::uint8_t> taken(w.contacts.slots.size(), 0);
  for (const std::uint32_t p : w.pairs.sorted()) {
    const PairRow& row = w.pairs[p];
    const auto [a, b] = row.key;
    const Slots& shapes = w.bodies.shapes.slots;
    if (!shapes.used(a) || !shapes.used(b) || w.body_of(a) == w.body_of(b)) bad("holds a contact of shapes that it does not hold");
    const bool touching = (row.manifold.bits & Manifold::touching) != 0;
    if (row.manifold.count < 0 || row.manifold.count > 4 || touching != (row.row != no_row))
      bad("holds a broken contact");
    if (row.row == no_row) continue;
    if (!w.contacts.slots.used(row.row) || taken[row.row]++ != 0) bad("holds a broken contact");
  }
}

}

// Whoever writes a snapshot by hand gets an Error, and no world that reads or loops where it must not.
void World::Impl::check_state() const {
  validate("config", config);
  for (std::uint32_t i = 0; i < bodies.size(); ++i) check_body(*this, i);
  check_shapes(*this);
  check_pair_materials(*this);
  check_pairs(*this);
  check_parts(*this);
  for (std::uint32_t j = 0; j < joints.size(); ++j) {
    if (!joints.slots.used(j)) continue;
    for (const std::uint32_t body : {joints.a[j], joints.b[j]}) {
      if (body != no_body && !bodies.slots.used(body)) bad("joins bodies that it does not hold");
    }
  }
  for (std::uint32_t f = 0; f < forces.slots.size(); ++f) {
    const auto* thruster = std::get_if<Thruster>(&forces.definition[f]);
    if (forces.slots.used(f) && thruster != nullptr && !bodies.slots.alive(thruster->body))
      bad("pushes a body that it does not hold");
  }
  if (sensor_memory.size() != sensors.size()) bad("has arrays of different lengths");
  for (std::uint32_t s = 0; s < sensor_slots.size(); ++s) {
    if (!sensor_slots.used(s)) continue;
    const Body a = sensors[s].a, b = sensors[s].b;
    if (!bodies.slots.alive(a) || !(b.null() || bodies.slots.alive(b))) bad("measures a body that it does not hold");
  }
  if (!std::isfinite(clock_start) || !std::isfinite(clock_step)) bad("has no time");
}

std::uint64_t World::Impl::hash() const {
  HashWriter w;
  write_state(w);
  return w.hash();
}

std::uint64_t layout_of_state() {
  const World::Impl example(Config{}, 1);
  LayoutWriter w;
  write(w, example.geometry);
  example.write_state(w);
  return w.layout();
}

Bytes World::save() const {
  ByteWriter w;
  write_header(w, magic, layout_of_state());
  w.value(impl_->number);
  write(w, impl_->geometry);
  impl_->write_state(w);
  return w.take_sealed();
}

void World::load(std::span<const std::byte> bytes) { impl_->operate(Load{{bytes.begin(), bytes.end()}}); }

void World::Impl::perform(const Load& op) {
  Reader r(op.state);
  read_header(r, magic, layout_of_state(), "a snapshot of a world");
  const std::uint32_t saved = r.value<std::uint32_t>() % Body::worlds;
  r = Reader(unseal(op.state), r.position(), saved);
  Impl fresh(Config{}, saved);
  read(r, fresh.geometry);
  fresh.read_state(r);
  fresh.config.workers = config.workers;
  fresh.pool = std::move(pool);
  // Whoever records goes on recording.
  fresh.recording = recording;
  fresh.log = std::move(log);
  *this = std::move(fresh);
}

std::uint64_t World::hash() const { return impl_->hash(); }

std::uint64_t World::motion_hash() const {
  const Bodies& b = impl_->bodies;
  Hasher h;
  for (std::uint32_t i = 0; i < b.size(); ++i) {
    if (b.slots.used(i)) h.add(b.position[i]).add(b.orientation[i]).add(b.velocity[i]).add(b.spin[i]);
  }
  return h.value();
}

}
