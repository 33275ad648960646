// What the tests that run scenarios share: the scenarios of this build, and a run to the end.
#pragma once

#include <sudar/session.h>

namespace sudar::inline SUDAR_PRECISION {

// All scenarios, loaded once.
const Catalogue& scenarios();

// A scenario with other parameters than its own: what thesis.md and docs/scenes state about those.
struct Variant {
  const char *scenario, *what;
  Settings settings;
};
const std::vector<Variant>& variants();

// Steps until the session has its seconds, and gives its verdict.
inline const Check& run(Session& session) {
  while (!session.done()) session.step();
  return session.finish();
}

// "drift: 0.2 < 0.1 m at 10 s", for messages.
std::string text(const Check::Entry&);

}
