// A picture in memory: rows from top to bottom, red, green, blue, alpha as bytes in sRGB.
#pragma once

#include <cstdint>
#include <vector>

namespace sudar::view {

struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;  // 4 · width · height
  const std::uint8_t* pixel(int x, int y) const { return &rgba[std::size_t(4) * std::size_t(y * width + x)]; }
};

// The same size, but what is seen at each pixel: the number of an instance in the scene plus 1, 0 for none.
struct IdImage {
  int width = 0, height = 0;
  std::vector<std::uint32_t> ids;  // width · height
  std::uint32_t at(int x, int y) const { return ids[std::size_t(y * width + x)]; }
};

}
