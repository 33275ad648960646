// What the tests that compare broad phases in a world share.
#pragma once

#include <sudar/world.h>

#include <vector>

namespace sudar::inline SUDAR_PRECISION {

inline std::vector<Broad> broad_kinds() {
  std::vector<Broad> kinds;
  for (const char* const* name = names(Broad{}); *name != nullptr; ++name) kinds.push_back(Broad(kinds.size()));
  return kinds;
}

inline const char* name_of(Broad kind) { return names(kind)[int(kind)]; }

// The hash of a world as if it had run with brute force: of its poses, pairs and all else but the setting itself.
inline std::uint64_t hash_without_broad(World& w) {
  Config config = w.config();
  config.broad = Broad::brute;
  w.set_config(config);
  return w.hash();
}

}
