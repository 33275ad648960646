// KHR_physics_rigid_bodies: joints, which are limits of single axes and drives, become the joints that have them.
#pragma once

#include "io/gltf/bodies.h"

namespace sudar::inline SUDAR_PRECISION::io::gltf {

// Adds the scene's joints to a model that has its bodies. Throws FileError.
void read_joints(Document&, const SceneTree&, const Bodies&, Model&);

}
