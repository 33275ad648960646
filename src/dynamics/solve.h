// What a solver is given for one sub-step, and what it tells afterwards.
#pragma once

#include <sudar/profile.h>

#include "collision/narrow/collide.h"
#include "dynamics/contacts.h"
#include "dynamics/forces.h"
#include "dynamics/joints.h"

namespace sudar::inline SUDAR_PRECISION {

// A touching pair of which at least one side moves.
struct ActiveContact {
  std::uint32_t a, b;        // body slots
  std::uint32_t slot;        // in Contacts
  const Manifold* manifold;  // points relative to the origin of a's shape, world axes
  Material material;
};

struct SolveInput {
  const Config& config;
  Real h;  // s
  const Forces& forces;
  std::span<const ActiveContact> contacts;  // in the order in which they are solved
  std::span<const std::uint32_t> joints;
  std::span<const std::uint32_t> awake;   // dynamic bodies, ascending
  std::span<const std::uint32_t> smooth;  // those of them for Runge–Kutta: no contacts, no joints
  std::span<const std::uint32_t> kinematic;
  std::span<const Geometry* const> geometries;  // by body slot
};

struct SolveReport {
  struct Hit {
    std::uint32_t contact;  // number in the input
    Vec3 at;                // relative to a's centre of mass
    Real speed;             // of approach, m/s
  };
  std::vector<Hit> hits;
  std::vector<std::uint32_t> broken;  // bodies that turned non-finite and were put back
  std::int64_t points = 0;            // solved in this sub-step
  Profile::Passes collision, contact, correction, joint;
};

}
