#include "dynamics/joint_groups.h"

#include <algorithm>

#include "dynamics/islands.h"

namespace sudar::inline SUDAR_PRECISION {

namespace {

constexpr std::int64_t most_cost = 100'000;  // multiplications: chains, trees, small nets

}

void JointGroups::renew(const std::vector<JointSolve>& joints, const Bodies& bodies) {
  std::vector<JointSystem::Joint> list;
  const auto answers = [&](std::uint32_t i) { return i != no_body && bodies.dynamic(i) ? i : JointSystem::nobody; };
  for (const JointSolve& j : joints) list.push_back({answers(j.a), answers(j.b), int(j.rows().size())});
  if (list != list_) regroup(list, joints, bodies.size());
  list_ = std::move(list);
}

void JointGroups::regroup(const std::vector<JointSystem::Joint>& list, const std::vector<JointSolve>& joints,
                          std::uint32_t slots) {
  Islands islands;
  islands.reset(slots);
  for (const JointSystem::Joint& j : list) {
    if (j.a != JointSystem::nobody && j.b != JointSystem::nobody) islands.unite(j.a, j.b);
  }
  groups_.clear();
  constexpr std::uint32_t none = 0xffffffffu;
  std::vector<std::uint32_t> group_of(slots, none);
  for (std::uint32_t k = 0; k < list.size(); ++k) {
    const std::uint32_t some = list[k].a != JointSystem::nobody ? list[k].a : list[k].b;
    std::uint32_t& group = group_of[islands.root(some)];
    if (group == none) group = std::uint32_t(groups_.size()), groups_.emplace_back();
    JointGroup& g = groups_[group];
    g.joints.push_back(k);
    for (const std::uint32_t i : {joints[k].a, joints[k].b}) {
      if (i != no_body) g.moving.push_back(i);
    }
    for (const std::uint32_t i : {list[k].a, list[k].b}) {
      if (i != JointSystem::nobody) g.dynamic.push_back(i);
    }
  }
  const auto tidy = [](std::vector<std::uint32_t>& bodies) {
    std::sort(bodies.begin(), bodies.end());
    bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
  };
  for (JointGroup& g : groups_) {
    tidy(g.moving), tidy(g.dynamic);
    std::vector<JointSystem::Joint> own;
    for (const std::uint32_t k : g.joints) own.push_back(list[k]);
    g.system = JointSystem::plan(own, most_cost);
  }
}

void rows_of(const JointGroup& g, const std::vector<JointSolve>& joints,
             std::vector<std::span<const PreparedRow>>& rows) {
  rows.clear();
  for (const std::uint32_t k : g.joints) rows.push_back(joints[k].rows());
}

}
