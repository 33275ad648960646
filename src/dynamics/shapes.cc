#include "dynamics/shapes.h"

namespace sudar::inline SUDAR_PRECISION {

std::uint32_t Shapes::add() {
  const std::uint32_t s = slots.take();
#define SHAPE_FIELD(type, name, unit, stage) \
  if (s == name.size()) name.emplace_back(); else name[s] = type{};
#include "dynamics/fields.def"
  next[s] = no_shape;
  return s;
}

void write(Writer& w, const Shapes& s) {
  write(w, s.slots);
#define SHAPE_FIELD(type, name, unit, stage) w.named(#name, s.name);
#include "dynamics/fields.def"
}

void read(Reader& r, Shapes& s) {
  read(r, s.slots);
#define SHAPE_FIELD(type, name, unit, stage) \
  r.array(s.name);                           \
  if (s.name.size() != s.size()) throw Error("data", "has arrays of different lengths");
#include "dynamics/fields.def"
}

namespace {

struct Placed {
  double volume;  // weighted
  Vec3d center;
  Mat3d inertia;  // about that centre, weighted
};

Placed place(const MassPart& part, double weight) {
  const Quatd turn = normalize(convert<double>(part.pose.q));
  const Mat3d r = matrix(turn);
  return {weight * part.mass->volume, convert<double>(part.pose.p) + rotate(turn, part.mass->center),
          r * part.mass->inertia * transpose(r) * weight};
}

}

MassSum sum_masses(std::span<const MassPart> parts) {
  MassSum sum{.unit = {}, .density = parts[0].density};
  std::vector<Placed> placed;
  for (const MassPart& part : parts) placed.push_back(place(part, part.density / sum.density));
  Vec3d moment;  // about the first part's centre: a part alone keeps its own
  for (const Placed& p : placed) {
    sum.unit.volume += p.volume;
    moment += (p.center - placed[0].center) * p.volume;
  }
  sum.unit.center = placed[0].center + moment / sum.unit.volume;
  for (const Placed& p : placed) {
    const Vec3d d = p.center - sum.unit.center;
    sum.unit.inertia = sum.unit.inertia + p.inertia +
                       (Mat3d::diagonal({dot(d, d), dot(d, d), dot(d, d)}) - Mat3d::outer(d, d)) * p.volume;
  }
  return sum;
}

}
