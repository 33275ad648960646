#include "view/camera.h"

#include <algorithm>
#include <limits>

namespace sudar::view {

namespace {

struct Round {
  Vec3f centre;  // relative to some origin
  float radius;
};

std::vector<Round> corners_of_box(const Shape& shape, const Pose& pose, const Pos& origin) {
  const Real r = shape.radius(), half = shape.half_length();
  const bool round = shape.kind() == ShapeKind::hollow_sphere, cone = shape.kind() == ShapeKind::cone;
  const Vec3 reach = shape.kind() == ShapeKind::ellipsoid ? shape.radii() : Vec3{r, round ? r : half, r};
  const Vec3 middle{0, cone ? half / 2 : 0, 0};
  std::vector<Round> corners;
  for (int i = 0; i < 8; ++i) {
    const Vec3 signs{i & 1 ? Real(1) : Real(-1), i & 2 ? Real(1) : Real(-1), i & 4 ? Real(1) : Real(-1)};
    corners.push_back({relative(pose.point(middle + scale(reach, signs)), origin), 0});
  }
  return corners;
}

// Balls that together cover an instance closely: its corners, or its round ends.
std::vector<Round> cover(const Shape& shape, const Pose& pose, const Pos& origin) {
  const auto at = [&](const Vec3& local) { return relative(pose.point(local), origin); };
  switch (shape.kind()) {
    case ShapeKind::sphere:
      return {{at({}), float(shape.radius())}};
    case ShapeKind::capsule:
      return {{at({0, shape.half_length(), 0}), float(shape.radius())},
              {at({0, -shape.half_length(), 0}), float(shape.radius())}};
    case ShapeKind::half_space:
      return {};
    case ShapeKind::hull:
    case ShapeKind::mesh:
      break;
    default:  // the corners of a box around it
      return corners_of_box(shape, pose, origin);
  }
  std::vector<Round> corners;
  for (const Vec3& v : shape.vertices()) corners.push_back({at(v), 0});
  return corners;
}

struct Bounds {
  Vec3f low{1e30f, 1e30f, 1e30f}, high{-1e30f, -1e30f, -1e30f};
  bool empty() const { return low.x > high.x; }
  void add(const Round& b) {
    const Vec3f r{b.radius, b.radius, b.radius};
    low = min(low, b.centre - r);
    high = max(high, b.centre + r);
  }
  Vec3f centre() const { return (low + high) * 0.5f; }
  float radius() const { return length(high - low) * 0.5f; }
};

float median(std::vector<float> values) {
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Pos median_position(const std::vector<const Instance*>& instances) {
  Vec3f m;
  const Pos& origin = instances[0]->pose.p;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<float> values;
    for (const Instance* i : instances) values.push_back(relative(i->pose.p, origin)[axis]);
    m[axis] = median(values);
  }
  return origin + m;
}

// The instances that a picture is about.
std::vector<const Instance*> subjects(const Scene& scene) {
  std::vector<const Instance*> moving, fixed;
  for (const Instance& i : scene.instances) {
    if (scene.shapes[i.shape].kind() == ShapeKind::half_space) continue;
    (i.fixed ? fixed : moving).push_back(&i);
  }
  if (moving.empty()) return fixed;
  const Pos middle = median_position(moving);
  std::vector<float> distances;
  for (const Instance* i : moving) distances.push_back(length(relative(i->pose.p, middle)));
  const float usual = median(distances);
  float size = 0;
  for (const Instance* i : moving) size = max(size, float(scene.shapes[i->shape].bounding_radius()));
  const float limit = 5 * max(usual, size);
  std::erase_if(moving, [&](const Instance* i) { return length(relative(i->pose.p, middle)) > limit; });
  Bounds bounds;
  for (const Instance* i : moving) {
    for (const Round& b : cover(scene.shapes[i->shape], i->pose, middle)) bounds.add(b);
  }
  for (const Instance* i : fixed) {
    const float radius = float(scene.shapes[i->shape].bounding_radius());
    const float distance = length(relative(i->pose.p, middle) - bounds.centre());
    if (radius < 1.5f * bounds.radius() && distance < 2.5f * bounds.radius()) moving.push_back(i);
  }
  return moving;
}

}

Focus focus_of(const Scene& scene) {
  const std::vector<const Instance*> about = subjects(scene);
  if (about.empty()) return {};
  const Pos origin = about[0]->pose.p;
  Bounds bounds;
  for (const Instance* i : about) {
    for (const Round& b : cover(scene.shapes[i->shape], i->pose, origin)) bounds.add(b);
  }
  return {origin + bounds.centre(), double(bounds.radius())};
}

Camera framing(const Scene& scene, double aspect) {
  const Focus focus = focus_of(scene);
  Camera camera;
  std::vector<Round> balls;
  Bounds bounds;
  for (const Instance* i : subjects(scene)) {
    for (const Round& b : cover(scene.shapes[i->shape], i->pose, focus.centre)) balls.push_back(b), bounds.add(b);
  }
  if (balls.empty()) balls.push_back({{}, float(focus.radius)}), bounds.add(balls.back());

  const Vec3f size = bounds.high - bounds.low;
  const float azimuth = size.x >= 0.8f * size.z ? 0.5f : 1.07f, elevation = 0.3f;  // rad
  const Vec3f towards{sudar::sin(azimuth) * sudar::cos(elevation), sudar::sin(elevation),
                      sudar::cos(azimuth) * sudar::cos(elevation)};
  const Frame3 axes = looking_along(-towards);
  const float margin = 1.1f, half = float(camera.field_of_view) / 2;
  constexpr float narrowest = 0.05f;  // a window may have no width
  const float slope_y = sudar::tan(half) / margin, slope_x = slope_y * max(float(aspect), narrowest);

  // The distance at which each ball just stays inside each of the four sides; then the target moves sideways until
  // opposite sides need the same. Twice, since one depends a little on the other.
  Vec3f target;
  float distance = 0;
  for (int pass = 0; pass < 2; ++pass) {
    float needs[4] = {0, 0, 0, 0};
    for (const Round& b : balls) {
      const Vec3f d = b.centre - target;
      const float depth = dot(d, axes.back), x = dot(d, axes.right), y = dot(d, axes.up);
      const float rx = b.radius * sudar::sqrt(1 + slope_x * slope_x),
                  ry = b.radius * sudar::sqrt(1 + slope_y * slope_y);
      needs[0] = max(needs[0], (rx + x) / slope_x + depth), needs[1] = max(needs[1], (rx - x) / slope_x + depth);
      needs[2] = max(needs[2], (ry + y) / slope_y + depth), needs[3] = max(needs[3], (ry - y) / slope_y + depth);
    }
    target += axes.right * ((needs[0] - needs[1]) * slope_x / 2) + axes.up * ((needs[2] - needs[3]) * slope_y / 2);
    distance = max(max(needs[0] + needs[1], needs[2] + needs[3]) / 2, float(focus.radius) * 0.5f);
  }
  camera.target = focus.centre + target;
  camera.eye = camera.target + towards * distance;
  return camera;
}

}
