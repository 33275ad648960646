// What no description of single fields can say: whether a definition is of a body or joint that can be, in this
// precision. Throws Error naming the field. The fields themselves are good already (validate.h), and handles alive.
#pragma once

#include "dynamics/forces.h"
#include "dynamics/joints.h"

namespace sudar::inline SUDAR_PRECISION {

// What the world does to every body, for the products that must be finite.
struct Surroundings {
  double gravity = 0;           // m/s²
  double step = 0, sub_step = 0;  // simulated s
};
Surroundings surroundings(const Forces&, const Config&, double dt);

// `shapes`: those of the definition, complete (bodies.h).
void check_body(const BodyDef&, std::span<const ShapeDef> shapes, const Surroundings&);
// Body i with the mass that it would have with a shape more or less.
void check_shape(const Bodies&, std::uint32_t i, const MassSum&, const Surroundings&);
// A motion that body i can have, with what pushes it already.
void check_velocity(const Bodies&, std::uint32_t i, const Vec3& velocity, const Vec3& spin, const Surroundings&);
// A force [N] or torque [N m] on body i, besides what pushes it already. `field` names the one or the other.
void check_force(const char* field, const Bodies&, std::uint32_t i, const Vec3& force, const Surroundings&);
void check_torque(const char* field, const Bodies&, std::uint32_t i, const Vec3& torque, const Surroundings&);
// Surroundings that every body can stand. `field` names what is to be changed about them.
void check_surroundings(const char* field, const Bodies&, const Surroundings&);
// A step of time that the precision can tell.
void check_step(const char* field, const Surroundings&);
void check_config(const Config&);
const char* name_of_step(const Config&);  // which of its fields makes the step as long, or as short, as it is
void check_joint(const JointDef&, const Bodies&);

// "bar", "rope", …
const char* kind_of(const JointDef&);

}
