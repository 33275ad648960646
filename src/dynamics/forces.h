// External forces, thesis §3.4: surface gravity (thesis (3.5)), resistance of the medium, n-body gravity, a force at a point.
#pragma once

#include "dynamics/bodies.h"

namespace sudar::inline SUDAR_PRECISION {

struct Forces {
  std::vector<Force> definition;
  Slots slots;
  std::uint32_t add(const Force& def) {
    const std::uint32_t i = slots.take();
    if (i == definition.size()) definition.emplace_back();
    definition[i] = def;
    return i;
  }
  void remove(std::uint32_t i) { slots.give_back(i); }
  friend void write(Writer&, const Forces&);
  friend void read(Reader&, Forces&);
};

// Sum of the uniform gravities, m/s².
Vec3 gravity(const Forces&);

// Force [N] and torque about the centre of mass [N m] on which[k], as out[k], from all forces but Drag, plus the bodies'
// own pushes.
void evaluate(const Forces&, const Bodies&, std::span<const std::uint32_t> which, std::vector<Wrench>& out);

// Whether they change with where bodies are.
bool vary(const Forces&);
// Whether bodies feel each other from afar, so that none may move before all have been asked.
bool act_from_afar(const Forces&);

// Resistance as rates: v̇ = −(linear + quadratic |v|) v, and the twin for ω.
struct DragRates {
  Real linear = 0, quadratic = 0, angular = 0, angular_quadratic = 0;
};
DragRates drag_on(const Forces&, const Bodies&, std::uint32_t body);

// Potential energy of the dynamic bodies in Gravity and NBody, J.
double potential_energy(const Forces&, const Bodies&);

}
