// Chooses the reader by the file's name.
#include <algorithm>
#include <new>

#include "io/format.h"
#include "io/mjcf/mjcf.h"
#include "io/urdf.h"

namespace sudar::inline SUDAR_PRECISION::io {

namespace {

// A line for each ending.
constexpr std::array formats{
    Format{".xml", "MJCF", read_mjcf},
    Format{".mjcf", "MJCF", read_mjcf},
    Format{".urdf", "URDF", read_urdf},
    Format{".xacro", "xacro", read_xacro},
};

std::string ending_of(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
  return ending;
}

const Format* format_of(const std::filesystem::path& path) {
  const auto it =
      std::find_if(formats.begin(), formats.end(), [&](const Format& f) { return ending_of(path) == f.ending; });
  return it == formats.end() ? nullptr : &*it;
}

std::string list_of_endings() {
  std::string list;
  for (const Format& f : formats) list += (list.empty() ? "" : ", ") + std::string(f.ending);
  return list;
}

// A model can be built, or the file is refused.
void expect_buildable(const Model& model) {
  World trial(model.config);
  build(model, trial);
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
    refuse({path.string()}, "the name does not end with one of " + list_of_endings());
    return result;
  }
  try {
    source.emplace(path, options);
    Model model = format->read(*source);
    if (!source->refused()) expect_buildable(model);
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

}
