#include "scenarios/catalogue.h"

#include <sstream>

#include "main/plugins.h"

namespace sudar::inline SUDAR_PRECISION {

const Catalogue& scenarios() {
  static const app::Plugins plugins("");
  if (!plugins.refused().empty()) throw Error("scenarios", plugins.refused().front());
  return plugins.catalogue();
}

std::string text(const Check::Entry& e) {
  std::ostringstream out;
  out << e.name << ": " << e.value << " " << e.op << " " << e.limit;
  if (e.tolerance > 0) out << " ± " << e.tolerance;
  out << " " << e.unit << " at " << e.at << " s";
  return out.str();
}

}
