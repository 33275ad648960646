// PLY (G. Turk, Stanford 1994): text or binary of either order of bytes; positions and faces, other properties are
// skipped.
#include <algorithm>
#include <cstring>

#include "io/mesh/lines.h"
#include "io/mesh/read.h"

namespace sudar::inline SUDAR_PRECISION::io {

namespace {

struct Type {
  const char *name, *other;
  std::size_t size;
  double (*number)(const std::byte*);
};
template <class T>
double number_at(const std::byte* at) {
  T value;
  std::memcpy(&value, at, sizeof value);
  return double(value);
}
constexpr Type types[] = {
    {"char", "int8", 1, number_at<std::int8_t>},    {"uchar", "uint8", 1, number_at<std::uint8_t>},
    {"short", "int16", 2, number_at<std::int16_t>}, {"ushort", "uint16", 2, number_at<std::uint16_t>},
    {"int", "int32", 4, number_at<std::int32_t>},   {"uint", "uint32", 4, number_at<std::uint32_t>},
    {"float", "float32", 4, number_at<float>},      {"double", "float64", 8, number_at<double>},
};

struct Property {
  std::string name;
  const Type *type = nullptr, *count = nullptr;  // count: of a list
};
struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
};

enum class Coding { text, little, big };

// The numbers of the body, one after the other.
class Numbers {
 public:
  Numbers(Lines& lines, Coding coding) : lines_(lines), coding_(coding), bytes_(lines.rest()) {}

  void begin() {  // an element
    if (coding_ != Coding::text) return;
    word_ = 0;
    do {
      if (!lines_.next(words_)) lines_.refuse("is cut short");
    } while (words_.empty());
  }
  double next(const Type& type) {
    if (coding_ == Coding::text) {
      if (word_ >= words_.size()) lines_.refuse("has too few numbers");
      return lines_.number(words_[word_++]);
    }
    if (bytes_.size() < type.size) lines_.refuse("is cut short");
    std::byte raw[8];
    std::memcpy(raw, bytes_.data(), type.size);
    if (coding_ == Coding::big) std::reverse(raw, raw + type.size);
    bytes_.remove_prefix(type.size);
    const double x = type.number(raw);
    if (!std::isfinite(x)) lines_.refuse("holds a number that is not finite");
    return x;
  }

 private:
  Lines& lines_;
  Coding coding_;
  std::string_view bytes_;
  std::vector<std::string_view> words_;
  std::size_t word_ = 0;
};

const Type& type_of(const Lines& lines, std::string_view name) {
  const auto it = std::ranges::find_if(types, [&](const Type& t) { return name == t.name || name == t.other; });
  if (it == std::end(types)) lines.refuse("\"" + std::string(name.substr(0, 40)) + "\" is no type");
  return *it;
}

std::vector<Element> read_head(Lines& lines, Coding& coding) {
  std::vector<Element> elements;
  std::vector<std::string_view> words;
  bool format = false;
  if (!lines.next(words) || words.empty() || words[0] != "ply")
    lines.refuse("is no PLY: it does not begin with \"ply\"");
  while (true) {
    if (!lines.next(words)) lines.refuse("is cut short in its head");
    if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
    if (words[0] == "end_header") break;
    if (words[0] == "format" && words.size() >= 2) {
      format = true;
      if (words[1] == "ascii")
        coding = Coding::text;
      else if (words[1] == "binary_little_endian")
        coding = Coding::little;
      else if (words[1] == "binary_big_endian")
        coding = Coding::big;
      else
        lines.refuse("\"" + std::string(words[1]) + "\" is no format");
    } else if (words[0] == "element" && words.size() >= 3) {
      const std::int64_t count = lines.whole(words[2]);
      if (count < 0) lines.refuse("a negative number of elements");
      elements.push_back({std::string(words[1]), std::size_t(count), {}});
    } else if (words[0] == "property" && words.size() >= 3 && !elements.empty()) {
      const bool list = words[1] == "list";
      if (list && words.size() < 5) lines.refuse("a list needs two types and a name");
      Property p{.name = std::string(words.back()), .type = &type_of(lines, words[list ? 3 : 1])};
      if (list) p.count = &type_of(lines, words[2]);
      elements.back().properties.push_back(p);
    } else {
      lines.refuse("\"" + std::string(words[0].substr(0, 40)) + "\" is not understood here");
    }
  }
  if (!format) lines.refuse("says no format");
  return elements;
}

}

Surface read_ply(Source& source, const std::string& file, std::span<const std::byte> bytes) {
  Lines lines(file, bytes);
  Coding coding = Coding::text;
  const std::vector<Element> elements = read_head(lines, coding);
  Numbers numbers(lines, coding);
  Surface s;
  for (const Element& e : elements) {
    if (e.properties.empty()) continue;
    for (std::size_t i = 0; i < e.count; ++i) {
      numbers.begin();
      Vec3d place;
      std::vector<std::uint32_t> face;
      for (const Property& p : e.properties) {
        const double first = numbers.next(p.count != nullptr ? *p.count : *p.type);
        if (p.count == nullptr) {
          if (p.name == "x") place.x = first;
          if (p.name == "y") place.y = first;
          if (p.name == "z") place.z = first;
          continue;
        }
        if (!(first >= 0)) lines.refuse("a list of negative length");
        for (double k = 0; k < first; ++k) {
          const double v = numbers.next(*p.type);
          if (p.name != "vertex_indices" && p.name != "vertex_index") continue;
          if (!(v >= 0 && v < double(s.vertices.size())))
            lines.refuse("face " + std::to_string(i) + " names a vertex that is not there");
          face.push_back(std::uint32_t(v));
        }
      }
      if (e.name == "vertex") source.count_vertices(1), s.vertices.push_back(place);
      if (e.name != "face" || face.size() < 3) continue;
      source.count_triangles(face.size() - 2);
      for (std::size_t k = 1; k + 1 < face.size(); ++k) {
        s.triangles.insert(s.triangles.end(), {face[0], face[k], face[k + 1]});
      }
    }
  }
  return s;
}

}
