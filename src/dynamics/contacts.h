// What is remembered of a touching pair from step to step, by slot; the pair's row in the pair table names its slot.
#pragma once

#include "base/slots.h"
#include "dynamics/bodies.h"

namespace sudar::inline SUDAR_PRECISION {

// Impulses by point in the order of the manifold's points, N·s, on a.
struct ContactImpulse {
  std::array<Real, 4> normal{};
  std::array<Vec3, 4> friction{};
  Vec3 turning;  // of the whole contact: rolling and spinning resistance, N m s, world axes
};
template <class V, Like<ContactImpulse> T>
void describe(V& v, T& d) { v("normal", d.normal, any), v("friction", d.friction, any), v("turning", d.turning, any); }
static_assert(sizeof(ContactImpulse) == 19 * sizeof(Real), "saved as bytes");

// Where both bodies were when the contact's manifold was found, and how far its points were apart then.
struct ContactPlace {
  Pose a, b;  // of the centres of mass
  std::array<Real, 4> separation{};
};
template <class V, Like<ContactPlace> T>
void describe(V& v, T& d) {
  v("a.position", d.a.p, any), v("a.orientation", d.a.q, any);
  v("b.position", d.b.p, any), v("b.orientation", d.b.q, any);
  v("separation", d.separation, any);
}
static_assert(sizeof(ContactPlace) == 2 * sizeof(Pose) + 4 * sizeof(Real), "saved as bytes");

// What of a contact's impulses does not leak away (soft_step.h), by point, N s; and all that was carried then.
struct ContactReference {
  std::array<Real, 4> normal{};
  Real carried = 0;
};
template <class V, Like<ContactReference> T>
void describe(V& v, T& d) { v("normal", d.normal, any), v("carried", d.carried, any); }
static_assert(sizeof(ContactReference) == 5 * sizeof(Real), "saved as bytes");

struct Contacts {
#define CONTACT_FIELD(type, name, unit, stage) std::vector<type> name;
#include "dynamics/fields.def"
  Slots slots;

  std::uint32_t add() {
    const std::uint32_t i = slots.take();
#define CONTACT_FIELD(type, name, unit, stage) \
  if (i == name.size()) name.emplace_back(); else name[i] = type{};
#include "dynamics/fields.def"
    return i;
  }
  void remove(std::uint32_t i) { slots.give_back(i); }

  friend void write(Writer& w, const Contacts& c) {
    write(w, c.slots);
#define CONTACT_FIELD(type, name, unit, stage) w.named(#name, c.name);
#include "dynamics/fields.def"
  }
  friend void read(Reader& r, Contacts& c) {
    read(r, c.slots);
#define CONTACT_FIELD(type, name, unit, stage) \
  r.array(c.name);                             \
  if (c.name.size() != c.slots.size()) throw Error("data", "has arrays of different lengths");
#include "dynamics/fields.def"
  }
};

// The pair's material of two bodies' materials. Of rolling and spinning the more resistant one decides.
inline Real mix(Mix how, Real a, Real b) {
  switch (how) {
    case Mix::min: return min(a, b);
    case Mix::geometric: return sqrt(a * b);
    case Mix::average: return (a + b) * Real(0.5);
    case Mix::max: return max(a, b);
  }
  return 0;
}
inline Material mix(const Config& config, const Material& a, const Material& b) {
  return {mix(config.friction_mix, a.friction_static, b.friction_static),
          mix(config.friction_mix, a.friction_dynamic, b.friction_dynamic),
          mix(config.restitution_mix, a.restitution, b.restitution), max(a.rolling, b.rolling),
          max(a.spinning, b.spinning)};
}

}
