// What a step cost.
#pragma once

#include <sudar/base.h>

#include <vector>

namespace sudar::inline SUDAR_PRECISION {

struct Profile {
  struct Stage {
    const char* name;
    double microseconds;
  };
  struct Passes {
    std::int64_t used = 0;    // passes, summed over islands and the step's sub-steps
    std::int64_t visits = 0;  // of a contact point or a joint in a pass
    double microseconds = 0;  // of the visits, summed over workers
    void operator+=(const Passes& p) { used += p.used, visits += p.visits, microseconds += p.microseconds; }
  };
  std::vector<Stage> stages;
  std::int64_t contacts = 0, points = 0;  // touching pairs and their points in the last sub-step
  std::int64_t awake = 0;                 // dynamic bodies awake
  Passes collision;                       // of points; the time includes the search for contacts that approach
  Passes contact;                         // of points
  Passes correction;                      // of points: overlap and gaps, split impulse
  Passes joint;                           // of joints, in all kinds of passes
};

}
