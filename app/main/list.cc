// sudar list: the scenarios, with one line each, or all about them as JSON.
#include <cstdio>
#include <iostream>

#include "main/command.h"
#include "main/report.h"

namespace sudar::app {

namespace {

Json keys_of(const Scenario& scenario) {
  Json list = Json::array();
  for (const KeyHelp& k : scenario.keys()) list.push_back({{"key", k.key}, {"does", k.does}});
  return list;
}

Json parameters_of(Scenario& scenario) {
  Params params;
  scenario.params(params);
  const char* kinds[] = {"integer", "real", "boolean"};
  Json list = Json::array();
  for (const Params::Entry& p : params.entries()) {
    list.push_back({{"name", p.name},
                    {"kind", kinds[std::size_t(p.kind)]},
                    {"value", p.value},
                    {"low", p.low},
                    {"high", p.high},
                    {"about", p.about}});
  }
  return list;
}

// A plugin that makes none must not keep the others from the list.
ScenarioPointer make_or_tell(const ScenarioEntry& entry) {
  try {
    return make_scenario(entry);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "sudar: %s\n", e.what());
    return {nullptr, nullptr};
  }
}

int list(const Catalogue& catalogue, bool json) {
  if (json) {
    Json all = Json::array();
    for (const ScenarioEntry* e : catalogue.all()) {
      const ScenarioPointer scenario = make_or_tell(*e);
      if (!scenario) continue;
      all.push_back({{"name", e->name},
                     {"place", e->place},
                     {"about", e->about},
                     {"seconds", e->seconds},
                     {"parameters", parameters_of(*scenario)},
                     {"keys", keys_of(*scenario)}});
    }
    std::cout << all.dump(2) << '\n';
    return 0;
  }
  for (const ScenarioEntry* e : catalogue.all()) std::printf("%-16s %5g s  %s\n", e->name, e->seconds, e->about);
  return 0;
}

}

void add_list(CLI::App& app, Action& chosen) {
  CLI::App* sub = app.add_subcommand("list", "the scenarios, with one line each");
  const auto json = std::make_shared<bool>(false);
  sub->add_flag("--json", *json, "all about them, with their parameters");
  sub->callback([&chosen, json] { chosen = [json](const Catalogue& c) { return list(c, *json); }; });
}

}
