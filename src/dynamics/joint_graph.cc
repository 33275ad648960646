#include "dynamics/joint_graph.h"

#include <algorithm>

namespace sudar::inline SUDAR_PRECISION {

namespace {

constexpr std::int64_t most_cost = 100'000;  // multiplications of a factorisation: chains, trees, small nets

void tidy(std::vector<std::uint32_t>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

}

void JointGraph::add(const Joints& joints, std::uint32_t joint) {
  if (joint >= components_.size()) components_.resize(std::size_t(joint) + 1);
  for (const std::uint32_t body : {joints.a[joint], joints.b[joint]}) body_changed(body);
  links_.add(joint, joints.a[joint], joints.b[joint]);
  loose_.push_back(joint);
}

void JointGraph::remove(std::uint32_t joint) {
  dissolve(joint);
  links_.remove(joint);
}

// The joints of a body that answers are of one component, or all loose: one of them stands for all.
void JointGraph::body_changed(std::uint32_t body) {
  if (const std::uint32_t joint = links_.first(body); joint != Links::nobody) dissolve(joint);
}

void JointGraph::rebuild(const Joints& joints) {
  *this = {};
  for (std::uint32_t j = 0; j < joints.size(); ++j) {
    if (joints.slots.used(j)) add(joints, j);
  }
}

// All joints of its component have to look for each other again.
void JointGraph::dissolve(std::uint32_t joint) {
  const std::shared_ptr<JointComponent> whole = std::move(components_[joint]);
  if (!whole) return;
  for (const std::uint32_t j : whole->joints) {
    components_[j] = nullptr;
    loose_.push_back(j);
  }
}

void JointGraph::settle(const Joints& joints, const Bodies& bodies) {
  if (loose_.empty()) return;
  tidy(loose_);
  for (const std::uint32_t j : loose_) {
    if (joints.slots.used(j) && components_[j] == nullptr) gather(joints, bodies, j);
  }
  loose_.clear();
}

void JointGraph::gather(const Joints& joints, const Bodies& bodies, std::uint32_t joint) {
  const auto component = std::make_shared<JointComponent>();
  components_[joint] = component;
  component->joints.push_back(joint);
  for (std::size_t next = 0; next < component->joints.size(); ++next) {
    const std::uint32_t j = component->joints[next];
    for (const std::uint32_t body : {joints.a[j], joints.b[j]}) {
      if (body == no_body) continue;
      component->bodies.push_back(body);
      if (!bodies.dynamic(body)) continue;
      component->dynamic.push_back(body);
      links_.each(body, [&](std::uint32_t other) {
        if (components_[other] != nullptr) return;
        components_[other] = component;
        component->joints.push_back(other);
      });
    }
  }
  tidy(component->joints), tidy(component->bodies), tidy(component->dynamic);
  std::vector<JointSystem::Joint> list;
  const auto answers = [&](std::uint32_t i) { return i != no_body && bodies.dynamic(i) ? i : JointSystem::nobody; };
  for (const std::uint32_t j : component->joints) {
    list.push_back({answers(joints.a[j]), answers(joints.b[j]), rows_of(joints, bodies, j).count});
  }
  component->system = JointSystem::plan(list, most_cost);
}

}
