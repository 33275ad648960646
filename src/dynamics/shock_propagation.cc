#include "dynamics/shock_propagation.h"

#include "dynamics/levels.h"

namespace sudar::inline SUDAR_PRECISION {

namespace {

void renew_masses(SubStep& s, std::size_t k) {
  ManifoldRow& m = s.rows[k];
  const SolverBody &a = s.on[m.a], &b = s.on[m.b];
  m.a_answers = a.answers(), m.b_answers = b.answers();
  prepare_response(m, a, b);
  for (PointRow& p : m.rows()) prepare_masses(m, p);
  if (m.resists_turning) prepare_turning(s.turns[k], m);
}

}

void propagate_shock(SubStep& s) {
  const auto answers = [&](std::uint32_t body) { return s.on[body].answers(); };
  const std::vector<std::uint32_t> level = contact_levels(std::span<const ManifoldRow>(s.rows), answers);
  std::vector<std::vector<std::uint32_t>> by_level;  // contacts by that of their upper body
  for (std::uint32_t k = 0; k < s.rows.size(); ++k) {
    const std::uint32_t upper = max(level[s.rows[k].a], level[s.rows[k].b]);
    if (upper == no_level) continue;
    if (upper >= by_level.size()) by_level.resize(upper + 1);
    by_level[upper].push_back(k);
  }
  const auto freeze = [&](std::uint32_t body) {
    if (body == SolverBodies::still || !s.on[body].answers()) return;
    s.on[body].inverse_mass = 0, s.on[body].inverse_inertia = Mat3Lanes{};
  };
  constexpr int passes = 10;  // a level's own contacts; what lies below does not answer
  for (const std::vector<std::uint32_t>& contacts : by_level) {
    for (const std::uint32_t k : contacts) {
      const ManifoldRow& m = s.rows[k];
      if (level[m.a] != level[m.b]) freeze(level[m.a] < level[m.b] ? m.a : m.b);
    }
    for (const std::uint32_t k : contacts) renew_masses(s, k);
    for (int pass = 0; pass < passes; ++pass) {
      for (const std::uint32_t k : contacts) {
        hold_together(std::array{Holding(s.on, s.rows[k], s.turn(k), 1)}, 1);
        separate(s.on, s.rows[k], s.pushes[k], s.out.correction.visits);
      }
    }
  }
}

}
