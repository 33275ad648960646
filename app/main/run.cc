// sudar run: a scenario without a picture; its checks decide the exit code.
#include <sudar/record.h>

#include <cstdio>
#include <iostream>

#include "main/command.h"
#include "main/csv.h"
#include "main/progress.h"
#include "main/report.h"
#include "main/scene_options.h"

namespace sudar::app {

using namespace bench;

namespace {

struct RunOptions {
  SceneOptions scene;
  std::optional<std::int64_t> steps;
  std::string csv, record, save, load;
  bool json = false;
};

// "FILE@STEP"
std::pair<std::string, std::int64_t> parse_save(const std::string& text) {
  const std::size_t at = text.rfind('@');
  const double step = at == std::string::npos ? -1 : parse_number("--save", text.substr(at + 1));
  if (at == 0 || step < 0 || step != double(std::int64_t(step))) {
    throw Error("--save", "\"" + text + "\" given, FILE@STEP expected");
  }
  return {text.substr(0, at), std::int64_t(step)};
}

Session start(const RunOptions& o, const Catalogue& catalogue) {
  const Settings settings = o.scene.settings();
  if (o.load.empty()) return Session(catalogue.find(o.scene.scene), settings);
  if (!settings.set.empty()) throw Error("--set", "a saved run has its parameters already: leave out --set or --load");
  const std::string& name = catalogue.find(o.scene.scene).name;
  Session session = Session::load(catalogue, read_file(o.load));
  if (session.entry().name != name) {
    throw Error(o.load, std::string("holds a run of ") + session.entry().name + ", not of " + name);
  }
  if (!settings.config.empty()) {
    Config config = session.world().config();
    for (const auto& [path, value] : settings.config) set_field(config, path, value);
    session.world().set_config(config);
  }
  return session;
}

void print(const Session& session, const Meter& meter) {
  const World& w = session.world();
  std::printf("%s: %lld steps, %.4g s simulated, %.1f µs a step (median), state %s\n", session.entry().name,
              static_cast<long long>(w.steps()), w.time(), meter.step_us_median(), hex(w.hash()).c_str());
  for (const Check::Entry& c : session.check().entries()) {
    std::printf("  %s  %s", !c.pass ? "later " : *c.pass ? "ok    " : "FAILED", c.name.c_str());
    if (c.pass && c.op != "holds") {
      std::printf(": %.6g %s %.6g", c.value, c.op.c_str(), c.limit);
      if (c.op == "=") std::printf(" ± %.3g", c.tolerance);
      std::printf(" %s", c.unit.c_str());
    }
    std::printf(c.pass ? " (at %.4g s)\n" : "\n", c.at);
  }
}

int run(const RunOptions& o, const Catalogue& catalogue) {
  Session session = start(o, catalogue);
  World& world = session.world();
  KeyScript keys(o.scene.keys);
  keys.skip(world.time() - session.dt());  // of a run that goes on
  std::pair<std::string, std::int64_t> save{"", -1};
  if (!o.save.empty()) save = parse_save(o.save);
  std::optional<Csv> csv;
  if (!o.csv.empty()) csv.emplace(o.csv, world);
  std::optional<Recorder> recorder;
  if (!o.record.empty()) recorder.emplace(world, session.entry().name);

  const double end = o.scene.seconds.value_or(session.seconds());
  const auto done = [&] { return o.steps ? world.steps() >= *o.steps : world.time() >= end - 1e-9; };
  if (save.second >= 0 && world.steps() > save.second) {
    throw Error("--save",
                "step " + std::to_string(save.second) + " is over: the run starts at " + std::to_string(world.steps()));
  }
  Meter meter(world);
  Progress progress(session.entry().name, o.steps ? double(*o.steps) : end);
  const auto save_if_due = [&] {
    if (world.steps() == save.second) write_file(save.first, session.save());
  };
  save_if_due();
  while (!done()) {
    keys.apply(world.time(), session.input);
    session.step();
    meter.after_step(world);
    if (recorder) recorder->after_step();
    if (csv) csv->row(world);
    save_if_due();
    progress.show(o.steps ? double(world.steps()) : world.time());
  }
  if (world.steps() < save.second) {
    throw Error("--save", "step " + std::to_string(save.second) + " was not reached: the run ended at " +
                              std::to_string(world.steps()));
  }
  session.finish();
  if (csv) csv->finish();
  if (recorder) write_file(o.record, recorder->bytes());
  progress.clear();
  if (o.json)
    std::cout << report(session, meter).dump(2) << '\n';
  else
    print(session, meter);
  return nothing_failed(session.check()) ? 0 : 1;
}

}

void add_run(CLI::App& app, Action& chosen) {
  CLI::App* sub = app.add_subcommand("run", "run a scenario without a window; exit 1 if a check fails");
  const auto o = std::make_shared<RunOptions>();
  sub->add_option("scene", o->scene.scene, "a name from sudar list")->required();
  o->scene.add_to(*sub);
  sub->add_option("--steps", o->steps, "instead of --seconds")->check(CLI::NonNegativeNumber)->excludes("--seconds");
  sub->add_option("--csv", o->csv, "write time, energies, positions, velocities and sensors of every step to FILE");
  sub->add_option("--record", o->record, "write a recording to FILE: for sudar replay and sudar render");
  sub->add_option("--save", o->save, "FILE@STEP: write the whole state after that step");
  sub->add_option("--load", o->load, "go on from a saved state");
  sub->add_flag("--json", o->json, "the result as JSON (docs/json.md)");
  sub->callback([&chosen, o] { chosen = [o](const Catalogue& c) { return run(*o, c); }; });
}

}
