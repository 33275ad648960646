// Every geometry of a world, once, by content. Outside the state: a number in here is all that bodies keep.
#pragma once

#include "geometry/archive.h"

namespace sudar::inline SUDAR_PRECISION {

class GeometryStore {
 public:
  std::uint32_t number_of(const Shape& shape) {
    for (std::uint32_t i = 0; i < shapes_.size(); ++i) {
      if (shapes_[i] == shape) return i;
    }
    shapes_.push_back(shape);
    return std::uint32_t(shapes_.size() - 1);
  }
  const Shape& operator[](std::uint32_t number) const { return shapes_[number]; }
  std::uint32_t size() const { return std::uint32_t(shapes_.size()); }

  friend void write(Writer& w, const GeometryStore& s) {
    w.value(std::uint64_t(s.shapes_.size()));
    for (const Shape& shape : s.shapes_) write(w, shape);
  }
  friend void read(Reader& r, GeometryStore& s) {
    s.shapes_.resize(r.count(1));
    for (Shape& shape : s.shapes_) read(r, shape);
  }

 private:
  std::vector<Shape> shapes_;
};

}
