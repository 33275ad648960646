// Files that hold one mesh: Wavefront OBJ, STL, PLY.
#pragma once

#include "io/rigid.h"
#include "io/source.h"
#include "io/surface.h"

namespace sudar::inline SUDAR_PRECISION::io {

// The file's triangles in its own unit. For readers whose files name such a one: `bytes` are its. Throws FileError.
Surface read_obj(Source&, const std::string& file, std::span<const std::byte> bytes);
Surface read_stl(Source&, const std::string& file, std::span<const std::byte> bytes);
Surface read_ply(Source&, const std::string& file, std::span<const std::byte> bytes);
// By the file's ending; throws FileError where that is none of these.
Surface read_surface(Source&, const std::string& file, std::span<const std::byte> bytes);

// Such a file as a model: a closed mesh falls, an open one stands in the way.
Model read_mesh(Source&);

}
