#include "view/palette.h"

#include <array>
#include <cmath>
#include <iterator>

namespace sudar::view {

namespace {

struct Gradient {
  std::uint32_t from, to;  // sRGB
};
constexpr Gradient gradients[] = {
    {0xd9573b, 0xeda23f},  // brick to amber
    {0x2a7fba, 0x2bb3a3},  // blue to teal
    {0x7d5bb5, 0xd0649b},  // violet to rose
    {0x4f9d57, 0xb4bf45},  // green to lime
    {0xc24a6a, 0xe88a62},  // raspberry to peach
    {0x3f5fa8, 0x7d86d8},  // indigo to periwinkle
};
constexpr std::uint32_t gradient_length = 12;  // bodies from one end to the other

float linear_channel(std::uint32_t byte) {  // IEC 61966-2-1
  const float c = float(byte) / 255;
  return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f);
}

// Oklab (Ottosson 2020): a straight line in it looks like an even change of colour.
Vec3f to_oklab(const Vec3f& c) {
  const float l = std::cbrt(0.4122214708f * c.x + 0.5363325363f * c.y + 0.0514459929f * c.z);
  const float m = std::cbrt(0.2119034982f * c.x + 0.6806995451f * c.y + 0.1073969566f * c.z);
  const float s = std::cbrt(0.0883024619f * c.x + 0.2817188376f * c.y + 0.6299787005f * c.z);
  return {0.2104542553f * l + 0.7936177850f * m - 0.0040720468f * s,
          1.9779984951f * l - 2.4285922050f * m + 0.4505937099f * s,
          0.0259040371f * l + 0.7827717662f * m - 0.8086757660f * s};
}
Vec3f from_oklab(const Vec3f& c) {
  const float l = c.x + 0.3963377774f * c.y + 0.2158037573f * c.z;
  const float m = c.x - 0.1055613458f * c.y - 0.0638541728f * c.z;
  const float s = c.x - 0.0894841775f * c.y - 1.2914855480f * c.z;
  const float l3 = l * l * l, m3 = m * m * m, s3 = s * s * s;
  const Vec3f linear{4.0767416621f * l3 - 3.3077115913f * m3 + 0.2309699292f * s3,
                     -1.2684380046f * l3 + 2.6097574011f * m3 - 0.3413193965f * s3,
                     -0.0041960863f * l3 - 0.7034186147f * m3 + 1.7076147010f * s3};
  return max(min(linear, Vec3f{1, 1, 1}), Vec3f{0, 0, 0});
}

}

Vec3f linear_colour(std::uint32_t srgb) {
  return {linear_channel(srgb >> 16 & 255), linear_channel(srgb >> 8 & 255), linear_channel(srgb & 255)};
}

namespace {

constexpr std::uint32_t period = 2 * gradient_length;  // of the colours of one gradient: there and back

Vec3f on_gradient(const Gradient& g, std::uint32_t phase) {
  const std::uint32_t way = phase < gradient_length ? phase : period - phase;
  const float t = float(way) / float(gradient_length);
  Vec3f lab = to_oklab(linear_colour(g.from)) * (1 - t) + to_oklab(linear_colour(g.to)) * t;
  lab.x += phase % 2 == 0 ? 0.012f : -0.012f;  // neighbours differ a little in lightness, too
  return from_oklab(lab);
}

using Colours = std::array<std::array<Vec3f, period>, std::size(gradients)>;
Colours all_colours() {
  Colours all;
  for (std::size_t g = 0; g < all.size(); ++g) {
    for (std::uint32_t phase = 0; phase < period; ++phase) all[g][phase] = on_gradient(gradients[g], phase);
  }
  return all;
}

}

Vec3f body_colour(std::uint32_t shape_number, std::uint32_t body_number) {
  static const Colours colours = all_colours();  // asked for every body of every moment
  return colours[shape_number % std::size(gradients)][body_number % period];
}

Vec3f scale_colour(float share) {
  // Five colours of viridis (S. van der Walt, N. Smith 2015).
  constexpr std::uint32_t stops[] = {0x440154, 0x3b528b, 0x21918c, 0x5ec962, 0xfde725};
  const float x = max(0.0f, min(share, 1.0f)) * float(std::size(stops) - 1);
  const auto i = std::size_t(min(x, float(std::size(stops) - 2)));
  const float t = x - float(i);
  return from_oklab(to_oklab(linear_colour(stops[i])) * (1 - t) + to_oklab(linear_colour(stops[i + 1])) * t);
}

Vec3f category_colour(std::uint32_t number) {
  constexpr float golden_angle = 2.3999632f;  // rad
  const float hue = golden_angle * float(number % 4096);
  return from_oklab({number % 2 == 0 ? 0.72f : 0.62f, 0.13f * std::cos(hue), 0.13f * std::sin(hue)});
}

Vec3f fixed_colour() { return linear_colour(0xa9adb3); }
Vec3f link_colour() { return linear_colour(0x5a6068); }

}
