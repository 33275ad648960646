// Many bodies in a closed box that floats: nothing outside pushes them.
#include <algorithm>
#include <cmath>

#include "verify/cases/cases.h"
#include "verify/numerics.h"
#include "verify/scene.h"

namespace sudar::verify {

namespace {

// V36. Momentum of 200 bodies and the six slabs that hold them together.
void closed_box(Run& run) {
  const int n = int(run["bodies"]);
  const double steps = run["steps"], room = 6, thick = 1;
  World w(run.config());
  const Material m = material(0.3, run["restitution"]);
  std::vector<Body> slabs;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      Vec3 edges{Real(room + 2 * thick), Real(room + 2 * thick), Real(room + 2 * thick)};
      Vec3d at;
      edges[axis] = Real(thick), at[axis] = side * (room + thick) / 2;
      slabs.push_back(w.add({.shape = box(edges),
                             .at = Pos{} + at,
                             .mass = 50,
                             .material = m,
                             .filter = {.group = -1},
                             .motion = run.without("free walls") ? Motion::fixed : Motion::dynamic}));
      if (slabs.size() > 1 && !run.without("free walls"))
        w.join(Fixed{.a = slabs[0], .b = slabs.back(), .at = Pos{} + at});
    }
  }
  Random random{std::uint32_t(run["seed"])};
  const auto some = [&](double low, double high) { return Real(random.between(low, high)); };
  double linear = 0, angular = 0;  // Σ |p| and Σ |r| |p|
  for (int i = 0; i < n; ++i) {
    const Vec3 velocity{some(-3, 3), some(-3, 3), some(-3, 3)};
    const Pos at{i % 6 - 2.5, i / 6 % 6 - 2.5, i / 36 - 2.5};
    linear += double(length(velocity));
    angular += double(length(velocity)) * length(at - Pos{});
    w.add({.shape = i % 2 == 0 ? sphere(0.3) : box({0.5, 0.4, 0.6}),
           .at = at,
           .velocity = velocity,
           .spin = {some(-2, 2), some(-2, 2), some(-2, 2)},
           .mass = 1,
           .material = m});
  }
  const Momentum before = w.momentum();
  double worst = 0, worst_angular = 0;
  Plot& plot = run.plot("Momentum", "step", "|Δp| / Σ|p|");
  plot.theory = {{0, 0}, {steps, 0}};
  run.draw(w);
  while (double(w.steps()) < steps) {
    w.step();
    if (w.steps() % 20 != 0) continue;
    const Momentum now = w.momentum();
    worst = std::max(worst, length(now.linear - before.linear) / linear);
    worst_angular = std::max(worst_angular, length(now.angular - before.angular) / angular);
    plot.simulation.emplace_back(double(w.steps()), length(now.linear - before.linear) / linear);
  }
  run.draw(w);
  const double share = by_precision(1e-5, 1e-13);
  run.below("largest change of the momentum / Σ|p|", "1", worst, share);
  run.below("largest change of the angular momentum / Σ|r||p|", "1", worst_angular, share);
}

}

std::vector<Case> momentum() {
  return {{.id = "V36",
           .title = "Momentum in a closed box",
           .group = "Impacts",
           .formula = "Σ m v and Σ (m r × v + I ω) constant",
           .source = "Newton's third law",
           .parameters = {{"bodies", 200, 1, 216, whole_number},
                          {"steps", 10000, 10, 1e6, whole_number},
                          {"restitution", 0.8, 0, 1, "1"},
                          {"seed", 1, 0, 1e9, whole_number}},
           .sets = {{"inelastic", {{"restitution", 0}, {"steps", 2000}}}},
           .run = closed_box,
           .without = {"free walls"},
           .bite = {.values = {{"bodies", 60}, {"steps", 200}}},
           .effort = Effort::normal,
           .others = "ODE 1e-25 kg² m² s⁻² mean square, in double"}};
}

}
