#include "view/frame.h"

#include <cmath>

namespace sudar::view {

namespace {

const Vec3f towards_sun = normalize(Vec3f{-0.52f, 0.78f, 0.42f});

// What casts shadows, as a box in the sun's axes, relative to the eye.
struct LightBox {
  Vec3f low, high;
};

LightBox casters(const Scene& scene, const Focus& focus, const Pos& eye, const Frame3& axes) {
  const auto in_light = [&](const Pos& p) {
    const Vec3f v = relative(p, eye);
    return Vec3f{dot(v, axes.right), dot(v, axes.up), dot(v, axes.back)};
  };
  // Large fixed things count only near the focus, or the shadow map would be too coarse for the rest.
  const float reach = 8 * float(focus.radius);
  const Vec3f centre = in_light(focus.centre), limit{reach, reach, reach};
  LightBox box{centre, centre};
  for (const Instance& i : scene.instances) {
    const Shape& shape = scene.shapes[i.shape];
    if (shape.kind() == ShapeKind::half_space) continue;
    const float radius = float(shape.bounding_radius());
    const Vec3f at = in_light(i.pose.p), r{radius, radius, radius};
    box.low = min(box.low, max(at - r, centre - limit));
    box.high = max(box.high, min(at + r, centre + limit));
  }
  return box;
}

// Eye-relative positions → the shadow map. Its edge and place change in steps only, so that shadows do not crawl while
// bodies move.
Mat4 sun_projection(LightBox box, const Pos& eye, const Frame3& axes, int texels, float& texel) {
  float edge = max(box.high.x - box.low.x, box.high.y - box.low.y) * 1.02f;
  edge = std::exp2(std::ceil(std::log2(edge) * 4) / 4);
  texel = edge / float(texels);
  const auto snapped = [&](float middle, const Vec3f& axis) {
    const double own = double(axis.x) * eye.x + double(axis.y) * eye.y + double(axis.z) * eye.z;
    return float(std::round((double(middle) + own) / double(texel)) * double(texel) - own);
  };
  const float x = snapped((box.low.x + box.high.x) / 2, axes.right), y = snapped((box.low.y + box.high.y) / 2, axes.up);
  const float depth = 4 * edge + box.high.z - box.low.z;  // floors far below still receive shadows
  const Vec3f low{x - edge / 2, y - edge / 2, box.high.z - depth},
      high{x + edge / 2, y + edge / 2, box.high.z + 0.01f * edge};
  return orthographic(low, high) * into_frame(axes);
}

}

FrameBlock make_frame(const Scene& scene, const Focus& focus, const Camera& camera, double aspect, int shadow_size) {
  const Vec3f to_target = relative(camera.target, camera.eye);
  const float distance = max(length(to_target), 1e-3f);
  const float near = 0.02f * distance, far = 120 * distance;
  const float slope_y = sudar::tan(float(camera.field_of_view) / 2), slope_x = slope_y * float(aspect);
  const Frame3 look = looking_along(to_target), light = looking_along(-towards_sun);
  FrameBlock f;
  f.view_projection = perspective(slope_x, slope_y, near, far) * into_frame(look);
  // The inverse, written down: clip → view axes → world axes.
  Mat4 unproject, turn;
  unproject.at(0, 0) = slope_x, unproject.at(1, 1) = slope_y;
  unproject.at(2, 2) = 0, unproject.at(2, 3) = -1;
  unproject.at(3, 2) = (near - far) / (2 * far * near), unproject.at(3, 3) = (far + near) / (2 * far * near);
  for (int i = 0; i < 3; ++i) turn.at(i, 0) = look.right[i], turn.at(i, 1) = look.up[i], turn.at(i, 2) = look.back[i];
  f.inverse_view_projection = turn * unproject;
  float texel = 0;
  f.sun_projection = sun_projection(casters(scene, focus, camera.eye, light), camera.eye, light, shadow_size, texel);
  f.sun = with_w(towards_sun, texel);
  f.scale = {near, far, 7 * distance, 0.16f * float(focus.radius)};
  f.zoom = {1 / slope_x, 1 / slope_y, 1 / float(shadow_size), 0};
  return f;
}

}
