// Chooses the reader, or the writer, by the file's name.
#include <algorithm>
#include <new>

#include "io/format.h"
#include "io/gltf/read.h"
#include "io/gltf/write.h"
#include "io/mesh/read.h"
#include "io/mjcf/mjcf.h"
#include "io/urdf.h"

namespace sudar::inline SUDAR_PRECISION::io {

namespace {

// A line for each ending.
constexpr Format formats[] = {
    {".gltf", "glTF", read_gltf}, {".glb", "glTF", read_gltf},  {".xml", "MJCF", read_mjcf},
    {".mjcf", "MJCF", read_mjcf}, {".urdf", "URDF", read_urdf}, {".xacro", "xacro", read_xacro},
    {".obj", "OBJ", read_mesh},   {".stl", "STL", read_mesh},   {".ply", "PLY", read_mesh},
};

std::string ending_of(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
  return ending;
}

const Format* format_of(const std::filesystem::path& path) {
  const std::string ending = ending_of(path);
  const auto it = std::ranges::find_if(formats, [&](const Format& f) { return ending == f.ending; });
  return it == std::end(formats) ? nullptr : &*it;
}

// Builds the model, so that one that cannot be built is refused. What may overlap in peace is made small beside the
// smallest body that falls: the usual centimetre would swallow a marble.
void try_out(Model& model) {
  World trial(model.config);
  Real& slop = model.config.impulse_2007.slop;
  for (const Body body : build(model, trial).bodies) {
    constexpr Real share = Real(0.02);
    if (trial[body].motion() == Motion::dynamic) slop = min(slop, share * trial[body].radius());
  }
}

}

Reading read(const std::filesystem::path& path, const ReadOptions& options) {
  Reading result;
  std::optional<Source> source;
  const auto refuse = [&](Origin at, std::string message) {
    if (source) result.findings = source->take_findings();
    result.findings.push_back({Severity::error, std::move(at), std::move(message)});
  };
  const Format* format = format_of(path);
  if (format == nullptr) {
    refuse({path.string()}, "the name does not end with one of " + list(readable_endings()));
    return result;
  }
  try {
    source.emplace(path, options);
    Model model = format->read(*source);
    if (!source->refused()) try_out(model);
    result.findings = source->take_findings();
    if (!source->refused()) result.made = std::move(model);
  } catch (const FileError& e) { refuse(e.at, e.message); } catch (const Error& e) {
    refuse({path.string()}, e.what());
  } catch (const std::bad_alloc&) { refuse({path.string()}, "does not fit into memory"); }
  return result;
}

const Model& Reading::model() const {
  if (made) return *made;
  for (const Finding& f : findings) {
    if (f.severity == Severity::error) throw FileError(f.at, f.message);
  }
  throw Error("file", "nothing was read");
}

bool is_readable(const std::filesystem::path& path) { return format_of(path) != nullptr; }

std::vector<std::string> readable_endings() {
  std::vector<std::string> endings;
  for (const Format& f : formats) endings.emplace_back(f.ending);
  return endings;
}

Bytes write(const Model& model, const std::filesystem::path& path, std::vector<Finding>& lost) {
  if (!is_writable(path)) throw Error(path.string(), "the name does not end with one of " + list(writable_endings()));
  return write_gltf(model, ending_of(path) == ".glb", lost);
}

bool is_writable(const std::filesystem::path& path) {
  const std::vector<std::string> endings = writable_endings();
  return std::ranges::find(endings, ending_of(path)) != endings.end();
}

std::vector<std::string> writable_endings() { return {".glb", ".gltf"}; }

std::string list(const std::vector<std::string>& endings) {
  std::string text;
  for (const std::string& e : endings) text += (text.empty() ? "" : ", ") + e;
  return text;
}

}
