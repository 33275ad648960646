// Opened from the command line, a scene without a camera of its own (chain, chain_ball) was sometimes not seen at all:
// its first moment was there before the first picture had been laid out, and a picture of no width was filled with the
// scene from a camera at NaN.
#include <gtest/gtest.h>

#include <cmath>

#include "view/camera.h"

namespace sudar::view {
namespace {

TEST(NoArea, TheCameraIsSomewhere) {
  World w;
  w.add({.shape = sphere(1), .at = {3, 4, 5}, .mass = 1});
  for (const double aspect : {0.0, 1e-9, 1.5}) {
    const Camera c = framing(make_scene(w), aspect);
    EXPECT_TRUE(std::isfinite(c.eye.x) && std::isfinite(c.eye.y) && std::isfinite(c.eye.z)) << aspect;
    EXPECT_TRUE(std::isfinite(c.target.x)) << aspect;
  }
}

}
}
