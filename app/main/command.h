// A sub-command of the program: a file of its own that adds its options to the command line and says what to do when it
// is chosen. What it does returns the exit code: 0 all is well, 1 a check failed; bad usage or input is thrown as
// Error.
#pragma once

#include <sudar/io.h>

#include <CLI/App.hpp>

#include <functional>

#include "main/plugins.h"

namespace sudar::app {

using Action = std::function<int(const Catalogue&)>;

// Each makes `chosen` its own action when its name stands on the command line.
void add_list(CLI::App&, Action& chosen);
void add_run(CLI::App&, Action& chosen);
void add_render(CLI::App&, Action& chosen);
void add_replay(CLI::App&, Action& chosen);
void add_diff(CLI::App&, Action& chosen);
void add_bench(CLI::App&, Action& chosen);
void add_verify(CLI::App&, Action& chosen);
// --allow and --unit, for sub-commands that open files.
void add_reading(CLI::App&, io::ReadOptions&);
void add_lint(CLI::App&, Action& chosen, io::ReadOptions&);
void add_convert(CLI::App&, Action& chosen, io::ReadOptions&);

// Without a sub-command and for that reason without a window: runs the scenario, or all of them, and draws a picture of
// each into out/.
int make_gallery(const Catalogue&, const std::string& scene, const std::string& reason);

}
