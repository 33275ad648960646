// The C interface: every function catches what the engine throws and keeps it for sudar_error().
#include "sudar.h"

#include <sudar/version.h>
#include <sudar/world.h>

#include <algorithm>
#include <cctype>
#include <cstring>

#include "definition.h"

using namespace sudar;

struct sudar_world {
  World world;
};
struct sudar_shape {
  Shape shape;
};
struct sudar_definition {
  std::variant<BodyDef, Config, Sensor, JointDef, Force> value;
};

namespace {

thread_local std::string failure, failed_field;

void keep(const char* reason, const std::string& field) noexcept {
  try {
    failure = reason, failed_field = field;
  } catch (...) {  // no memory left
    failure.clear(), failed_field.clear();
  }
}

// f(), or `otherwise` when it throws.
template <class T, class F>
T guarded(T otherwise, F f) noexcept {
  try {
    return f();
  } catch (const Error& e) { keep(e.what(), e.field); } catch (const std::exception& e) {
    keep(e.what(), "");
  } catch (...) { keep("an unknown failure", ""); }
  return otherwise;
}
template <class F>
int done(F f) noexcept {
  return guarded(-1, [&] { return f(), 0; });
}

template <class T>
T& given(T* p, const char* what) {
  if (!p) throw Error(what, "is NULL");
  return *p;
}
Vec3 vector(const double* v, const char* what) {
  given(v, what);
  return {Real(v[0]), Real(v[1]), Real(v[2])};
}
Pos point(const double* v, const char* what) { return given(v, what), Pos{v[0], v[1], v[2]}; }
template <class V>
void put(const V& v, double* to) {
  if (to) to[0] = double(v.x), to[1] = double(v.y), to[2] = double(v.z);
}

// --- handles: an index of 30 bits, and above it what it is of; then generation and world ---

constexpr std::uint32_t index_bits = 30;
template <class H>
constexpr std::uint32_t kind_of = std::is_same_v<H, Body>      ? 0
                                  : std::is_same_v<H, Joint>   ? 1
                                  : std::is_same_v<H, ForceId> ? 2
                                                               : 3;

template <class H>
sudar_handle out(H h) {
  if (h.index >> index_bits) throw Error("handle", "has too large an index");
  const std::uint64_t low = h.index | kind_of<H> << index_bits;
  return low | std::uint64_t(h.generation) << 32 | std::uint64_t(h.world) << 52;
}
template <class H>
H in(sudar_handle h, const char* what) {
  H result;
  if (h == SUDAR_NONE) return result;
  if ((h >> index_bits & 3) != kind_of<H>) throw Error(what, "is a handle of something else");
  result.index = std::uint32_t(h & ((1u << index_bits) - 1));
  result.generation = std::uint32_t(h >> 32) & H::last_generation;
  result.world = std::uint32_t(h >> 52) & (H::worlds - 1);
  return result;
}

template <class F>
sudar_shape* shape(F make) noexcept {
  return guarded<sudar_shape*>(nullptr, [&] { return new sudar_shape{make()}; });
}

// "impulse_2007" is no kind, "Hinge" and "hinge" are the same.
bool same_name(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) {
    return std::tolower(static_cast<unsigned char>(x)) == std::tolower(static_cast<unsigned char>(y));
  });
}

template <class Value>
int set(sudar_definition* d, const char* path, const Value& value) noexcept {
  return done([&] {
    const std::string_view whole = &given(path, "path");
    const auto apply = [&](auto& definition) { c::PathSetter<Value>::apply(definition, whole, whole, value); };
    auto copy = given(d, "definition").value;
    std::visit(
        [&](auto& definition) {
          if constexpr (requires { definition.index(); })
            std::visit(apply, definition);
          else
            apply(definition);
        },
        copy);
    d->value = std::move(copy);
  });
}

}

const char* sudar_error(void) { return failure.c_str(); }
const char* sudar_error_field(void) { return failed_field.c_str(); }
const char* sudar_version(void) { return SUDAR_VERSION; }

sudar_shape* sudar_sphere(double radius) {
  return shape([=] { return sphere(Real(radius)); });
}
sudar_shape* sudar_capsule(double radius, double length) {
  return shape([=] { return capsule(Real(radius), Real(length)); });
}
sudar_shape* sudar_cylinder(double radius, double height) {
  return shape([=] { return cylinder(Real(radius), Real(height)); });
}
sudar_shape* sudar_cone(double radius, double height) {
  return shape([=] { return cone(Real(radius), Real(height)); });
}
sudar_shape* sudar_box(double x, double y, double z) {
  return shape([=] { return box({Real(x), Real(y), Real(z)}); });
}
sudar_shape* sudar_half_space(void) {
  return shape([] { return half_space(); });
}
sudar_shape* sudar_hull(const double* points, size_t count) {
  return shape([=] {
    std::vector<Vec3> all;
    for (std::size_t i = 0; i < count; ++i) all.push_back(vector(points ? points + 3 * i : nullptr, "points"));
    return hull(all);
  });
}
void sudar_shape_free(sudar_shape* s) { delete s; }

namespace {
// The kinds, from the variants themselves.
template <class Variant, std::size_t i = 0>
bool pick(std::string_view kind, Variant& to) {
  if constexpr (i == std::variant_size_v<Variant>) {
    return false;
  } else {
    using T = std::variant_alternative_t<i, Variant>;
    if (same_name(kind, name_of_type<T>())) return to.template emplace<i>(), true;
    return pick<Variant, i + 1>(kind, to);
  }
}
}

sudar_definition* sudar_define(const char* kind) {
  return guarded<sudar_definition*>(nullptr, [&] {
    const std::string_view name = &given(kind, "kind");
    sudar_definition d;
    if (JointDef joint; name == "body")
      d.value = BodyDef{};
    else if (name == "config")
      d.value = Config{};
    else if (name == "sensor")
      d.value = Sensor{};
    else if (pick(name, joint))
      d.value = joint;
    else if (Force force; pick(name, force))
      d.value = force;
    else
      throw Error("kind", "\"" + std::string(name) + "\" is none of body, config, sensor, the joints and the forces");
    return new sudar_definition(std::move(d));
  });
}
void sudar_definition_free(sudar_definition* d) { delete d; }

int sudar_set_number(sudar_definition* d, const char* path, double value) {
  return set(d, path, c::NumbersValue{std::span(&value, 1)});
}
int sudar_set_numbers(sudar_definition* d, const char* path, size_t count, const double* values) {
  return set(d, path, c::NumbersValue{std::span(values, values ? count : 0)});
}
int sudar_set_text(sudar_definition* d, const char* path, const char* value) {
  return set(d, path, c::TextValue{value ? value : ""});
}
int sudar_set_shape(sudar_definition* d, const char* path, const sudar_shape* s) {
  return set(d, path, c::PlainValue<Shape>{s ? s->shape : Shape{}});
}
int sudar_set_body(sudar_definition* d, const char* path, sudar_handle body) {
  Body b;
  if (done([&] { b = in<Body>(body, "body"); }) != 0) return -1;
  return set(d, path, c::PlainValue<Body>{b});
}

sudar_world* sudar_world_new(const sudar_definition* config) {
  return guarded<sudar_world*>(nullptr, [&] {
    if (!config) return new sudar_world{World()};
    const Config* const c = std::get_if<Config>(&config->value);
    if (!c) throw Error("config", "is another kind of definition");
    return new sudar_world{World(*c)};
  });
}
void sudar_world_free(sudar_world* w) { delete w; }

sudar_handle sudar_add(sudar_world* w, const sudar_definition* d) {
  return guarded<sudar_handle>(SUDAR_NONE, [&] {
    World& world = given(w, "world").world;
    const auto add = [&](const auto& definition) -> sudar_handle {
      using T = std::decay_t<decltype(definition)>;
      if constexpr (std::is_same_v<T, Config>)
        throw Error("definition", "is a configuration: that is for sudar_world_new()");
      else if constexpr (std::is_same_v<T, JointDef>)
        return out(world.join(definition));
      else
        return out(world.add(definition));
    };
    return std::visit(add, given(d, "definition").value);
  });
}
int sudar_remove(sudar_world* w, sudar_handle h) {
  return done([&] {
    World& world = given(w, "world").world;
    switch (h >> index_bits & 3) {
      case kind_of<Body>:
        return world.remove(in<Body>(h, "handle"));
      case kind_of<Joint>:
        return world.remove(in<Joint>(h, "handle"));
      case kind_of<ForceId>:
        return world.remove(in<ForceId>(h, "handle"));
      default:
        return world.remove(in<SensorId>(h, "handle"));
    }
  });
}
int sudar_step(sudar_world* w, size_t steps) {
  return done([&] {
    for (std::size_t i = 0; i < steps; ++i) given(w, "world").world.step();
  });
}
double sudar_time(const sudar_world* w) {
  return guarded(0.0, [&] { return given(w, "world").world.time(); });
}
uint64_t sudar_hash(const sudar_world* w) {
  return guarded<std::uint64_t>(0, [&] { return given(w, "world").world.hash(); });
}
uint64_t sudar_motion_hash(const sudar_world* w) {
  return guarded<std::uint64_t>(0, [&] { return given(w, "world").world.motion_hash(); });
}

int sudar_get_pose(const sudar_world* w, sudar_handle body, double position[3], double orientation[4]) {
  return done([&] {
    const Pose pose = given(w, "world").world[in<Body>(body, "body")].pose();
    put(pose.p, position), put(pose.q, orientation);
    if (orientation) orientation[3] = double(pose.q.w);
  });
}
int sudar_get_velocity(const sudar_world* w, sudar_handle body, double velocity[3], double spin[3]) {
  return done([&] {
    const BodyView b = given(w, "world").world[in<Body>(body, "body")];
    put(b.velocity(), velocity), put(b.spin(), spin);
  });
}
int sudar_set_pose(sudar_world* w, sudar_handle body, const double position[3], const double orientation[4]) {
  return done([&] {
    const double* const q = &given(orientation, "orientation");
    given(w, "world")
        .world.place(in<Body>(body, "body"),
                     {point(position, "position"), {Real(q[0]), Real(q[1]), Real(q[2]), Real(q[3])}});
  });
}
int sudar_set_velocity(sudar_world* w, sudar_handle body, const double velocity[3], const double spin[3]) {
  return done([&] {
    given(w, "world").world.set_velocity(in<Body>(body, "body"), vector(velocity, "velocity"), vector(spin, "spin"));
  });
}
int sudar_push(sudar_world* w, sudar_handle body, const double force[3], const double at[3]) {
  return done([&] {
    World& world = given(w, "world").world;
    const Body b = in<Body>(body, "body");
    world.push(b, vector(force, "force"), at ? point(at, "at") : world[b].center());
  });
}
int sudar_twist(sudar_world* w, sudar_handle body, const double torque[3]) {
  return done([&] { given(w, "world").world.twist(in<Body>(body, "body"), vector(torque, "torque")); });
}
int sudar_get_coordinate(const sudar_world* w, sudar_handle joint, double* coordinate) {
  return done([&] {
    given(coordinate, "coordinate") = double(given(w, "world").world[in<Joint>(joint, "joint")].coordinate());
  });
}
int sudar_ray_cast(const sudar_world* w, const double from[3], const double direction[3], double length,
                   sudar_handle* body, double at[3], double normal[3]) {
  return guarded(-1, [&] {
    const auto hit =
        given(w, "world").world.ray_cast(point(from, "from"), vector(direction, "direction"), Real(length));
    if (body) *body = hit ? out(hit->body) : SUDAR_NONE;
    if (!hit) return 0;
    put(hit->at, at), put(hit->normal, normal);
    return 1;
  });
}

size_t sudar_save(const sudar_world* w, void* buffer, size_t size) {
  return guarded<std::size_t>(0, [&] {
    const Bytes data = given(w, "world").world.save();
    if (buffer && size >= data.size()) std::memcpy(buffer, data.data(), data.size());
    return data.size();
  });
}
int sudar_load(sudar_world* w, const void* data, size_t size) {
  return done([&] { given(w, "world").world.load(std::span(static_cast<const std::byte*>(data), data ? size : 0)); });
}
