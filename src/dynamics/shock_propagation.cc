#include "dynamics/shock_propagation.h"

#include "dynamics/levels.h"

namespace sudar::inline SUDAR_PRECISION {

namespace {

void freeze_lower(const SubStep& s, ManifoldRow& m, const std::vector<std::uint32_t>& level) {
  if (level[m.a] == level[m.b]) return;
  SolverBody a = s.on[m.a], b = s.on[m.b];
  SolverBody& lower = level[m.a] < level[m.b] ? a : b;
  lower.inverse_mass = 0, lower.inverse_inertia = {};
  m.mass_a = lanes(m.frame * a.inverse_mass), m.mass_b = lanes(m.frame * b.inverse_mass);
  for (PointRow& p : m.rows()) prepare_masses(p, transpose(m.frame), a, b);
  prepare_shared(m, a, b);
  if (m.resists_turning()) prepare_turning(m.turn, m.frame, a, b);
}

}

void propagate_shock(SubStep& s) {
  const std::vector<std::uint32_t> level = contact_levels(s.in.contacts, s.bodies);
  std::vector<ManifoldRow> frozen = s.rows;  // the warm start of the next sub-step is that of the whole pile
  std::vector<std::vector<ManifoldRow*>> by_level;
  for (ManifoldRow& m : frozen) {
    const std::uint32_t upper = max(level[m.a], level[m.b]);
    if (upper == no_level) continue;
    if (upper >= by_level.size()) by_level.resize(upper + 1);
    by_level[upper].push_back(&m);
  }
  constexpr int passes = 10;  // a level's own contacts; what lies below does not answer
  for (const std::vector<ManifoldRow*>& rows : by_level) {
    for (ManifoldRow* m : rows) freeze_lower(s, *m, level);
    for (int pass = 0; pass < passes; ++pass) {
      for (ManifoldRow* m : rows) {
        hold_together(s.on, 1, *m);
        push(s.on, *m, s.report.correction.visits);
      }
    }
  }
}

}
