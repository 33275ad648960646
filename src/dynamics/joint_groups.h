// Joints that hang together by the bodies that they share, and the system that solves each such group at once. Groups
// are kept from sub-step to sub-step until joints come or go.
#pragma once

#include "dynamics/joint_solve.h"
#include "dynamics/joint_system.h"

namespace sudar::inline SUDAR_PRECISION {

struct JointGroup {
  std::vector<std::uint32_t> joints;  // numbers in the list
  std::vector<std::uint32_t> moving;  // bodies, fixed and kinematic ones too
  std::vector<std::uint32_t> dynamic;
  std::optional<JointSystem> system;  // none: too costly to solve at once
};

class JointGroups {
 public:
  void renew(const std::vector<JointSolve>& joints, const Bodies& bodies);
  std::vector<JointGroup>& all() { return groups_; }

 private:
  void regroup(const std::vector<JointSystem::Joint>& list, const std::vector<JointSolve>& joints, std::uint32_t slots);

  std::vector<JointSystem::Joint> list_;  // what the groups were made of
  std::vector<JointGroup> groups_;
};

// Fills `rows` with those of the group's joints, as its system takes them.
void rows_of(const JointGroup&, const std::vector<JointSolve>& joints, std::vector<std::span<const PreparedRow>>& rows);

}
