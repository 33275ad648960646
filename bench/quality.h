// How well an engine did, measured on its bodies' poses alone and on the exact shapes: whatever the engine itself
// believes about its contacts.
#pragma once

#include "bench/scenes.h"

namespace sudar::bench {

struct SceneQuality {
  bool finite = true;                                // all poses; the rest is 0 where they are not
  std::int64_t overlaps = 0;                         // pairs of bodies
  double penetration_max = 0, penetration_mean = 0;  // m, over those pairs: the shortest way that parts them
  double joint_gap_max = 0, joint_gap_mean = 0;      // m, over joints: between the two anchors
  // Of the dynamic body that is farthest from where it began, m: along the ground and up or down. Only in scenes that
  // stand.
  std::optional<double> drift, sink;
};

// `poses`: of the bodies that have arrived, in order.
SceneQuality measure(const Scene&, std::span<const Pose> poses);

}
