// The program: reads the command line, loads the scenarios, does what was chosen.
#include <CLI/CLI.hpp>

#include <csignal>
#include <cstdio>

#include "main/command.h"
#include "main/scene_options.h"
#include "view/renderer.h"
#ifdef SUDAR_WINDOW
#include "ui/app.h"
#endif

using namespace sudar;
using namespace sudar::app;

namespace {

constexpr int bad_usage = 2;

struct WindowOptions {
  std::string scene, size = "1280x720", quality = "auto", status;
};

// The window, or why there is none.
std::optional<int> open_window(const Catalogue& catalogue, const WindowOptions& o, std::string& reason) {
#ifdef SUDAR_WINDOW
  if (!std::getenv("DISPLAY") && !std::getenv("WAYLAND_DISPLAY")) {
    reason = "There is no display here";
    return {};
  }
  const auto [width, height] = parse_size(o.size);
  try {
    std::optional<view::Finish> quality;
    if (o.quality != "auto") quality = o.quality == "fine" ? view::Finish::fine : view::Finish::plain;
    return ui::run_window(catalogue, {o.scene, width, height, quality, o.status});
  } catch (const Error& e) {
    if (e.field != "window") throw;
    reason = std::string("No ") + e.what();
    return {};
  }
#else
  static_cast<void>(catalogue), static_cast<void>(o);
  reason = "This program was built without its window";
  return {};
#endif
}

// `--dt ""` of a script whose variable is empty means something else than no --dt.
void expect_no_empty_value(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i], before = argv[i - 1];
    const bool option = word.rfind("--", 0) == 0;
    if (option && word.back() == '=') throw Error(word.substr(0, word.size() - 1), "is given without a value");
    if (!word.empty()) continue;
    const bool value = before.rfind('-', 0) == 0;
    throw Error(value ? before : "argument " + std::to_string(i), "is given, but empty");
  }
}

int start(int argc, char** argv) {
  CLI::App app("Sudar: an impulse-based simulator of rigid bodies", "sudar");
  std::string folder;
  WindowOptions window;
  Action chosen;
  app.set_version_flag("--version", std::string("sudar ") + SUDAR_VERSION + (sizeof(Real) == 4 ? " float" : " double"));
  app.add_option("--scenarios", folder, "folder of the scenario plugins; else $SUDAR_SCENARIOS, or those that came with the program");
  app.add_option(
      "scene", window.scene,
      "without a sub-command: open the window on this scenario or file; without a display draw it, or all, into out/");
  app.add_option("--size", window.size, "WIDTHxHEIGHT of the window")->capture_default_str()->each([](const std::string& s) { parse_size(s); });
  app.add_option("--quality", window.quality, "of the window's picture; auto: as the machine can")
      ->check(CLI::IsMember({"auto", "plain", "fine"}));
  app.add_option("--status", window.status, "a file in which the window tells its state as JSON, for scripts");
  app.require_subcommand(0, 1);
  add_list(app, chosen);
  add_run(app, chosen);
  add_render(app, chosen);
  add_replay(app, chosen);
  add_diff(app, chosen);
  add_bench(app, chosen);
  add_verify(app, chosen);
  io::ReadOptions reading;
  add_lint(app, chosen, reading);
  add_convert(app, chosen, reading);
  for (CLI::App* opens : {&app, app.get_subcommand("run"), app.get_subcommand("render")}) add_reading(*opens, reading);
  expect_no_empty_value(argc, argv);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) { return app.exit(e) == 0 ? 0 : bad_usage; }
  io::FileScenes files(reading, [](const io::Finding& f) {  // before what it opens for
    if (f.severity == io::Severity::warning) std::fprintf(stderr, "sudar: %s\n", io::text(f).c_str());
  });
  Plugins plugins(folder);
  plugins.open_with([&files](std::string_view name) { return files.open(name); });
  for (const std::string& line : plugins.refused()) std::fprintf(stderr, "sudar: %s\n", line.c_str());
  if (chosen) return chosen(plugins.catalogue());
  std::string reason;
  const std::optional<int> code = open_window(plugins.catalogue(), window, reason);
  return code ? *code : make_gallery(plugins.catalogue(), window.scene, reason);
}

}

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file over its limit shows as a failed write
  try {
    return start(argc, argv);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "sudar: %s\n", e.what());
    return bad_usage;
  }
}
