// sudar replay: runs a recording again; with --check, compares every step and names the first difference.
#include <sudar/record.h>

#include <cstdio>

#include "main/command.h"
#include "main/files.h"
#include "main/interrupt.h"
#include "main/progress.h"
#include "main/report.h"
#include "main/scene_options.h"

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

struct Options {
  std::string file, workers;  // empty: one
  bool check = false;
};

int replay(const Options& o) {
  Config machine;
  if (!o.workers.empty()) set_field(machine, "workers", o.workers);
  const std::string& file = o.file;
  const bool check = o.check;
  Replay r = load_file(file, [&](Bytes bytes) { return Replay(std::move(bytes), machine.workers); });
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
  const auto o = std::make_shared<Options>();
  sub->add_option("file", o->file, "written by sudar run --record")->required();
  sub->add_flag("--check", o->check, "compare every step; exit 1 at the first difference, and name it");
  sub->add_option("--workers", o->workers, workers_help);
  sub->callback([&chosen, o] { chosen = [o](const Catalogue&) { return replay(*o); }; });
}

}
