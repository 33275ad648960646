#include "io/solid.h"

#include "io/mesh/read.h"

namespace sudar::inline SUDAR_PRECISION::io {

Surface read_surface(Source& source, const std::string& name, const std::filesystem::path& from) {
  const std::filesystem::path path = source.find(name, from);
  const Bytes bytes = source.read(path);
  return read_surface(source, path.string(), bytes);
}

Solid solid_of(const Surface& surface, const Origin& at, Remarks& remarks) {
  const Cleaned clean = cleaned(surface);
  Solid solid;
  try {
    solid.shape = hull_of(clean.surface);
  } catch (const Error& e) {
    remarks.warn(at, std::string("the mesh has no convex hull, and is left out: ") + e.what());
    return {};
  }
  solid.unit = solid.shape.mass_properties();
  if (surface.triangles.empty()) return solid;
  if (!clean.solid) {
    remarks.note(at, "the mesh is open, and weighs as its convex hull");
    return solid;
  }
  const std::string excess = excess_of_hull(solid.shape, *clean.solid);
  if (!excess.empty()) remarks.note(at, "the mesh is not convex: it touches as its convex hull, which " + excess);
  solid.unit = *clean.solid;
  return solid;
}

}
