#include "main/plugins.h"

#include <dlfcn.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#ifdef SUDAR_STATIC_SCENARIOS
#include "scenarios/linked.h"
#endif

namespace sudar::app {

void Plugins::Close::operator()(void* library) const { dlclose(library); }

#ifdef SUDAR_STATIC_SCENARIOS

Plugins::Plugins(const std::string& folder) {
  if (!folder.empty()) throw Error("--scenarios", "this program has its scenarios linked in and loads no others");
  for (const ScenarioEntry* entry : linked_scenarios()) catalogue_.add(entry);
}

#else

namespace {

namespace fs = std::filesystem;

fs::path usual_folder() {
  if (const char* set = std::getenv("SUDAR_SCENARIOS"); set && *set) return set;
  return fs::read_symlink("/proc/self/exe").parent_path().parent_path() / "lib" / "scenarios";
}

// Sorted, so that of two plugins of one name always the same is refused.
std::vector<fs::path> libraries_in(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().extension() == ".so") found.push_back(entry.path());
  }
  if (error) throw Error(folder.string(), "the folder of the scenarios cannot be read (" + error.message() + ")");
  std::sort(found.begin(), found.end());
  return found;
}

}

Plugins::Plugins(const std::string& folder) {
  using EntryPoint = const ScenarioEntry* (*)();
  for (const fs::path& path : libraries_in(folder.empty() ? usual_folder() : fs::path(folder))) {
    const auto refuse = [&](const std::string& reason) {
      refused_.push_back("scenario plugin " + path.filename().string() + " refused: " + reason);
    };
    std::unique_ptr<void, Close> library(dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL));
    if (!library) {
      refuse(dlerror());
      continue;
    }
    const auto entry_point = reinterpret_cast<EntryPoint>(dlsym(library.get(), "sudar_scenario"));
    if (!entry_point) {
      refuse("it has no function sudar_scenario; does its file end with SUDAR_SCENARIO(…)?");
      continue;
    }
    try {
      catalogue_.add(entry_point());
      libraries_.push_back(std::move(library));
    } catch (const Error& e) { refuse(e.what()); }
  }
}

#endif

}
