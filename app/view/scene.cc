#include "view/scene.h"

#include <algorithm>

namespace sudar::inline SUDAR_PRECISION {

void add_instance(Scene& scene, const Shape& shape, Instance instance) {
  // Bodies of one shape mostly follow each other: look from the end. The pointer first, since it is cheap.
  const auto same = std::find_if(scene.shapes.rbegin(), scene.shapes.rend(),
                                 [&](const Shape& s) { return s.shared() == shape.shared() || s == shape; });
  if (same == scene.shapes.rend()) {
    instance.shape = std::uint32_t(scene.shapes.size());
    scene.shapes.push_back(shape);
  } else {
    instance.shape = std::uint32_t(scene.shapes.rend() - same - 1);
  }
  scene.instances.push_back(instance);
}

}
