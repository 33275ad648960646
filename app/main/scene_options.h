// The options by which every sub-command that runs a scenario is told how.
#pragma once

#include <sudar/session.h>

#include <CLI/App.hpp>

#include "main/numbers.h"

namespace sudar::app {

inline constexpr const char* workers_help = "threads that share a step; changes no bit of the results";

struct SceneOptions {
  std::string scene;
  std::vector<std::string> set, config;                  // "name=value"
  std::string dt, substeps, workers, time_factor, solver, broad;  // short for --config; empty: not given
  bool no_sleep = false;
  std::optional<double> seconds;
  std::string keys;

  void add_to(CLI::App&);     // all but the scene itself
  Settings settings() const;  // throws Error naming the option
};

// {"ball=0", "rows=10"} of --set; true, on, false and off are 1 and 0.
std::map<std::string, double> parse_parameters(const std::vector<std::string>&);

// The names of an enumeration, for the help.
std::string choices(const char* const* names);

}
