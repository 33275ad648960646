// Meshes of bodies that move: they touch as their convex hull, and weigh as their surface where that is closed.
#pragma once

#include "io/fields.h"
#include "io/surface.h"

namespace sudar::inline SUDAR_PRECISION::io {

// Of the file of that name, seen from another. Throws Error where it cannot be read.
Surface read_surface(Source&, const std::string& name, const std::filesystem::path& from);

struct Solid {
  Shape shape{};  // none: there is no hull
  MassProperties unit{};
};
// With a remark where the hull is not what the surface is, or there is none.
Solid solid_of(const Surface&, const Origin&, Remarks&);

}
