#include "dynamics/bodies.h"

#include <algorithm>

#include "base/hash.h"
#include "geometry/principal.h"

namespace sudar::inline SUDAR_PRECISION {

static_assert(sizeof(Material) == 5 * sizeof(Real) && sizeof(Filter) == 12 && sizeof(Transform) == 7 * sizeof(Real),
              "arrays of these are saved as they lie in memory, so they must not have padding");

std::vector<ShapeDef> shapes_of(const BodyDef& def) {
  std::vector<ShapeDef> shapes = def.shapes;
  if (def.shape) shapes.push_back({.shape = def.shape});
  for (ShapeDef& part : shapes) {
    part.turn = normalize(part.turn);
    if (!part.density) part.density = def.density;
    if (!part.material) part.material = def.material;
    if (!part.surface_velocity) part.surface_velocity = rotate_back(part.turn, def.surface_velocity);
    if (!part.filter) part.filter = def.filter;
  }
  return shapes;
}

std::optional<MassSum> mass_of(const BodyDef& def, std::span<const ShapeDef> shapes) {
  std::vector<MassPart> parts;
  for (const ShapeDef& part : shapes) {
    if (!has_mass(part.shape.kind())) continue;
    parts.push_back({&part.shape.geometry().mass, {part.at, part.turn}, double(*part.density)});
  }
  if (parts.empty()) return {};
  MassSum sum = sum_masses(parts);
  if (def.mass > 0) sum.density = double(def.mass) / sum.unit.volume;
  if (def.center) sum.unit.center = convert<double>(*def.center);
  if (def.inertia) {
    const Mat3& tensor = *def.inertia;
    sum.unit.inertia = Mat3d{convert<double>(tensor.c0), convert<double>(tensor.c1), convert<double>(tensor.c2)} *
                       (1 / sum.density);
  }
  return sum;
}

std::uint32_t Bodies::add(const BodyDef& def, std::span<const ShapeDef> parts, std::span<const std::uint32_t> numbers) {
  const std::uint32_t i = slots.take();
#define FIELD(type, name, unit, stage) \
  if (i == name.size()) name.emplace_back(); else name[i] = type{};
#include "dynamics/fields.def"
  motion[i] = def.motion;
  gravity_factor[i] = def.gravity_factor;
  may_sleep[i] = def.sleeps ? 1 : 0;
  first_shape[i] = no_shape;
  std::vector<const Geometry*> geometries;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    add_shape(i, parts[k], numbers[k]);
    geometries.push_back(&parts[k].shape.geometry());
  }
  const std::optional<MassSum> sum = mass_of(def, parts);
  set_mass(i, sum, geometries);
  if (def.mass > 0 && sum) {  // the densities with which the parts have that mass
    const auto first = std::ranges::find_if(parts, [](const ShapeDef& p) { return has_mass(p.shape.kind()); });
    const double share = sum->density / double(*first->density);
    each_shape(i, [&](std::uint32_t s) { shapes.density[s] = Real(double(shapes.density[s]) * share); });
  }
  set_given_pose(i, {def.at, normalize(def.turn)});
  set_velocity(i, def.motion == Motion::fixed ? Vec3{} : def.velocity, def.motion == Motion::fixed ? Vec3{} : def.spin);
  return i;
}

void Bodies::remove(std::uint32_t i) {
  each_shape(i, [&](std::uint32_t s) { shapes.remove(s); });
  slots.give_back(i);
}

std::uint32_t Bodies::add_shape(std::uint32_t i, const ShapeDef& complete, std::uint32_t geometry) {
  const std::uint32_t s = shapes.add();
  std::uint32_t last = no_shape;
  each_shape(i, [&](std::uint32_t other) { last = other; });
  (last == no_shape ? first_shape[i] : shapes.next[last]) = s;
  shapes.body[s] = i;
  shapes.pose[s] = {complete.at, complete.turn};
  shapes.geometry[s] = geometry;
  shapes.density[s] = *complete.density;
  shapes.material[s] = *complete.material;
  shapes.surface_velocity[s] = *complete.surface_velocity;
  shapes.filter[s] = *complete.filter;
  return s;
}

void Bodies::remove_shape(std::uint32_t s) {
  std::uint32_t* link = &first_shape[shapes.body[s]];
  while (*link != s) link = &shapes.next[*link];
  *link = shapes.next[s];
  shapes.remove(s);
}

ShapeDef Bodies::complete(std::uint32_t i, const ShapeDef& def) const {
  ShapeDef whole = def;
  const std::uint32_t first = first_shape[i];
  whole.turn = normalize(def.turn);
  if (!def.density) whole.density = shapes.density[first];
  if (!def.material) whole.material = shapes.material[first];
  if (!def.surface_velocity) {
    whole.surface_velocity = rotate_back(whole.turn, rotate(shapes.pose[first].q, shapes.surface_velocity[first]));
  }
  if (!def.filter) whole.filter = shapes.filter[first];
  return whole;
}

void Bodies::set_mass(std::uint32_t i, const std::optional<MassSum>& sum, std::span<const Geometry* const> geometries) {
  frame[i] = {};
  mass[i] = inverse_mass[i] = 0;
  inertia[i] = inverse_inertia[i] = {};
  if (sum) {
    const PrincipalFrame principal = principal_frame(sum->unit);
    frame[i] = principal.shape;
    mass[i] = Real(sum->density * sum->unit.volume);
    if (motion[i] == Motion::dynamic) {
      inverse_mass[i] = 1 / mass[i];
      for (int k = 0; k < 3; ++k) {
        inertia[i][k] = Real(sum->density * principal.moments[k]);
        inverse_inertia[i][k] = 1 / inertia[i][k];
      }
    }
  }
  const Vec3d center = sum ? sum->unit.center : Vec3d{};
  radius[i] = swing[i] = 0;
  thickness[i] = std::numeric_limits<Real>::infinity();
  std::size_t k = 0;
  each_shape(i, [&](std::uint32_t s) {
    const Geometry& g = *geometries[k++];
    const Transform& pose = shapes.pose[s];
    const Vec3d own = convert<double>(pose.p) + rotate(convert<double>(pose.q), g.mass.center);
    const Vec3 origin = shape_frame(s).p;
    shapes.center[s] = rotate(frame[i].q, convert<Real>(own - center));  // of a body's only shape 0, without rounding
    shapes.radius[s] = g.bounding_radius + length(origin - shapes.center[s]);
    radius[i] = max(radius[i], g.bounding_radius + length(origin));
    swing[i] = max(swing[i], swing_radius(g) + length(origin));
    thickness[i] = min(thickness[i], inner_radius(g));
  });
}

Transform Bodies::renew_mass(std::uint32_t i, const std::optional<MassSum>& sum,
                             std::span<const Geometry* const> geometries) {
  const Transform before = frame[i];
  const Pose given = given_pose(i);
  const Pos center = position[i];
  set_mass(i, sum, geometries);
  set_given_pose(i, given);
  const Vec3 shift = position[i] - center;
  torque[i] -= cross(shift, force[i]);
  set_velocity(i, velocity[i] + cross(spin[i], shift), spin[i]);
  return frame[i] * inverse(before);
}

void Bodies::set_given_pose(std::uint32_t i, const Pose& pose) {
  orientation[i] = normalize(pose.q * conjugate(frame[i].q));
  position[i] = pose.p - rotate(orientation[i], frame[i].p);
}

void Bodies::set_velocity(std::uint32_t i, const Vec3& v, const Vec3& w) {
  velocity[i] = v;
  spin[i] = w;
  angular_momentum[i] = inertia_world(i) * w;
}

namespace {
Mat3 turned(const Quat& q, const Vec3& diagonal) {
  const Mat3 r = matrix(q);
  return Mat3{r.c0 * diagonal.x, r.c1 * diagonal.y, r.c2 * diagonal.z} * transpose(r);
}
}

Vec3 Bodies::surface_velocity_world(std::uint32_t s) const {
  if (shapes.surface_velocity[s] == Vec3{}) return {};
  return rotate(orientation[shapes.body[s]], rotate(shape_frame(s).q, shapes.surface_velocity[s]));
}

Mat3 Bodies::inertia_world(std::uint32_t i) const { return turned(orientation[i], inertia[i]); }
Mat3 Bodies::inverse_inertia_world(std::uint32_t i) const {
  return dynamic(i) ? turned(orientation[i], inverse_inertia[i]) : Mat3{};
}

void write(Writer& w, const Bodies& b) {
  write(w, b.slots);
#define FIELD(type, name, unit, stage) w.named(#name, b.name);
#include "dynamics/fields.def"
}

void read(Reader& r, Bodies& b) {
  read(r, b.slots);
#define FIELD(type, name, unit, stage) \
  r.array(b.name);                     \
  if (b.name.size() != b.size()) throw Error("data", "has arrays of different lengths");
#include "dynamics/fields.def"
}

std::vector<FieldInfo> body_fields() {
  return {
#define FIELD(type, name, unit, stage) {#name, unit, stage},
#include "dynamics/fields.def"
  };
}

std::vector<std::uint64_t> field_hashes(const Bodies& b) {
  std::vector<std::uint64_t> hashes;
#define FIELD(type, name, unit, stage)                                                    \
  {                                                                                       \
    Hasher h;                                                                             \
    for (std::uint32_t i = 0; i < b.size(); ++i) {                                        \
      if (b.slots.used(i)) h.add(b.name[i]);                               \
    }                                                                                     \
    hashes.push_back(h.value());                                                          \
  }
#include "dynamics/fields.def"
  return hashes;
}

}
