// The numbers that all shaders of one picture share: a copy of the block in shaders/frame.glsl.
#pragma once

#include "view/camera.h"

namespace sudar::view {

struct FrameBlock {  // std140: only whole matrices and vectors of four
  Mat4 view_projection, inverse_view_projection, sun_projection;
  Vec4f sun, scale, zoom;
};

// For a picture of `width` by `height` pixels with a square shadow map of `shadow_size` texels.
FrameBlock make_frame(const Scene&, const Focus&, const Camera&, double aspect, int shadow_size);

}
