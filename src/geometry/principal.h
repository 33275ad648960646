// A body's frame: origin at the centre of mass, axes along the principal axes of inertia, so that its inertia is
// diagonal.
#pragma once

#include <sudar/shape.h>

namespace sudar::inline SUDAR_PRECISION {

struct PrincipalFrame {
  Vec3d moments;    // of inertia about the body's axes, per unit density as in MassProperties
  Transform shape;  // the shape's frame in the body's
};

// The body's axes are those of the shape if the inertia is diagonal but for rounding, else turned as little as may be.
PrincipalFrame principal_frame(const MassProperties&);

}
