#include "main/report.h"

#include <charconv>
#include <cmath>
#include <cstdio>

namespace sudar::app {

using namespace bench;

namespace {

// A float gets its own shortest decimal form, instead of the digits that it gains on its way to double.
template <class T>
Json number(T v) {
  if (!std::isfinite(v)) return nullptr;
  if constexpr (std::is_same_v<T, float>) {
    char text[32];
    const auto [end, error] = std::to_chars(text, text + sizeof text, v);
    return std::strtod(std::string(text, end).c_str(), nullptr);
  }
  return v;
}

// Writes whatever has a describe().
struct JsonWriter {
  Json object = Json::object();

  template <class T, class R>
  void operator()(const char* name, const T& value, const R&) {
    object[name] = to_json(value);
  }
  template <class T>
  static Json to_json(const T& value) {
    if constexpr (std::is_enum_v<T>) {
      return names(value)[std::size_t(value)];
    } else if constexpr (std::is_floating_point_v<T>) {
      return number(value);
    } else if constexpr (std::is_arithmetic_v<T>) {
      return value;
    } else {
      JsonWriter nested;
      describe(nested, value);
      return nested.object;
    }
  }
};

Json parameter(const Params::Entry& p) {
  if (p.kind == Params::Kind::boolean) return p.value != 0;
  if (p.kind == Params::Kind::integer) return std::int64_t(p.value);
  // What was given for a Real comes back with the digits of a Real.
  return Real(p.value) == p.value ? number(Real(p.value)) : number(p.value);
}

Json verdict(const Check::Entry& c) {
  Json j{{"name", c.name}, {"op", c.op}, {"value", c.pass ? number(c.value) : nullptr}, {"limit", number(c.limit)}};
  if (c.op == "=") j["tolerance"] = number(c.tolerance);
  j["unit"] = c.unit;
  j["at"] = c.pass ? number(c.at) : nullptr;
  j["pass"] = c.pass ? Json(*c.pass) : nullptr;
  return j;
}

}

Json report(const Session& session, const Meter& meter) {
  const World& world = session.world();
  const Config& config = world.config();
  Json j;
  j["scenario"] = session.entry().name;
  j["engine"] = "sudar";
  j["parameters"] = Json::object();
  for (const Params::Entry& p : session.params()) j["parameters"][p.name] = parameter(p);
  j["config"] = JsonWriter::to_json(config);
  j["solver"] = names(config.solver)[std::size_t(config.solver)];
  j["broad"] = names(config.broad)[std::size_t(config.broad)];
  j["precision"] = sizeof(Real) == 4 ? "float" : "double";
  j["version"] = SUDAR_VERSION;
  j["dt"] = number(config.dt);
  j["substeps"] = config.substeps;
  j["workers"] = config.workers;
  j["steps"] = world.steps();
  j["seconds"] = number(world.time());
  j["bodies"] = world.bodies().size();
  j["joints"] = world.joints().size();
  j["contacts"] = number(meter.contacts_median());
  j["points"] = number(meter.points_median());
  j["awake"] = {{"min", number(meter.awake_min())}, {"median", number(meter.awake_median())}};
  j["us_per_step"] = {{"median", number(meter.step_us_median())}, {"min", number(meter.step_us_min())}};
  j["stages"] = Json::object();
  for (const Meter::Stage& s : meter.stages()) j["stages"][s.name] = number(s.microseconds);
  const auto passes = [](const bench::PassMeter& m) {
    return Json{{"used", number(m.used())}, {"us", number(m.us_per_step())}, {"ns_per_visit", number(m.ns_per_visit())}};
  };
  j["passes"] = {{"collision", passes(meter.collision())},
                 {"contact", passes(meter.contact())},
                 {"correction", passes(meter.correction())},
                 {"joint", passes(meter.joint())}};
  j["energy"] = {{"start", number(meter.energy_at_start().total())}, {"end", number(world.energy().total())}};
  const Quality mean = meter.mean(), worst = meter.worst();
  j["quality"] = {{"penetration", {{"max", number(worst.penetration_max)}, {"mean", number(mean.penetration_mean)}}},
                  {"joint_gap", {{"max", number(worst.joint_gap_max)}, {"mean", number(mean.joint_gap_mean)}}}};
  j["hash"] = hex(world.hash());
  j["motion_hash"] = hex(world.motion_hash());
  j["checks"] = Json::array();
  for (const Check::Entry& c : session.check().entries()) j["checks"].push_back(verdict(c));
  j["passed"] = nothing_failed(session.check());
  return j;
}

bool nothing_failed(const Check& check) {
  for (const Check::Entry& c : check.entries()) {
    if (c.pass && !*c.pass) return false;
  }
  return true;
}

std::string hex(std::uint64_t hash) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

std::string parameters_text(const Session& session) {
  std::string text;
  for (const Params::Entry& p : session.params()) {
    text += (text.empty() ? "" : " ") + p.name + "=" + parameter(p).dump();
  }
  return text;
}

}
