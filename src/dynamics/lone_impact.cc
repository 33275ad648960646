#include "dynamics/lone_impact.h"

#include "dynamics/collisions.h"
#include "dynamics/contact_prepare.h"
#include "dynamics/integrate.h"

namespace sudar::inline SUDAR_PRECISION {

namespace {

// Of what is dynamic, J, as who moves with the other one's surface sees it.
Real energy(const StepView& step, const ActiveContact& c) {
  const Bodies& b = step.bodies;
  const Pos at = b.shape_pose(c.shape_a).p + c.manifold->points[0].at;
  Vec3 surface;
  for (const std::uint32_t i : {c.a, c.b}) {
    if (b.motion[i] == Motion::kinematic) surface = b.velocity[i] + cross(b.spin[i], at - b.position[i]);
  }
  Real sum = 0;
  for (const std::uint32_t i : {c.a, c.b}) {
    if (b.dynamic(i))
      sum += b.mass[i] * length_squared(b.velocity[i] - surface) + dot(b.spin[i], b.angular_momentum[i]);
  }
  return sum / 2;
}

}

Real LoneImpact::strike(const StepView& step, const ActiveContact& given) {
  Bodies& b = step.bodies;
  const auto now = [&](std::uint32_t i) {
    return BodyMotion{b.position[i], b.orientation[i], b.velocity[i], b.angular_momentum[i]};
  };
  const BodyMotion a = now(given.a), c = now(given.b);
  const Real before = energy(step, given), speed = strike_as_is(step, given);
  if (energy(step, given) <= before * Real(1 + 1e-4)) return speed;
  if (b.dynamic(given.a)) place(b, given.a, a);
  if (b.dynamic(given.b)) place(b, given.b, c);
  ActiveContact smooth = given;
  smooth.material = {0, 0, 0, 0, 0};
  return strike_as_is(step, smooth);
}

Real LoneImpact::strike_as_is(const StepView& step, const ActiveContact& given) {
  Bodies& b = step.bodies;
  std::vector<std::uint32_t> dynamic, carried;
  for (const std::uint32_t i : {given.a, given.b}) {
    if (b.dynamic(i))
      dynamic.push_back(i);
    else if (b.motion[i] == Motion::kinematic)
      carried.push_back(i);
  }
  ActiveContact contact = given;
  contact.slot = 0;
  if (unknown_.slots.size() == 0) unknown_.add();
  const Island island{.bodies = {0, std::uint32_t(dynamic.size())}, .contacts = {0, 1}, .joints = {}, .near = {}, .linked = true};
  const StepView view{.config = step.config,
                      .h = step.h,
                      .forces = step.forces,
                      .islands = std::span(&island, 1),
                      .awake = dynamic,
                      .contacts = std::span(&contact, 1),
                      .near = {},
                      .joints = {},
                      .smooth = {},
                      .kinematic = carried,
                      .geometries = step.geometries,
                      .bodies = b,
                      .joint_state = step.joint_state,
                      .joint_graph = step.joint_graph,
                      .contact_state = unknown_,
                      .pool = step.pool};
  on_.reset(dynamic, carried, b.size());
  for (std::uint32_t n = 1; n < on_.size(); ++n) on_[n] = solver_body(b, on_.slot(n));
  StepOutcome out;
  SubStep s{.in = view,
            .island = island,
            .set = step.config.impulse_2007,
            .on = on_,
            .out = out,
            .rows = rows_,
            .starts = starts_,
            .pushes = pushes_,
            .turns = turns_,
            .joint_rows = joints_};
  joints_.clear();
  prepare_contacts(s);
  strike_contacts(s);
  Real speed = 0;
  for (std::size_t k = 0; k < rows_[0].count; ++k) {
    const ManifoldStart::Point& p = starts_[0].points[k];
    if (p.hit) speed = max(speed, -p.speed);
  }
  if (speed > 0) {
    for (const std::uint32_t i : dynamic) drift(b, i, on_[on_.number(i)], 0);
  }
  return speed;
}

}
