// How well an engine did, measured on its bodies' poses alone and on the exact shapes: whatever the engine itself
// believes about its contacts.
#pragma once

#include "bench/scenes.h"

namespace sudar::bench {

struct SceneQuality {
  bool finite = true;         // all poses; the rest is 0 where they are not
  std::int64_t overlaps = 0;  // pairs of bodies
  // Over those pairs, m: the shortest way that parts them. p99: one pair in a hundred is deeper.
  double penetration_max = 0, penetration_mean = 0, penetration_p99 = 0;
  std::int64_t below_ground = 0;  // bodies that went through the floor: those that collide, and are wholly below y = 0
  double joint_gap_max = 0, joint_gap_mean = 0;  // m, over joints: between the two anchors
  // Of the dynamic body that is farthest from where it began, m: along the ground and up or down. Only in scenes that
  // stand.
  std::optional<double> drift, sink;
};

// `poses`: of the bodies that have arrived, in order.
SceneQuality measure(const Scene&, std::span<const Pose> poses);

}
