#include "dynamics/reference_islands.h"

#include <numeric>

namespace sudar::inline SUDAR_PRECISION {

namespace {

// One body on what stays where it is or is carried, which rolls, slides, turns or has just come: what passes over contacts
// that are looked at once a step do worst. The reference costs five times as much, so that what is left of a crowd must have
// been alone for a while. At rest a body is held as well by either; and in what strikes at such a speed that contacts are not
// where they were, soft_step makes no energy (tests/issues/spinning_impact_test.cc).
bool acts_alone(const StepView& in, const Island& island) {
  constexpr std::uint32_t most_contacts = 4;
  if (island.bodies.count != 1 || island.contacts.count == 0 || island.contacts.count > most_contacts) return false;
  const auto contacts = island.contacts.of(in.contacts);
  const std::uint32_t body = island.bodies.of(in.awake).front();
  const Bodies& b = in.bodies;
  if (b.crowded_time[body] > 0) return false;
  const Real radius = b.radius[body], speed = length(b.velocity[body]);
  if (speed * in.h * Real(in.substeps) > radius) return false;
  if (speed + radius * length(b.spin[body]) > Real(0.05) * length(gravity(in.forces)) * in.h) return true;
  const auto began = [](const ActiveContact& c) { return (c.manifold->bits & Manifold::began) != 0; };
  return std::ranges::any_of(contacts, began);
}

}

void ReferenceIslands::watch_crowds(const StepView& in) {
  constexpr Real while_crowded = 1;  // s
  for (const Island& island : in.islands) {
    for (const std::uint32_t i : island.bodies.of(in.awake)) {
      Real& time = in.bodies.crowded_time[i];
      time = island.bodies.count > 1 ? while_crowded : max(Real(0), time - in.h * Real(in.substeps));
    }
  }
}

bool ReferenceIslands::belongs(const StepView& in, const Island& island) {
  constexpr std::size_t many = 1000;  // hold better by passes, but who has the time?
  const auto is_soft = [&](std::uint32_t j) {
    return std::holds_alternative<Ball>(in.joint_state.definition[j]) && in.joint_graph.component(j).joints.size() > many;
  };
  if (!std::ranges::all_of(island.joints.of(in.joints), is_soft)) return true;
  // Who attracts from afar is seen where it is at each sub-step: then all advance together.
  const bool afar = act_from_afar(in.forces);
  if (afar && !in.joints.empty()) return true;
  if (!afar && acts_alone(in, island)) return true;
  if (island.linked || in.smooth.empty()) return false;
  const std::uint32_t body = island.bodies.of(in.awake).front();
  return std::ranges::find(in.smooth, body) != in.smooth.end();
}

void ReferenceIslands::gather(const StepView& in) {
  islands_.clear(), awake_.clear(), joints_.clear(), seen_.clear(), pairs_.clear(), pairs_of_.clear(), geometries_.clear();
  const auto see = [&](const ActiveContact& contact, std::uint32_t number) {
    seen_.push_back({contact, number});
    PairRow& row = pairs_.emplace_back();
    const auto first = std::uint32_t(geometries_.size());
    row.key = {first, first + 1};  // by slot would fill lists as long as the world for a single pair
    geometries_.insert(geometries_.end(), {in.geometries[contact.shape_a], in.geometries[contact.shape_b]});
    row.part = contact.part;
    row.manifold = *contact.manifold;
  };
  for (const Island& island : in.islands) {
    if (!belongs(in, island)) continue;
    Island& own = islands_.emplace_back(island);
    own.bodies.first = std::uint32_t(awake_.size());
    pairs_of_.push_back({std::uint32_t(pairs_.size()), island.contacts.count + island.near.count});
    own.joints.first = std::uint32_t(joints_.size());
    const auto bodies = island.bodies.of(in.awake), joints = island.joints.of(in.joints);
    awake_.insert(awake_.end(), bodies.begin(), bodies.end());
    joints_.insert(joints_.end(), joints.begin(), joints.end());
    for (std::uint32_t c = island.contacts.first; c < island.contacts.first + island.contacts.count; ++c) see(in.contacts[c], c);
    for (const ActiveContact& contact : island.near.of(in.near)) see(contact, Seen::nowhere);
  }
  smooth_.assign(in.smooth.begin(), in.smooth.end());
  impulses_.impulse.assign(seen_.size(), {}), impulses_.slipping.assign(seen_.size(), 0);
  for (std::size_t k = 0; k < seen_.size(); ++k) {
    if (!seen_[k].in_view()) continue;
    impulses_.impulse[k] = in.contact_state.impulse[seen_[k].contact.slot];
    impulses_.slipping[k] = in.contact_state.slipping[seen_[k].contact.slot];
  }
}

void ReferenceIslands::look_again(const StepView& in) {
  poses_.clear();
  for (const Seen& seen : seen_) {
    for (const std::uint32_t s : {seen.contact.shape_a, seen.contact.shape_b}) poses_.push_back(in.bodies.shape_pose(s));
  }
  std::vector<std::uint32_t> all(pairs_.size());
  std::iota(all.begin(), all.end(), 0u);
  collide_pairs(pairs_, all, geometries_, poses_, in.config.impulse_2007.slop * in.config.length_unit);
  // The step's view looks farther ahead than the reference solver: what does not touch is no contact to it.
  contacts_.clear(), number_.clear();
  for (std::size_t i = 0; i < islands_.size(); ++i) {
    const auto first = std::uint32_t(contacts_.size());
    for (std::uint32_t k = pairs_of_[i].first; k < pairs_of_[i].first + pairs_of_[i].count; ++k) {
      if (pairs_[k].manifold.count == 0) {
        impulses_.impulse[k] = {};
        continue;
      }
      ActiveContact contact = seen_[k].contact;
      contact.slot = k, contact.manifold = &pairs_[k].manifold;
      contacts_.push_back(contact);
      number_.push_back(seen_[k].number);
    }
    islands_[i].contacts = {first, std::uint32_t(contacts_.size()) - first};
  }
}

// Impulses lie in the order of the last manifold's points; the pair remembers the first one's.
void ReferenceIslands::store_impulses(const StepView& in) {
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    if (!seen_[k].in_view()) continue;
    const ActiveContact& contact = seen_[k].contact;
    const Manifold &last = pairs_[k].manifold, &first = *contact.manifold;
    const ContactImpulse& own = impulses_.impulse[k];
    ContactImpulse ordered;
    ordered.turning = own.turning;
    for (std::size_t i = 0; i < std::size_t(first.count); ++i) {
      for (std::size_t j = 0; j < std::size_t(last.count); ++j) {
        if (first.points[i].feature != last.points[j].feature) continue;
        ordered.normal[i] = own.normal[j], ordered.friction[i] = own.friction[j];
      }
    }
    in.contact_state.impulse[contact.slot] = ordered;
    in.contact_state.slipping[contact.slot] = impulses_.slipping[k];
    in.contact_state.reference[contact.slot] = {.normal = {}, .carried = -1};  // soft_step begins anew with it
  }
}

bool ReferenceIslands::advance(const StepView& in, StepOutcome& out) {
  solver_.reserve(in.bodies.size());
  gather(in);
  if (islands_.empty()) return false;
  StepOutcome some;
  for (int n = 0; n < in.substeps; ++n) {
    some.clear();
    look_again(in);
    solver_.advance({.config = in.config,
                     .h = in.h,
                     .forces = in.forces,
                     .islands = islands_,
                     .awake = awake_,
                     .contacts = contacts_,
                     .near = {},
                     .joints = joints_,
                     .smooth = smooth_,
                     .kinematic = in.kinematic,
                     .geometries = in.geometries,
                     .bodies = in.bodies,
                     .joint_state = in.joint_state,
                     .joint_graph = in.joint_graph,
                     .contact_state = impulses_,
                     .pool = in.pool},
                    some);
    for (StepOutcome::Hit& hit : some.hits) hit.contact = number_[hit.contact];
    std::erase_if(some.hits, [](const StepOutcome::Hit& hit) { return hit.contact == Seen::nowhere; });  // told once it is one
    out.add(some);
  }
  store_impulses(in);
  return true;
}

}
