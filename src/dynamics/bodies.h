// The bodies' state: plain arrays by slot, generated from fields.def, and their shapes'. No behaviour beyond what one
// body alone can answer.
#pragma once

#include "dynamics/shapes.h"

namespace sudar::inline SUDAR_PRECISION {

// Whether a body that moves so may have such a shape: what has no mass does not fall.
constexpr bool may_have(Motion motion, ShapeKind kind) {
  return has_mass(kind) || motion == Motion::fixed || (motion == Motion::kinematic && kind == ShapeKind::mesh);
}
// The definitions of all its shapes, nothing left out.
std::vector<ShapeDef> shapes_of(const BodyDef& def);
// What its shapes weigh, with what the definition overrides, in the body's given frame; none: no shape has mass.
std::optional<MassSum> mass_of(const BodyDef& def, std::span<const ShapeDef> shapes);

struct Bodies {
#define FIELD(type, name, unit, stage) std::vector<type> name;
#include "dynamics/fields.def"
  Slots slots;
  Shapes shapes;

  // Makes a body of the validated definition, with the shapes of shapes_of() and their numbers in the world's store.
  std::uint32_t add(const BodyDef& def, std::span<const ShapeDef> shapes, std::span<const std::uint32_t> geometries);
  void remove(std::uint32_t i);
  std::uint32_t size() const { return slots.size(); }

  // Puts a shape at the end of a body's list, or takes it out. Its mass is to be renewed then.
  std::uint32_t add_shape(std::uint32_t i, const ShapeDef& complete, std::uint32_t geometry);
  void remove_shape(std::uint32_t s);
  // Gives the body another mass, or none, and its shapes their places in its new body frame. The given frame stays where it
  // is, and each of its points keeps its velocity. `geometries` in the order of its shapes. Returns old body frame → new.
  Transform renew_mass(std::uint32_t i, const std::optional<MassSum>&, std::span<const Geometry* const> geometries);
  template <class Visit>
  void each_shape(std::uint32_t i, Visit visit) const {
    shapes.each(first_shape[i], visit);
  }
  // What is left out is as in the body's first shape.
  ShapeDef complete(std::uint32_t i, const ShapeDef&) const;

  bool dynamic(std::uint32_t i) const { return inverse_mass[i] > 0 && quarantined[i] == 0; }
  bool awake(std::uint32_t i) const { return dynamic(i) && asleep[i] == 0; }
  bool moves(std::uint32_t i) const {  // its pose may change in the coming step
    return awake(i) || (motion[i] == Motion::kinematic && (velocity[i] != Vec3{} || spin[i] != Vec3{}));
  }

  Pose center_pose(std::uint32_t i) const { return {position[i], orientation[i]}; }
  Pose given_pose(std::uint32_t i) const { return placed(i, frame[i]); }
  void set_given_pose(std::uint32_t i, const Pose& pose);
  void set_velocity(std::uint32_t i, const Vec3& v, const Vec3& w);

  // Of shape s.
  Transform shape_frame(std::uint32_t s) const { return frame[shapes.body[s]] * shapes.pose[s]; }  // shape → body
  Pose shape_pose(std::uint32_t s) const { return placed(shapes.body[s], shape_frame(s)); }
  Vec3 surface_velocity_world(std::uint32_t s) const;

  Mat3 inertia_world(std::uint32_t i) const;          // kg m²
  Mat3 inverse_inertia_world(std::uint32_t i) const;  // zero for what is not dynamic

  friend void write(Writer&, const Bodies&);
  friend void read(Reader&, Bodies&);

 private:
  void set_mass(std::uint32_t i, const std::optional<MassSum>&, std::span<const Geometry* const> geometries);
  Pose placed(std::uint32_t i, const Transform& local) const {
    return {position[i] + rotate(orientation[i], local.p), orientation[i] * local.q};
  }
};

// The name, unit, writer and content hash of every array, for docs/state.md and for finding what differs.
struct FieldInfo {
  const char *name, *unit, *stage;
};
std::vector<FieldInfo> body_fields();
// One hash a field over the bodies in use.
std::vector<std::uint64_t> field_hashes(const Bodies&);

}
