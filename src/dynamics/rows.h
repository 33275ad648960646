// Velocity rows: the common form of everything that joints demand. One row says
//   u = linear_a·v_a − linear_b·v_b + angular_a·ω_a − angular_b·ω_b,   impulse λ: a gets +λ, b gets −λ along the same
//   directions.
#pragma once

#include <sudar/math.h>

#include <array>
#include <vector>

#include "math/lanes.h"

namespace sudar::inline SUDAR_PRECISION {

// A body's velocities, in lanes: of the centre of mass, and ω in world axes.
struct Moving {
  Real4 v{}, w{};
};

// What the solvers iterate on: one body's velocities and inverse masses.
struct SolverBody {
  Moving real;
  Moving push;  // pseudo: moves the body, then is forgotten (split impulse)
  Real inverse_mass = 0;
  Mat3 inverse_inertia;
  Vec3 spin_before;  // ω before all impulses, as spin_of() gives it
};

// By slot; no_body, the world, has one too, which nothing moves.
class SolverBodies {
 public:
  void reset(std::size_t slots) { all_.assign(slots + 1, {}); }
  SolverBody& operator[](std::uint32_t slot) { return all_[slot + 1]; }  // no_body + 1 is 0
  const SolverBody& operator[](std::uint32_t slot) const { return all_[slot + 1]; }

 private:
  std::vector<SolverBody> all_;
};

struct Row {
  Vec3 linear_a, linear_b, angular_a, angular_b;
  Real error = 0;  // how far the position is from the row's aim, in its unit
};

// A row with what impulses need: M⁻¹Jᵀ.
struct PreparedRow {
  struct Side {
    Real4 linear, angular;  // its part of J
    Real4 step, turn;       // impulse → change of v and ω
  };
  Side a, b;  // b with its minus sign
  Real error = 0;

  PreparedRow() = default;
  PreparedRow(const Row& row, const SolverBody& on_a, const SolverBody& on_b)
      : a(side(row.linear_a, row.angular_a, on_a)), b(side(-row.linear_b, -row.angular_b, on_b)), error(row.error) {}

  Real speed(const Moving& on_a, const Moving& on_b) const {
    return sum((a.linear * on_a.v + b.linear * on_b.v) + (a.angular * on_a.w + b.angular * on_b.w));
  }
  void apply(Moving& on_a, Moving& on_b, Real impulse) const {
    const Real4 all = broadcast(impulse);
    on_a.v += a.step * all;
    on_a.w += a.turn * all;
    on_b.v += b.step * all;
    on_b.w += b.turn * all;
  }

 private:
  static Side side(const Vec3& linear, const Vec3& angular, const SolverBody& on) {
    return {lanes(linear), lanes(angular), lanes(linear * on.inverse_mass), lanes(on.inverse_inertia * angular)};
  }
  static Real sum(const Real4& x) { return (x[0] + x[1]) + x[2]; }
  friend Real response(const Side&, const Side&);
};

// J M⁻¹ Jᵀ of two rows by one body that both act on, and by both.
inline Real response(const PreparedRow::Side& i, const PreparedRow::Side& j) {
  return PreparedRow::sum(i.linear * j.step + i.angular * j.turn);
}
inline Real response(const PreparedRow& i, const PreparedRow& j) { return response(i.a, j.a) + response(i.b, j.b); }

}
