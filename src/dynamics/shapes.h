// The shapes that bodies are made of: plain arrays by slot, generated from fields.def. A shape's slot is the number of its
// proxy in the broad phase, and pairs are pairs of shapes. The shapes of a body are a list in the order of their coming.
#pragma once

#include <sudar/definitions.h>

#include "base/slots.h"
#include "geometry/archive.h"

namespace sudar::inline SUDAR_PRECISION {

inline constexpr std::uint32_t no_shape = 0xffffffffu;

struct Shapes {
#define SHAPE_FIELD(type, name, unit, stage) std::vector<type> name;
#include "dynamics/fields.def"
  Slots slots;

  // A shape of nobody yet, with all fields 0.
  std::uint32_t add();
  void remove(std::uint32_t s) { slots.give_back(s); }
  std::uint32_t size() const { return slots.size(); }

  // visit(shape) for the list that begins with `first`.
  template <class Visit>
  void each(std::uint32_t first, Visit visit) const {
    for (std::uint32_t s = first; s != no_shape;) {
      const std::uint32_t after = next[s];  // the one visited may be removed
      visit(s);
      s = after;
    }
  }

  friend void write(Writer&, const Shapes&);
  friend void read(Reader&, Shapes&);
};

// A part of a body for the sums below: of a shape per unit density, in its own frame.
struct MassPart {
  const MassProperties* mass;
  Transform pose;  // in the whole's frame
  double density;  // kg/m³
};
// Mass properties of a whole, per unit of `density`, which is that of its first part.
struct MassSum {
  MassProperties unit;
  double density = 0;  // kg/m³
};
// By Steiner's theorem, as if the parts did not overlap. Of one part that is not moved: its own, bit for bit.
MassSum sum_masses(std::span<const MassPart> parts);

}
