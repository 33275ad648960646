// Every geometry of a world, once, by content. Outside the state: a number in here is all that bodies keep.
#pragma once

#include <unordered_map>

#include "geometry/archive.h"

namespace sudar::inline SUDAR_PRECISION {

class GeometryStore {
 public:
  std::uint32_t number_of(const Shape& shape) {
    if (const auto at = by_address_.find(&shape.geometry()); at != by_address_.end()) return at->second;
    std::vector<std::uint32_t>& alike = by_content_[hash_of(shape)];
    for (const std::uint32_t i : alike) {
      if (shapes_[i] == shape) return i;
    }
    const auto number = std::uint32_t(shapes_.size());
    alike.push_back(number);
    by_address_.emplace(&shape.geometry(), number);
    shapes_.push_back(shape);
    return number;
  }
  const Shape& operator[](std::uint32_t number) const { return shapes_[number]; }
  std::uint32_t size() const { return std::uint32_t(shapes_.size()); }

  friend void write(Writer& w, const GeometryStore& s) {
    w.named("count", std::uint64_t(s.shapes_.size()));
    w.each("shape", s.shapes_);
  }
  friend void read(Reader& r, GeometryStore& s) {
    s.shapes_.resize(r.count(1));
    s.by_address_.clear(), s.by_content_.clear();
    for (std::uint32_t i = 0; i < s.size(); ++i) {
      read(r, s.shapes_[i]);
      if (!s.shapes_[i]) throw Error("data", "holds no shape where one should be");
      s.by_address_.emplace(&s.shapes_[i].geometry(), i);
      s.by_content_[hash_of(s.shapes_[i])].push_back(i);
    }
  }

 private:
  static std::uint64_t hash_of(const Shape& shape) {
    HashWriter w;
    write(w, shape);
    return w.hash();
  }

  std::vector<Shape> shapes_;
  // Only looked up, never walked. What lies here stays alive, so its address is nobody else's.
  std::unordered_map<const Geometry*, std::uint32_t> by_address_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> by_content_;
};

}
