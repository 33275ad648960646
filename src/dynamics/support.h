// Which contact carries how much: the weight of everything that stands on something, handed down from body to body once
// a step. Only what stands on the ground, or on what does, carries: things that fall together do not weigh on each
// other. A stack's solution is a guess here, not an answer: the solver lets impulses leak away towards these loads
// instead of to zero, and so keeps soft contacts from sinking (soft_step.h).
#pragma once

#include <array>
#include <span>
#include <vector>

#include <sudar/math.h>

namespace sudar::inline SUDAR_PRECISION {

// A contact that may carry: the upper body stands on the lower one.
struct Support {
  std::uint32_t upper, lower;  // numbers of bodies; lower 0: the ground
  std::uint32_t count;
  Real steepness;              // cosine between the normal and the vertical
  std::array<Vec3, 4> arm_upper{}, arm_lower{};  // of the points, from the centres of mass, m
  std::array<bool, 4> carries{};             // the point is near enough
  std::array<Real, 4> load{};                // result: normal impulses, N s
};

class SupportLoads {
 public:
  // `weight`: impulse of gravity on each body, N s, by number; `height`: of its centre along `up`, m; `radius`, m. Only bodies in
  // `which` hand down; several islands at once do not mind each other.
  void solve(std::span<Support> supports, std::span<const std::uint32_t> which, std::span<const Real> weight,
             std::span<const double> height, std::span<const Real> radius, const Vec3& up);

 private:
  struct Carried {
    Real load = 0;
    Vec3 moment;  // sum of load × arm, N s m
  };
  void ground(std::span<const Support> supports);

  std::vector<Carried> carried_;             // by body
  std::vector<std::uint8_t> grounded_;       // by body
  std::vector<std::uint32_t> first_, list_;  // supports by upper body
  std::vector<std::uint32_t> order_;
};

}
