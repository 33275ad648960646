#include "io/surface.h"

#include <sudar/base.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <set>

namespace sudar::inline SUDAR_PRECISION::io {

namespace {

std::vector<Vec3> rounded(const std::vector<Vec3d>& vertices) {
  std::vector<Vec3> list;
  list.reserve(vertices.size());
  for (const Vec3d& v : vertices) list.push_back(convert<Real>(v));
  return list;
}

std::optional<MassProperties> enclosed(const Surface& s) {
  if (s.triangles.empty()) return {};
  try {
    const MassProperties solid = mass_properties(s.vertices, s.triangles);
    if (!(abs(solid.volume) > 0) || !is_finite(solid.center)) return {};
    return solid;
  } catch (const Error&) { return {}; }
}

}

void Surface::add(const Surface& other) {
  const auto first = std::uint32_t(vertices.size());
  vertices.insert(vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const std::uint32_t v : other.triangles) triangles.push_back(first + v);
}

Cleaned cleaned(const Surface& s) {
  Cleaned result;
  // By their places in the precision of a shape, in which different ones may fall together.
  const std::vector<Vec3> places = rounded(s.vertices);
  std::vector<std::uint32_t> order(places.size()), number(places.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto key = [&](std::uint32_t i) { return std::array{places[i].x, places[i].y, places[i].z}; };
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  std::vector<std::uint32_t> first(places.size());  // of those in that place
  for (std::size_t k = 0; k < order.size(); ++k) {
    first[order[k]] = k > 0 && places[order[k]] == places[order[k - 1]] ? first[order[k - 1]] : order[k];
  }
  for (std::uint32_t i = 0; i < places.size(); ++i) {
    number[i] = first[i] == i ? std::uint32_t(result.surface.vertices.size()) : number[first[i]];
    if (first[i] == i) result.surface.vertices.push_back(convert<double>(places[i]));
  }
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (std::size_t t = 0; t + 2 < s.triangles.size(); t += 3) {
    const std::array v{number[s.triangles[t]], number[s.triangles[t + 1]], number[s.triangles[t + 2]]};
    const Vec3d& a = result.surface.vertices[v[0]];
    const Vec3d e = result.surface.vertices[v[1]] - a, f = result.surface.vertices[v[2]] - a;
    const double area = length(cross(e, f)), longest = max(max(dot(e, e), dot(f, f)), dot(f - e, f - e));
    if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0] || !(area > 1e-7 * longest)) {
      result.flat += 1;
      continue;
    }
    const std::array sides{std::pair{v[0], v[1]}, std::pair{v[1], v[2]}, std::pair{v[2], v[0]}};
    if (std::ranges::any_of(sides, [&](const auto& side) { return edges.contains(side); })) {
      result.doubled += 1;
      continue;
    }
    edges.insert(sides.begin(), sides.end());
    result.surface.triangles.insert(result.surface.triangles.end(), v.begin(), v.end());
  }
  result.solid = enclosed(result.surface);
  if (result.solid && result.solid->volume < 0) {
    result.inside_out = true;
    for (std::size_t t = 0; t < result.surface.triangles.size(); t += 3) {
      std::swap(result.surface.triangles[t], result.surface.triangles[t + 1]);
    }
    result.solid = enclosed(result.surface);
  }
  return result;
}

Shape hull_of(const Surface& s) { return hull(rounded(s.vertices)); }
Shape mesh_of(const Surface& s) { return mesh(rounded(s.vertices), s.triangles); }

std::string what_is_gone(const Cleaned& c) {
  std::string text;
  if (c.flat > 0) text += std::to_string(c.flat) + " triangles without area";
  if (c.doubled > 0)
    text += (text.empty() ? "" : " and ") + std::to_string(c.doubled) + " that are there twice or inverted";
  return text.empty() ? text : text + " are left out";
}

std::string excess_of_hull(const Shape& hull, const MassProperties& solid) {
  const double excess = hull.mass_properties().volume / solid.volume - 1;
  if (!(excess > 1e-3)) return {};
  char text[64];
  std::snprintf(text, sizeof text, "is %.3g %% larger", 100 * excess);
  return text;
}

}
