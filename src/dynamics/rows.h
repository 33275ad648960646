// Velocity rows: the common form of everything that joints demand. One row says
//   u = linear_a·v_a − linear_b·v_b + angular_a·ω_a − angular_b·ω_b,   impulse λ: a gets +λ, b gets −λ along the same
//   directions.
#pragma once

#include <sudar/math.h>

#include <array>
#include <span>
#include <vector>

#include "base/room.h"
#include "math/lanes.h"

namespace sudar::inline SUDAR_PRECISION {

inline constexpr std::uint32_t no_body = 0xffffffffu;  // among body slots: the world

// A body's velocities, in lanes: of the centre of mass, and ω in world axes.
struct Moving {
  Real4 v{}, w{};
};

// What the solvers iterate on: one body's velocities and inverse masses.
struct SolverBody {
  Moving real;
  Moving push;                    // pseudo: moves the body, then is forgotten (split impulse)
  Mat3Lanes inverse_inertia{};    // world axes
  Vec3 spin_before;               // ω before all impulses, as spin_of() gives it
  Real inverse_mass = 0;          // 0: does not answer impulses
  bool touches = false;           // is in a contact
  bool settled = false;           // its motion over the sub-step is decided already: exact joints, Runge–Kutta
  bool answers() const { return inverse_mass > 0; }
};

// The bodies that move, without gaps: the awake ones island after island, then the kinematic ones. Before them, as
// number 0, stands in for all that stays where it is: the world and every body at rest. Numbers belong to bodies as in a
// sparse set (Briggs, Torczon 1993), so that a new sub-step costs nothing for the bodies that are not in it.
class SolverBodies {
 public:
  static constexpr std::uint32_t still = 0;

  void reserve(std::uint32_t slots) {
    make_room(number_, slots);
  }
  void reset(std::span<const std::uint32_t> awake, std::span<const std::uint32_t> kinematic, std::uint32_t slots) {
    slot_.assign(1, no_body);
    slot_.insert(slot_.end(), awake.begin(), awake.end());
    slot_.insert(slot_.end(), kinematic.begin(), kinematic.end());
    reserve(slots);
    for (std::uint32_t n = 1; n < size(); ++n) number_[slot_[n]] = n;
    bodies_.resize(slot_.size());
    bodies_[still] = {};
  }
  std::uint32_t size() const { return std::uint32_t(slot_.size()); }
  std::uint32_t slot(std::uint32_t number) const { return slot_[number]; }
  std::uint32_t number(std::uint32_t slot) const {
    if (slot == no_body) return still;
    const std::uint32_t n = number_[slot];
    return n < size() && slot_[n] == slot ? n : still;
  }
  SolverBody& operator[](std::uint32_t number) { return bodies_[number]; }
  const SolverBody& operator[](std::uint32_t number) const { return bodies_[number]; }

 private:
  std::vector<SolverBody> bodies_;
  std::vector<std::uint32_t> slot_;    // by number
  std::vector<std::uint32_t> number_;  // by slot; means something only where slot_ agrees
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
    return {lanes(linear), lanes(angular), lanes(linear * on.inverse_mass), on.inverse_inertia * lanes(angular)};
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
