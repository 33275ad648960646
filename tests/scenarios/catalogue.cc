#include "scenarios/catalogue.h"

#ifdef SUDAR_STATIC_SCENARIOS
#include "scenarios/linked.h"
#else
#include <dlfcn.h>

#include <filesystem>
#endif

#include <sstream>

namespace sudar::inline SUDAR_PRECISION {

namespace {

std::vector<const ScenarioEntry*> entries() {
#ifdef SUDAR_STATIC_SCENARIOS
  return linked_scenarios();
#else
  std::vector<const ScenarioEntry*> all;
  for (const auto& file : std::filesystem::directory_iterator(SUDAR_SCENARIO_FOLDER)) {
    void* library = dlopen(file.path().c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!library) throw Error("scenario", dlerror());
    all.push_back(reinterpret_cast<const ScenarioEntry* (*)()>(dlsym(library, "sudar_scenario"))());
  }
  return all;
#endif
}

}

const Catalogue& scenarios() {
  static const Catalogue all = [] {
    Catalogue c;
    for (const ScenarioEntry* entry : entries()) c.add(entry);
    return c;
  }();
  return all;
}

std::string text(const Check::Entry& e) {
  std::ostringstream out;
  out << e.name << ": " << e.value << " " << e.op << " " << e.limit;
  if (e.tolerance > 0) out << " ± " << e.tolerance;
  out << " " << e.unit << " at " << e.at << " s";
  return out.str();
}

}
