#include "io/mjcf/meshes.h"

#include <algorithm>

namespace sudar::inline SUDAR_PRECISION::io {

MjcfMeshes::MjcfMeshes(Source& source, Remarks& remarks, const MjcfFile& file, const MjcfSettings& settings)
    : source_(source), remarks_(remarks), file_(file), settings_(settings) {
  file.each_in("asset", [&](const XmlElement& e) {
    if (e.name != "mesh") return;
    const XmlAttribute *name = e.find("name"), *from = e.find("file");
    if (name == nullptr && from == nullptr) throw FileError(e.at, "a mesh needs a name or a file");
    const std::string called = name != nullptr ? name->value : std::filesystem::path(from->value).stem().string();
    if (!meshes_.emplace(called, Entry{&e}).second) throw FileError(e.at, "there are two meshes of that name");
  });
}

const Solid& MjcfMeshes::find(const Origin& at, const std::string& name) {
  const auto it = meshes_.find(name);
  if (it == meshes_.end()) throw FileError(at, "there is no mesh " + in_quotes(name));
  if (!it->second.made) it->second.made = make(*it->second.element);
  return *it->second.made;
}

Solid MjcfMeshes::make(const XmlElement& e) {
  Fields f = file_.fields(e);
  f.pass({"name", "content_type", "smoothnormal", "normal", "texcoord", "maxhullvert", "inertia", "material",
          "octree_maxdepth"});
  f.leave_out("builtin", "is not supported");
  const Vec3d factors = f.vector("scale", {1, 1, 1});
  const auto turn = f.numbers("refquat", 4, 4);
  Frame reference{f.vector("refpos"), {}};
  if (!turn.empty()) reference.q = normalize(Quatd{turn[1], turn[2], turn[3], turn[0]});
  Surface surface;
  const std::string file = f.text("file");
  const auto numbers = f.numbers("vertex", 12, Fields::unbounded);
  try {
    if (!file.empty())
      surface = read_surface(source_, (std::filesystem::path(settings_.mesh_folder) / file).string(), file_.path());
  } catch (const Error& error) {
    remarks_.warn(f.at("file"), std::string("the mesh is left out: ") + error.what());
    return {};
  }
  if (numbers.size() % 3 != 0) f.fail("vertex", "must have three numbers for each vertex");
  source_.count_vertices(numbers.size() / 3);
  for (std::size_t i = 0; i < numbers.size(); i += 3)
    surface.vertices.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
  for (const double corner : f.numbers("face", 0, Fields::unbounded)) {
    if (!(corner >= 0 && corner < double(surface.vertices.size()))) f.fail("face", "names a vertex that is not there");
    surface.triangles.push_back(std::uint32_t(corner));
  }
  f.finish();
  for (Vec3d& v : surface.vertices) v = reference.local(scale(v, factors));
  if (factors.x * factors.y * factors.z < 0) {  // a mirror turns the surface inside out
    for (std::size_t i = 0; i + 2 < surface.triangles.size(); i += 3)
      std::swap(surface.triangles[i], surface.triangles[i + 1]);
  }
  return solid_of(surface, e.at, remarks_);
}

}
