#include "io/solid.h"

namespace sudar::inline SUDAR_PRECISION::io {

Soup read_surface(Source& source, const std::string& name, const std::filesystem::path& from) {
  source.find(name, from);
  throw Error("", "files of meshes are not read");
}

Solid solid_of(const Soup& surface, const Origin& at, Remarks& remarks) {
  std::vector<Vec3> points;
  for (const Vec3d& v : surface.vertices) points.push_back(convert<Real>(v));
  Solid solid;
  try {
    solid.shape = hull(points);
  } catch (const Error& e) {
    remarks.warn(at, std::string("the mesh has no convex hull, and is left out: ") + e.what());
    return {};
  }
  solid.unit = solid.shape.mass_properties();
  if (surface.triangles.empty()) return solid;
  try {
    const MassProperties own = mass_properties(surface.vertices, surface.triangles);
    if (!(own.volume > 0)) throw Error("triangles", "is inside out");
    if (own.volume < 0.99 * solid.unit.volume)
      remarks.note(at, "the mesh is not convex: it touches as its convex hull");
    solid.unit = own;
  } catch (const Error& e) { remarks.note(at, std::string("the mesh weighs as its convex hull: ") + e.what()); }
  return solid;
}

}
