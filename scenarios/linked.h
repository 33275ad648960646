// The scenarios of a build with SUDAR_STATIC_SCENARIOS, where they are linked in and not loaded.
#pragma once

#include <sudar/scenario.h>

#include <vector>

namespace sudar::inline SUDAR_PRECISION {

std::vector<const ScenarioEntry*> linked_scenarios();

}
