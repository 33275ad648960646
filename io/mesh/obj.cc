// Wavefront OBJ: positions and faces; all else is about looks.
#include <utility>

#include "io/mesh/lines.h"
#include "io/mesh/read.h"

namespace sudar::inline SUDAR_PRECISION::io {

Surface read_obj(Source& source, const std::string& file, std::span<const std::byte> bytes) {
  Surface s;
  Lines lines(file, bytes);
  std::vector<std::string_view> words;
  bool curves = false;
  while (lines.next(words)) {
    if (words.empty()) continue;
    if (words[0] == "v") {
      if (words.size() < 4) lines.refuse("a vertex needs three numbers");
      source.count_vertices(1);
      s.vertices.push_back({lines.number(words[1]), lines.number(words[2]), lines.number(words[3])});
    } else if (words[0] == "f") {
      std::vector<std::uint32_t> face;
      for (std::size_t k = 1; k < words.size(); ++k) {  // "7/1/3": vertex, texture, normal; below 0: from the end
        const std::int64_t i = lines.whole(words[k].substr(0, words[k].find('/')));
        const std::int64_t n = std::int64_t(s.vertices.size()), v = i < 0 ? n + i : i - 1;
        if (i == 0 || v < 0 || v >= n) {
          lines.refuse("names vertex " + std::to_string(i) + ", but there are " + std::to_string(n) + " so far");
        }
        face.push_back(std::uint32_t(v));
      }
      if (face.size() < 3) lines.refuse("a face needs three vertices");
      source.count_triangles(face.size() - 2);
      for (std::size_t k = 1; k + 1 < face.size(); ++k) {
        s.triangles.insert(s.triangles.end(), {face[0], face[k], face[k + 1]});
      }
    } else if (words[0] == "surf" || words[0] == "curv" || words[0] == "curv2") {
      if (!std::exchange(curves, true))
        source.warn(lines.here(), "free-form curves and surfaces are not supported; left out");
    }
  }
  return s;
}

}
