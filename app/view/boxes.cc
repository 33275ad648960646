#include "view/boxes.h"

#include <cmath>

#include "view/palette.h"

namespace sudar::view {

void Boxes::place(const Scene& scene, const Pos& eye, const Style& style) {
  std::vector<std::vector<GpuInstance>> copies(1);
  const auto add = [&](const BoxMark& b, const Vec3f& colour) {
    const Vec3f extent = relative(b.high, b.low), least = Vec3f{1, 1, 1} * 1e-6f;
    copies[outline_].push_back(
        {.position = relative(b.low, eye), .turn = {0, 0, 0, 1}, .scale = max(extent, least), .colour = colour});
  };
  if (style.boxes) {
    for (const BoxMark& b : scene.boxes) add(b, linear_colour(0xf4f6f8));
  }
  if (style.cells) {
    for (const BoxMark& b : scene.cells) {
      const float size = length(relative(b.high, b.low));
      add(b, category_colour(size > 0 ? std::uint32_t(1000 + std::lround(std::log2(size))) : 0));
    }
  }
  instances_.place(copies);
}

}
