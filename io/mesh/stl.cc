// STL, as text or binary: triangles without common vertices.
#include <cstring>

#include "io/mesh/lines.h"
#include "io/mesh/read.h"

namespace sudar::inline SUDAR_PRECISION::io {

namespace {

constexpr std::size_t head = 84, facet = 50;  // bytes: 80 of comment, a count; normal, three corners, two bytes more

template <class T>
T at(std::span<const std::byte> bytes, std::size_t offset) {
  T value;
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

// Some binary files begin with "solid", too: it is their length that tells.
bool is_binary(std::span<const std::byte> bytes) {
  if (bytes.size() < head) return false;
  const std::string_view start(reinterpret_cast<const char*>(bytes.data()), 5);
  return bytes.size() == head + facet * std::size_t(at<std::uint32_t>(bytes, 80)) || start != "solid";
}

Surface binary(Source& source, const std::string& file, std::span<const std::byte> bytes) {
  const std::size_t count = at<std::uint32_t>(bytes, 80);
  if (count > (bytes.size() - head) / facet) {
    throw FileError({file, 0, ""}, "is cut short: it has " + std::to_string((bytes.size() - head) / facet) + " of " +
                                       std::to_string(count) + " triangles");
  }
  source.count_triangles(count), source.count_vertices(3 * count);
  Surface s;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t from = head + facet * i + 12 + 12 * k;
      const Vec3d v{at<float>(bytes, from), at<float>(bytes, from + 4), at<float>(bytes, from + 8)};
      if (!is_finite(v)) throw FileError({file, 0, "triangle " + std::to_string(i)}, "has a corner that is not finite");
      s.triangles.push_back(std::uint32_t(s.vertices.size()));
      s.vertices.push_back(v);
    }
  }
  return s;
}

}

Surface read_stl(Source& source, const std::string& file, std::span<const std::byte> bytes) {
  if (is_binary(bytes)) return binary(source, file, bytes);
  Surface s;
  Lines lines(file, bytes);
  std::vector<std::string_view> words;
  std::size_t corners = 0;
  bool solid = false;
  while (lines.next(words)) {
    if (words.empty()) continue;
    if (!solid && words[0] != "solid")
      lines.refuse("is no STL: it begins neither with \"solid\" nor as a binary one does");
    solid = true;
    if (words[0] == "outer") corners = 0;
    if (words[0] == "endloop" && corners != 3) lines.refuse("a triangle has " + std::to_string(corners) + " corners");
    if (words[0] != "vertex") continue;
    if (words.size() < 4) lines.refuse("a vertex needs three numbers");
    if (++corners > 3) lines.refuse("a triangle has more than three corners");
    source.count_vertices(1);
    s.triangles.push_back(std::uint32_t(s.vertices.size()));
    s.vertices.push_back({lines.number(words[1]), lines.number(words[2]), lines.number(words[3])});
  }
  if (s.vertices.size() % 3 != 0) lines.refuse("ends in the middle of a triangle");
  return s;
}

}
