// sudar replay: runs a recording again; with --check, compares every step and names the first difference.
#include <sudar/record.h>

#include <cstdio>

#include "main/command.h"
#include "main/files.h"
#include "main/interrupt.h"
#include "main/progress.h"
#include "main/report.h"

namespace sudar::app {

namespace {

std::string place_of(const Divergence& d, const World& world) {
  std::string text = "step " + std::to_string(d.step) + ", stage " + d.stage + ", ";
  if (!d.body.null()) {
    text += "body " + std::to_string(d.body.index);
    if (world.alive(d.body) && !world[d.body].name().empty()) text += " (" + world[d.body].name() + ")";
    text += ", ";
  }
  return text + "field " + d.field;
}

int replay(const std::string& file, bool check, const Catalogue&) {
  Replay r = load_file(file, [](Bytes bytes) { return Replay(std::move(bytes)); });
  const Interrupt interrupt;
  Progress progress(r.title(), double(r.steps()));
  std::optional<Divergence> divergence;
  while (!r.done() && !divergence && !interrupt.wished()) {
    divergence = r.step(check);
    progress.show(double(r.world().steps()));
  }
  progress.clear();
  if (divergence) {
    std::printf("%s: differs from the recording: %s\n", file.c_str(), place_of(*divergence, r.world()).c_str());
    return 1;
  }
  if (!r.done()) {
    std::fprintf(stderr, "sudar: interrupted after step %lld of %lld\n", static_cast<long long>(r.world().steps()),
                 static_cast<long long>(r.steps()));
    return interrupted;
  }
  if (r.cut_off()) std::printf("%s: was cut off, and ends with its last whole step\n", file.c_str());
  std::printf("%s: %s, %lld steps, %.4g s%s, state %s, motion %s\n", file.c_str(), r.title().c_str(),
              static_cast<long long>(r.steps()), r.world().time(), check ? ", every step as recorded" : "",
              hex(r.world().hash()).c_str(), hex(r.world().motion_hash()).c_str());
  return 0;
}

}

void add_replay(CLI::App& app, Action& chosen) {
  CLI::App* sub = app.add_subcommand("replay", "run a recording again");
  const auto file = std::make_shared<std::string>();
  const auto check = std::make_shared<bool>(false);
  sub->add_option("file", *file, "written by sudar run --record")->required();
  sub->add_flag("--check", *check, "compare every step; exit 1 at the first difference, and name it");
  sub->callback(
      [&chosen, file, check] { chosen = [file, check](const Catalogue& c) { return replay(*file, *check, c); }; });
}

}
