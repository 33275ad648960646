// The seam between world and solvers: what a solver is given for one sub-step, and what it tells afterwards.
#pragma once

#include <sudar/profile.h>

#include "base/pool.h"
#include "collision/narrow/collide.h"
#include "dynamics/contacts.h"
#include "dynamics/forces.h"
#include "dynamics/islands.h"
#include "dynamics/joint_graph.h"

namespace sudar::inline SUDAR_PRECISION {

// Of a step, with the chosen solver.
inline int substeps(const Config& c) {
  return c.solver == Solver::soft_step && c.soft_step.substeps > 0 ? c.soft_step.substeps : c.substeps;
}

// A touching pair of which at least one side moves.
struct ActiveContact {
  std::uint32_t a, b;        // body slots
  std::uint32_t shape_a, shape_b;
  std::uint32_t part;        // the triangle, where one is a mesh
  std::uint32_t slot;        // in Contacts
  const Manifold* manifold;  // points relative to the origin of a's shape, world axes
  Material material;
};

struct StepView {
  const Config& config;
  Real h;            // length of a sub-step, s
  int substeps = 1;  // to be advanced by this call
  const Forces& forces;
  // Everything that moves or changes is in these lists, island after island; inside an island contacts lie in the order
  // of their pairs, bodies and joints in that of their slots.
  std::span<const Island> islands;
  std::span<const std::uint32_t> awake;  // dynamic bodies
  std::span<const ActiveContact> contacts;
  // Triangles that may become contacts within the step, without a slot and points; of solvers that look once a step.
  std::span<const ActiveContact> near;
  std::span<const std::uint32_t> joints;
  std::span<const std::uint32_t> smooth;  // awake ones for Runge–Kutta: no contacts, no joints
  std::span<const std::uint32_t> kinematic;
  std::span<const Geometry* const> geometries;  // by shape slot
  // What a solver advances.
  Bodies& bodies;
  Joints& joint_state;
  JointGraph& joint_graph;  // settled
  Contacts& contact_state;
  Pool& pool;
};

struct StepOutcome {
  struct Hit {
    std::uint32_t contact;  // number in the view
    Vec3 at;                // relative to a's centre of mass
    Real speed;             // of approach, m/s
  };
  std::vector<Hit> hits;              // in the order of contacts
  std::vector<std::uint32_t> broken;  // bodies that turned non-finite and were put back, ascending
  std::int64_t points = 0;            // solved in this sub-step
  Profile::Passes collision, contact, correction, joint;

  void clear() {
    hits.clear(), broken.clear();
    points = 0;
    collision = contact = correction = joint = {};
  }
  void add(const StepOutcome& other) {
    hits.insert(hits.end(), other.hits.begin(), other.hits.end());
    broken.insert(broken.end(), other.broken.begin(), other.broken.end());
    points += other.points;
    collision += other.collision, contact += other.contact, correction += other.correction, joint += other.joint;
  }
};

}
