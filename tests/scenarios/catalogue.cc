#include "scenarios/catalogue.h"

#include <sstream>

#include "main/plugins.h"

namespace sudar::inline SUDAR_PRECISION {

const Catalogue& scenarios() {
  static const app::Plugins plugins("");
  if (!plugins.refused().empty()) throw Error("scenarios", plugins.refused().front());
  return plugins.catalogue();
}

const std::vector<Variant>& variants() {
  static const std::vector<Variant> all = {
      {"wall", "stands_for_a_minute", {.set = {{"ball", 0}}, .seconds = 60}},
      {"friction", "slides_at_0.560", {.set = {{"friction", 0.56}}}},
      {"friction", "slides_at_0.575", {.set = {{"friction", 0.575}}}},
      {"friction", "holds_at_0.580", {.set = {{"friction", 0.58}}}},
      {"train", "holds_at_660", {.set = {{"force", 660}}}},
      {"train", "slides_at_690", {.set = {{"force", 690}}}},
      {"rotor", "throws_at_0.25", {.set = {{"friction", 0.25}}}},
      {"suspension_bridge", "hangs_with_slack", {.set = {{"slack", 3}}}},
      {"vehicle", "drives_over_the_bridge", {.set = {{"driver", 1}}}},
      {"vehicle", "turns_in_circles", {.set = {{"driver", 2}}}},
      {"arch", "folds_at_0.105", {.set = {{"thickness", 0.105}}}},
      {"arch", "stands_at_0.110", {.set = {{"thickness", 0.11}}}},
      {"solar_system", "keeps_a_circle_for_1000_orbits", {.set = {{"planets", 1}, {"fixed_sun", 1}}, .seconds = 7.6e9}},
  };
  return all;
}

std::string text(const Check::Entry& e) {
  std::ostringstream out;
  out << e.name << ": " << e.value << " " << e.op << " " << e.limit;
  if (e.tolerance > 0) out << " ± " << e.tolerance;
  out << " " << e.unit << " at " << e.at << " s";
  return out.str();
}

}
