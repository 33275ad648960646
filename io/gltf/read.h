// glTF 2.0 with KHR_physics_rigid_bodies and KHR_implicit_shapes (eoineoineoin/glTF_Physics ac5c413); docs/files.md
// says what is read.
#pragma once

#include "io/source.h"

namespace sudar::inline SUDAR_PRECISION::io {

Model read_gltf(Source&);

}
