// Velocity rows: the common form of everything that joints demand. One row says
//   u = linear·(v_a − v_b) + angular_a·ω_a − angular_b·ω_b,   impulse λ: a gets +λ, b gets −λ along the same directions.
#pragma once

#include <sudar/math.h>

#include <array>

namespace sudar::inline SUDAR_PRECISION {

// What the solvers iterate on: one body's velocities and inverse masses. World axes, about the centre of mass.
struct SolverBody {
  Vec3 v, w;              // real
  Vec3 push_v, push_w;    // pseudo: moves the body, then is forgotten (split impulse)
  Real inverse_mass = 0;
  Mat3 inverse_inertia;
};

struct Row {
  Vec3 linear, angular_a, angular_b;
  Real error = 0;         // how far the position is from the row's aim, in its unit
};

// A row with what impulses need: M⁻¹Jᵀ.
struct PreparedRow : Row {
  Vec3 turn_a, turn_b;    // I⁻¹ angular
  void prepare(const SolverBody& a, const SolverBody& b) {
    turn_a = a.inverse_inertia * angular_a;
    turn_b = b.inverse_inertia * angular_b;
  }
  Real speed(const SolverBody& a, const SolverBody& b) const {
    return dot(linear, a.v - b.v) + dot(angular_a, a.w) - dot(angular_b, b.w);
  }
  Real push_speed(const SolverBody& a, const SolverBody& b) const {
    return dot(linear, a.push_v - b.push_v) + dot(angular_a, a.push_w) - dot(angular_b, b.push_w);
  }
  void apply(SolverBody& a, SolverBody& b, Real impulse) const {
    a.v += linear * (a.inverse_mass * impulse);
    a.w += turn_a * impulse;
    b.v -= linear * (b.inverse_mass * impulse);
    b.w -= turn_b * impulse;
  }
  void apply_push(SolverBody& a, SolverBody& b, Real impulse) const {
    a.push_v += linear * (a.inverse_mass * impulse);
    a.push_w += turn_a * impulse;
    b.push_v -= linear * (b.inverse_mass * impulse);
    b.push_w -= turn_b * impulse;
  }
};

// J M⁻¹ Jᵀ between two rows of the same two bodies.
inline Real response(const PreparedRow& i, const PreparedRow& j, const SolverBody& a, const SolverBody& b) {
  return dot(i.linear, j.linear) * (a.inverse_mass + b.inverse_mass) + dot(i.angular_a, j.turn_a) +
         dot(i.angular_b, j.turn_b);
}

// A symmetric positive definite system of at most six equations, factored K = L D Lᵀ.
class SmallSystem {
 public:
  // `k` by rows, lower triangle used. A relative compliance keeps rows that repeat each other (redundant) solvable.
  void factor(const std::array<std::array<Real, 6>, 6>& k, int n) {
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j <= i; ++j) {
        Real s = k[std::size_t(i)][std::size_t(j)];
        for (int m = 0; m < j; ++m) s -= l_[i][m] * l_[j][m] * d_[m];
        if (j < i) {
          l_[i][j] = s * inverse_d_[j];
        } else {
          const Real least = k[std::size_t(i)][std::size_t(i)] * compliance;
          d_[i] = max(s + least, least);
          inverse_d_[i] = d_[i] > 0 ? 1 / d_[i] : Real(0);
        }
      }
    }
  }
  template <int n>
  void solve(std::array<Real, 6>& x) const {
    for (int i = 1; i < n; ++i) {
      for (int j = 0; j < i; ++j) x[std::size_t(i)] -= l_[i][j] * x[std::size_t(j)];
    }
    for (int i = 0; i < n; ++i) x[std::size_t(i)] *= inverse_d_[i];
    for (int i = n - 2; i >= 0; --i) {
      for (int j = i + 1; j < n; ++j) x[std::size_t(i)] -= l_[j][i] * x[std::size_t(j)];
    }
  }

 private:
  static constexpr Real compliance = sizeof(Real) == 4 ? Real(1e-6) : Real(1e-12);
  Real l_[6][6] = {}, d_[6] = {}, inverse_d_[6] = {};
};

}
