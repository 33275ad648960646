// What no description of single fields can say: whether a definition is of a body or joint that can be, in this
// precision. Throws Error naming the field. The fields themselves are good already (validate.h), and handles alive.
#pragma once

#include "dynamics/joints.h"

namespace sudar::inline SUDAR_PRECISION {

void check_body(const BodyDef&);
// A spin whose angular momentum about any axis is finite; `inertia`: principal moments.
void check_spin(const Vec3& spin, const Vec3& inertia);
void check_joint(const JointDef&, const Bodies&);

// "bar", "rope", …
const char* kind_of(const JointDef&);

}
