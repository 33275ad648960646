// Who hangs together by joints. A component is made of joints that share bodies which answer impulses; it changes only
// when a joint comes or goes or a body ceases to answer, and so does what is planned for it.
#pragma once

#include <memory>

#include "base/links.h"
#include "dynamics/joint_system.h"
#include "dynamics/joints.h"

namespace sudar::inline SUDAR_PRECISION {

struct JointComponent {
  std::vector<std::uint32_t> joints;  // slots, ascending, like the bodies
  std::vector<std::uint32_t> bodies;  // all of them, fixed and kinematic ones too
  std::vector<std::uint32_t> dynamic;
  std::optional<JointSystem> system;  // by number in `joints`; none: too costly to solve at once
};

// A function of joints and bodies: no state. Told of every change; works out components when it is asked to settle.
class JointGraph {
 public:
  void add(const Joints&, std::uint32_t joint);
  void remove(std::uint32_t joint);
  void body_changed(std::uint32_t body);  // it will answer impulses no more, or has got a joint
  // Everything anew.
  void rebuild(const Joints&);

  // At a cost of what changed and what hangs on it.
  void settle(const Joints&, const Bodies&);
  // After settle(). Joints of one component answer with the same one.
  JointComponent& component(std::uint32_t joint) const { return *components_[joint]; }

  // The joints of a body: visit(joint).
  template <class Visit>
  void each_joint(std::uint32_t body, Visit visit) const {
    links_.each(body, visit);
  }
  std::uint32_t count(std::uint32_t body) const { return links_.count(body); }

 private:
  void dissolve(std::uint32_t joint);
  void gather(const Joints&, const Bodies&, std::uint32_t joint);

  Links links_;                                              // joints by body
  std::vector<std::shared_ptr<JointComponent>> components_;  // by joint; null: to be worked out
  std::vector<std::uint32_t> loose_;                         // joints to be looked at by settle()
};

}
