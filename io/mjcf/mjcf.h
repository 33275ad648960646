// MJCF, the files of MuJoCo (https://mujoco.readthedocs.io/en/stable/XMLreference.html): bodies, geoms, joints,
// defaults, includes, actuators, tendons, equalities, contact filters. docs/files.md says what becomes of each.
#pragma once

#include "io/source.h"

namespace sudar::inline SUDAR_PRECISION::io {

Model read_mjcf(Source&);

}
