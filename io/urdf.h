// URDF, the files of robots in ROS (http://wiki.ros.org/urdf/XML): links and joints. docs/files.md says what becomes of
// each.
#pragma once

#include "io/source.h"

namespace sudar::inline SUDAR_PRECISION::io {

Model read_urdf(Source&);
// Refuses, with what to do about it: xacro is a language of macros, which makes URDF.
Model read_xacro(Source&);

}
