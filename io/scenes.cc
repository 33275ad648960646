#include <sudar/io.h>

#include <algorithm>

namespace sudar::inline SUDAR_PRECISION::io {

const ScenarioEntry* FileScenes::open(std::string_view name) {
  const std::filesystem::path path(name);
  if (!is_readable(path)) return nullptr;
  std::error_code error;
  const auto written = std::filesystem::last_write_time(path, error);
  const std::lock_guard lock(mutex_);
  const auto known =
      std::find_if(opened_.rbegin(), opened_.rend(), [&](const Opened& o) { return name == o.entry->name; });
  if (known != opened_.rend() && !error && known->written == written) return known->entry.get();
  const Reading reading = read(path, options_);
  for (const Finding& f : reading.findings) tell_(f);
  opened_.push_back({written, std::make_unique<ModelEntry>(std::string(name), reading.model())});
  return opened_.back().entry.get();
}

}
