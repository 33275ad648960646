// A model as glTF 2.0 with KHR_physics_rigid_bodies and KHR_implicit_shapes, such that read_gltf() makes the same of
// it.
#pragma once

#include <sudar/io.h>

namespace sudar::inline SUDAR_PRECISION::io {

// `binary`: as GLB; else as JSON with its meshes inside. What has no place in glTF is added to `lost`.
Bytes write_gltf(const Model&, bool binary, std::vector<Finding>& lost);

}
