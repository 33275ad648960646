#include "main/scene_options.h"

namespace sudar::app {

namespace {

std::pair<std::string, std::string> name_and_value(const std::string& option, const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size()) {
    throw Error(option, "\"" + text + "\" given, NAME=VALUE expected");
  }
  return {text.substr(0, equals), text.substr(equals + 1)};
}

double parameter(const std::string& name, const std::string& value) {
  if (value == "true" || value == "on") return 1;
  if (value == "false" || value == "off") return 0;
  return parse_number("--set " + name, value);
}

}

std::string choices(const char* const* names) {
  std::string text;
  for (; *names; ++names) text += (text.empty() ? "" : ", ") + std::string(*names);
  return text;
}

std::map<std::string, double> parse_parameters(const std::vector<std::string>& texts) {
  std::map<std::string, double> set;
  for (const std::string& text : texts) {
    const auto [name, value] = name_and_value("--set", text);
    set[name] = parameter(name, value);
  }
  return set;
}

void SceneOptions::add_to(CLI::App& app) {
  app.add_option("--set", set, "parameter of the scenario: NAME=VALUE; may be repeated")->allow_extra_args(false);
  app.add_option("--config", config,
                 "setting of the engine by its path: impulse_2007.contact_passes=20; may be repeated")
      ->allow_extra_args(false);
  app.add_option("--dt", dt, "length of a step, s");
  app.add_option("--substeps", substeps, "parts of a step");
  app.add_option("--workers", workers, workers_help);
  app.add_option("--time-factor", time_factor, "simulated seconds per second of a step");
  app.add_option("--solver", solver, choices(names(Solver{})));
  app.add_option("--broad", broad, choices(names(Broad{})));
  app.add_flag("--no-sleep", no_sleep, "compute bodies at rest, too");
  add_number(app, "--seconds", seconds, simulated_time, "simulated time; else the scenario's own");
  app.add_option("--keys", keys, "keys held from a time on: \"0:up+left 12.5:none\"");
}

Settings SceneOptions::settings() const {
  Settings s;
  s.set = parse_parameters(set);
  const std::pair<const char*, const std::string*> short_forms[] = {
      {"dt", &dt}, {"substeps", &substeps}, {"workers", &workers}, {"time_factor", &time_factor}, {"solver", &solver}, {"broad", &broad}};
  for (const auto& [path, value] : short_forms) {
    if (!value->empty()) s.config.emplace_back(path, *value);
  }
  if (no_sleep) s.config.emplace_back("sleep", "false");
  for (const std::string& text : config) s.config.push_back(name_and_value("--config", text));
  s.seconds = seconds;
  return s;
}

}
