// Save, load, hash. A snapshot is a header, the geometry, then the state in the order below; the hash is of the state.
#include "base/hash.h"
#include "world/impl.h"

namespace sudar::inline SUDAR_PRECISION {

namespace {

constexpr std::uint64_t magic = 0x31302e7261647573;  // "sudar.01" as bytes
constexpr std::uint32_t version = 1, precision = sizeof(Real);

// Proxies have padding, so they go field by field; all but the box follows from the bodies.
void write_proxies(Writer& w, const std::vector<Proxy>& proxies) {
  for (const Proxy& p : proxies) w.raw(&p.box, sizeof p.box);
}
void read_proxies(Reader& r, const Bodies& bodies, std::vector<Proxy>& proxies) {
  proxies.resize(bodies.size());
  for (Proxy& p : proxies) r.raw(&p.box, sizeof p.box);
}

}

void World::Impl::write_state(Writer& w) const {
  write(w, config);
  write(w, bodies);
  for (const std::string& name : body_names) w.text(name);
  write(w, joints);
  write(w, forces);
  write(w, contacts);
  write(w, sensor_slots);
  for (const Sensor& s : sensors) write(w, s);
  w.array(sensor_memory);
  w.array(pairs);
  write_proxies(w, proxies);
  w.value(steps), w.value(clock_start), w.value(clock_step), w.value(clock_steps);
}

void World::Impl::read_state(Reader& r) {
  read(r, config);
  read(r, bodies);
  body_names.resize(bodies.size());
  for (std::string& name : body_names) name = r.text();
  read(r, joints);
  read(r, forces);
  read(r, contacts);
  read(r, sensor_slots);
  sensors.resize(sensor_slots.size());
  for (Sensor& s : sensors) read(r, s);
  r.array(sensor_memory);
  r.array(pairs);
  read_proxies(r, bodies, proxies);
  steps = r.value<std::int64_t>(), clock_start = r.value<double>(), clock_step = r.value<double>();
  clock_steps = r.value<std::int64_t>();
  if (r.left() != 0) throw Error("data", "goes on after its end");
  for (std::uint32_t i = 0; i < bodies.size(); ++i) {
    if (bodies.geometry[i] >= geometry.size()) throw Error("data", "names a geometry that it does not hold");
  }
  for (const PairRow& row : pairs) {
    if (row.key.a >= bodies.size() || row.key.b >= bodies.size() || row.manifold.count < 0 || row.manifold.count > 4 ||
        (row.row != no_row && !contacts.slots.used(row.row))) {
      throw Error("data", "holds a contact of bodies that it does not hold");
    }
  }
  for (std::uint32_t j = 0; j < joints.size(); ++j) {
    for (const std::uint32_t body : {joints.a[j], joints.b[j]}) {
      if (body != no_body && body >= bodies.size()) throw Error("data", "joins bodies that it does not hold");
    }
  }
  for (std::uint32_t i = 0; i < bodies.size(); ++i) {
    Proxy& p = proxies[i];
    p.filter = bodies.filter[i];
    p.fixed = bodies.motion[i] == Motion::fixed;
    p.present = bodies.slots.used(i) && bodies.quarantined[i] == 0 && !is_half_space(i);
  }
  rebuild();
}

std::uint64_t World::Impl::hash() const {
  Writer w;
  write_state(w);
  return hash_bytes(w.bytes().data(), w.bytes().size());
}

Bytes World::save() const {
  Writer w;
  w.value(magic), w.value(version), w.value(precision);
  write(w, impl_->geometry);
  impl_->write_state(w);
  return w.take();
}

void World::load(std::span<const std::byte> bytes) {
  Reader r(bytes);
  if (r.left() < sizeof magic || r.value<std::uint64_t>() != magic) throw Error("data", "is not a snapshot of a world");
  if (const auto v = r.value<std::uint32_t>(); v != version) {
    throw Error("version", "is " + std::to_string(v) + ", this program reads " + std::to_string(version));
  }
  if (const auto p = r.value<std::uint32_t>(); p != precision) {
    throw Error("precision", std::string("is ") + (p == 4 ? "float" : "double") + ", this program has the other one");
  }
  auto fresh = std::make_unique<Impl>(Config{});
  read(r, fresh->geometry);
  fresh->read_state(r);
  fresh->recording = impl_->recording;
  impl_ = std::move(fresh);
}

std::uint64_t World::hash() const { return impl_->hash(); }

std::uint64_t World::pose_hash() const {
  const Bodies& b = impl_->bodies;
  Hasher h;
  for (std::uint32_t i = 0; i < b.size(); ++i) {
    if (b.slots.used(i)) h.add(b.position[i]).add(b.orientation[i]).add(b.velocity[i]).add(b.spin[i]);
  }
  return h.value();
}

}
