// Where to look from, and what a picture is about.
#pragma once

#include <sudar/scenario.h>

#include "view/scene.h"

namespace sudar::view {

// A ball round what matters in a scene: the moving bodies without the odd one that flew far away, and the fixed ones
// that are about as large and near. A scene without bodies has a ball of 5 m.
struct Focus {
  Pos centre;
  double radius = 5;
};
Focus focus_of(const Scene&);

// A camera that shows the focus of the scene, a little from above, its longer side across the picture.
// `aspect`: the picture's width / height.
Camera framing(const Scene&, double aspect);

// Is this the camera of a scenario that leaves the choice to the viewer?
inline bool unset(const Camera& c) { return c.eye == c.target; }

}
