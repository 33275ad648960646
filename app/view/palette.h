// Colours that go together: every kind of shape in a scene gets a gradient of its own, along which its bodies walk to
// and fro by their number. So a wall is made of related bricks, a row of dominoes shades from end to end, and the ball
// that hits them stands out.
#pragma once

#include "view/linear.h"

namespace sudar::view {

Vec3f body_colour(std::uint32_t shape_number, std::uint32_t body_number);  // linear light
Vec3f fixed_colour();
Vec3f link_colour();
Vec3f scale_colour(float share);              // 0…1: from dark blue over green to yellow, evenly brighter
Vec3f category_colour(std::uint32_t number);  // numbers near each other are well apart in colour

// From sRGB as designers write it (0xRRGGBB) to linear light.
Vec3f linear_colour(std::uint32_t srgb);

}
