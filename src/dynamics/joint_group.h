// The components of the joint graph as an island's solver meets them.
#pragma once

#include <algorithm>

#include "dynamics/sub_step.h"

namespace sudar::inline SUDAR_PRECISION {

struct JointGroup {
  JointComponent* component;
  std::vector<std::uint32_t> joints;  // numbers in SubStep::joint_rows, in the component's order
};

// Those of the island, in the order of their first joints.
inline std::vector<JointGroup> joint_groups(const SubStep& s) {
  std::vector<JointGroup> groups;
  const std::span<const std::uint32_t> slots = s.island.joints.of(s.in.joints);
  for (const std::uint32_t first : slots) {
    JointComponent& component = s.in.joint_graph.component(first);
    if (component.joints.front() != first) continue;  // met before
    groups.push_back({&component, {}});
    for (const std::uint32_t j : component.joints) {
      groups.back().joints.push_back(std::uint32_t(std::ranges::lower_bound(slots, j) - slots.begin()));
    }
  }
  return groups;
}

// Fills `rows` with those of the group's joints, as the component's system takes them.
inline void rows_of(const JointGroup& group, const std::vector<JointSolve>& joints,
                    std::vector<std::span<const PreparedRow>>& rows) {
  rows.clear();
  for (const std::uint32_t k : group.joints) rows.push_back(joints[k].rows());
}

}
