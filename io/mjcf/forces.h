// What acts between the bodies of an MJCF file: actuators, tendons and equalities. What acts along one joint becomes
// its spring, before there are joints; the rest becomes joints between bodies, after.
#pragma once

#include "io/mjcf/bodies.h"

namespace sudar::inline SUDAR_PRECISION::io {

// Actuators, with control 0, fixed tendons and equalities of joints, into the degrees of freedom.
void add_joint_forces(MjcfBodies&, Remarks&, const MjcfFile&, const MjcfSettings&);
// Spatial tendons, connections and welds.
void add_ties(Assembly&, const MjcfNames&, Remarks&, const MjcfFile&, const MjcfSettings&);

}
