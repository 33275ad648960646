// The program: reads the command line, loads the scenarios, does what was chosen.
#include <CLI/CLI.hpp>

#include <cstdio>

#include "main/command.h"

using namespace sudar;
using namespace sudar::app;

namespace {

constexpr int bad_usage = 2;

int start(int argc, char** argv) {
  CLI::App app("Sudar: an impulse-based simulator of rigid bodies", "sudar");
  std::string scene, folder;
  Action chosen;
  app.set_version_flag("--version", std::string("sudar ") + SUDAR_VERSION + (sizeof(Real) == 4 ? " float" : " double"));
  app.add_option("--scenarios", folder, "folder of the scenario plugins; else $SUDAR_SCENARIOS or ../lib/scenarios");
  app.add_option("scene", scene, "without a sub-command: draw this scenario, or all, into out/");
  app.require_subcommand(0, 1);
  add_list(app, chosen);
  add_run(app, chosen);
  add_render(app, chosen);
  add_replay(app, chosen);
  add_bench(app, chosen);
  add_verify(app, chosen);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) { return app.exit(e) == 0 ? 0 : bad_usage; }
  const Plugins plugins(folder);
  for (const std::string& line : plugins.refused()) std::fprintf(stderr, "sudar: %s\n", line.c_str());
  return chosen ? chosen(plugins.catalogue()) : make_gallery(plugins.catalogue(), scene);
}

}

int main(int argc, char** argv) {
  try {
    return start(argc, argv);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "sudar: %s\n", e.what());
    return bad_usage;
  }
}
