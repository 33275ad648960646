#include "dynamics/bodies.h"

#include "base/hash.h"
#include "geometry/principal.h"

namespace sudar::inline SUDAR_PRECISION {

static_assert(sizeof(Material) == 5 * sizeof(Real) && sizeof(Filter) == 12 && sizeof(Transform) == 7 * sizeof(Real),
              "arrays of these are saved as they lie in memory, so they must not have padding");

namespace {
// How far the shape reaches from the centre of mass, which lies at −shape in the shape's frame up to a turn.
Real radius_about(const Geometry& g, const Vec3& shape) {
  if (shape == Vec3{}) return g.bounding_radius;
  return g.bounding_radius + length(shape);
}
}

double density_of(const BodyDef& def) {
  return def.mass > 0 ? double(def.mass) / def.shape.geometry().mass.volume : double(def.density);
}

MassProperties mass_properties(const BodyDef& def) {
  MassProperties m = def.shape.geometry().mass;
  if (def.center) m.center = convert<double>(*def.center);
  if (def.inertia) {
    const Mat3& tensor = *def.inertia;
    m.inertia = Mat3d{convert<double>(tensor.c0), convert<double>(tensor.c1), convert<double>(tensor.c2)} *
                (1 / density_of(def));
  }
  return m;
}

std::uint32_t Bodies::add(const BodyDef& def, std::uint32_t geometry_number) {
  const std::uint32_t i = slots.take();
#define FIELD(type, name, unit, stage) \
  if (i == name.size()) name.emplace_back(); else name[i] = type{};
#include "dynamics/fields.def"
  const Geometry& g = def.shape.geometry();
  geometry[i] = geometry_number;
  material[i] = def.material;
  surface_velocity[i] = def.surface_velocity;
  filter[i] = def.filter;
  motion[i] = def.motion;
  may_sleep[i] = def.sleeps ? 1 : 0;
  radius[i] = g.bounding_radius;
  if (has_mass(def.shape.kind())) {
    const PrincipalFrame principal = principal_frame(mass_properties(def));
    shape_frame[i] = principal.shape;
    radius[i] = radius_about(g, principal.shape.p);
    const double density = density_of(def);
    mass[i] = Real(density * g.mass.volume);
    if (def.motion == Motion::dynamic) {
      inverse_mass[i] = 1 / mass[i];
      for (int k = 0; k < 3; ++k) {
        inertia[i][k] = Real(density * principal.moments[k]);
        inverse_inertia[i][k] = 1 / inertia[i][k];
      }
    }
  }
  set_shape_pose(i, {def.at, normalize(def.turn)});
  set_velocity(i, def.motion == Motion::fixed ? Vec3{} : def.velocity, def.motion == Motion::fixed ? Vec3{} : def.spin);
  return i;
}

void Bodies::set_shape_pose(std::uint32_t i, const Pose& pose) {
  orientation[i] = normalize(pose.q * conjugate(shape_frame[i].q));
  position[i] = pose.p - rotate(orientation[i], shape_frame[i].p);
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

Vec3 Bodies::surface_velocity_world(std::uint32_t i) const {
  if (surface_velocity[i] == Vec3{}) return {};
  return rotate(orientation[i], rotate(shape_frame[i].q, surface_velocity[i]));
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
