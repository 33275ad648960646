// The bodies' state: plain arrays by slot, generated from fields.def. No behaviour beyond what one body alone can answer.
#pragma once

#include <sudar/definitions.h>

#include "base/slots.h"
#include "geometry/archive.h"

namespace sudar::inline SUDAR_PRECISION {

// The density that the definition leads to [kg/m³], and its mass properties per unit density with what it overrides.
// Not for a half space, which has none.
double density_of(const BodyDef& def);
MassProperties mass_properties(const BodyDef& def);

struct Bodies {
#define FIELD(type, name, unit, stage) std::vector<type> name;
#include "dynamics/fields.def"
  Slots slots;

  // Makes a body of the validated definition. `geometry` is its shape's number in the world's store.
  std::uint32_t add(const BodyDef& def, std::uint32_t geometry);
  void remove(std::uint32_t i) { slots.give_back(i); }
  std::uint32_t size() const { return slots.size(); }

  bool dynamic(std::uint32_t i) const { return inverse_mass[i] > 0 && quarantined[i] == 0; }
  bool awake(std::uint32_t i) const { return dynamic(i) && asleep[i] == 0; }
  bool moves(std::uint32_t i) const {  // its pose may change in the coming step
    return awake(i) || (motion[i] == Motion::kinematic && (velocity[i] != Vec3{} || spin[i] != Vec3{}));
  }

  Pose center_pose(std::uint32_t i) const { return {position[i], orientation[i]}; }
  Pose shape_pose(std::uint32_t i) const {
    return {position[i] + rotate(orientation[i], shape_frame[i].p), orientation[i] * shape_frame[i].q};
  }
  void set_shape_pose(std::uint32_t i, const Pose& pose);
  void set_velocity(std::uint32_t i, const Vec3& v, const Vec3& w);

  Vec3 surface_velocity_world(std::uint32_t i) const;
  Mat3 inertia_world(std::uint32_t i) const;          // kg m²
  Mat3 inverse_inertia_world(std::uint32_t i) const;  // zero for what is not dynamic

  friend void write(Writer&, const Bodies&);
  friend void read(Reader&, Bodies&);
};

// The name, unit, writer and content hash of every array, for docs/state.md and for finding what differs.
struct FieldInfo {
  const char *name, *unit, *stage;
};
std::vector<FieldInfo> body_fields();
// One hash a field over the bodies in use.
std::vector<std::uint64_t> field_hashes(const Bodies&);

}
