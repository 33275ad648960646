// sudar run: a scenario without a picture; its checks decide the exit code.
#include <cstdio>
#include <iostream>

#include "main/command.h"
#include "main/csv.h"
#include "main/interrupt.h"
#include "main/progress.h"
#include "main/recording.h"
#include "main/report.h"
#include "main/scene_options.h"

namespace sudar::app {

using namespace bench;

namespace {

constexpr std::int64_t most_steps = 1'000'000'000'000;

struct RunOptions {
  SceneOptions scene;
  std::optional<std::int64_t> steps;
  std::string csv, record, save, load;
  bool json = false;
};

// "FILE@STEP"
std::pair<std::string, std::int64_t> parse_save(const std::string& text) {
  const std::size_t at = text.rfind('@');
  if (at == 0 || at == std::string::npos) throw Error("--save", "\"" + text + "\" given, FILE@STEP expected");
  expect_writable(text.substr(0, at));
  return {text.substr(0, at), parse_whole("--save", text.substr(at + 1), 0, most_steps)};
}

// Two outputs in one file would spoil each other.
void expect_different_files(const RunOptions& o, const std::string& save) {
  const std::pair<const char*, std::string> outputs[] = {{"--csv", o.csv}, {"--record", o.record}, {"--save", save}};
  for (const auto& [option, file] : outputs) {
    for (const auto& [other, same] : outputs) {
      if (option != other && !file.empty() && file == same) throw Error(option, "names the file of " + std::string(other));
    }
  }
}

Session start(const RunOptions& o, const Catalogue& catalogue) {
  const Settings settings = o.scene.settings();
  if (o.load.empty()) return Session(catalogue.find(o.scene.scene), settings);
  if (!settings.set.empty()) throw Error("--set", "a saved run has its parameters already: leave out --set or --load");
  const std::string& name = catalogue.find(o.scene.scene).name;
  Session session =
      load_file(o.load, [&](const Bytes& bytes) { return Session::load(catalogue, bytes); });
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
  std::printf("%s: %lld steps, %.4g s simulated, %.1f µs a step (median), state %s, motion %s\n",
              session.entry().name, static_cast<long long>(w.steps()), w.time(), meter.step_us_median(),
              hex(w.hash()).c_str(), hex(w.motion_hash()).c_str());
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

void tell_interruption(const World& world, const std::vector<std::string>& files) {
  std::fprintf(stderr, "sudar: interrupted after step %lld, %.6g s", static_cast<long long>(world.steps()), world.time());
  for (const std::string& file : files) {
    if (!file.empty()) std::fprintf(stderr, "; %s holds it so far", file.c_str());
  }
  std::fputs("\n", stderr);
}

int run(const RunOptions& o, const Catalogue& catalogue) {
  Session session = start(o, catalogue);
  World& world = session.world();
  KeyScript keys(o.scene.keys);
  keys.skip(world.time() - session.dt());  // of a run that goes on
  std::pair<std::string, std::int64_t> save{"", -1};
  if (!o.save.empty()) save = parse_save(o.save);
  expect_different_files(o, save.first);
  const double end = o.scene.seconds.value_or(session.seconds());
  const auto done = [&] { return o.steps ? world.steps() >= *o.steps : world.time() >= end - 1e-9; };
  if (save.second >= 0 && world.steps() > save.second) {
    throw Error("--save",
                "step " + std::to_string(save.second) + " is over: the run starts at " + std::to_string(world.steps()));
  }
  std::optional<Csv> csv;
  if (!o.csv.empty()) csv.emplace(o.csv, world);
  std::optional<Recording> recording;
  if (!o.record.empty()) recording.emplace(o.record, world, session.entry().name);
  const Interrupt interrupt;
  Meter meter(world);
  Progress progress(session.entry().name, o.steps ? double(*o.steps) : end);
  const auto save_if_due = [&] {
    if (world.steps() == save.second) write_file(save.first, session.save());
  };
  save_if_due();
  while (!done() && !interrupt.wished()) {
    keys.apply(world.time(), session.input);
    session.step();
    meter.after_step(world);
    if (recording) recording->after_step();
    if (csv) csv->row(world);
    save_if_due();
    progress.show(o.steps ? double(world.steps()) : world.time());
  }
  if (world.steps() < save.second && !interrupt.wished()) {
    throw Error("--save", "step " + std::to_string(save.second) + " was not reached: the run ended at " +
                              std::to_string(world.steps()));
  }
  session.finish();
  if (csv) csv->finish();
  if (recording) recording->finish();
  progress.clear();
  if (o.json)
    std::cout << report(session, meter).dump(2) << '\n';
  else
    print(session, meter);
  if (!done()) {
    tell_interruption(world, {o.csv, o.record});
    return interrupted;
  }
  return nothing_failed(session.check()) ? 0 : 1;
}

}

void add_run(CLI::App& app, Action& chosen) {
  CLI::App* sub = app.add_subcommand("run", "run a scenario or a file without a window; exit 1 if a check fails");
  const auto o = std::make_shared<RunOptions>();
  sub->add_option("scene", o->scene.scene, "a name from sudar list, or a file (docs/files.md)")->required();
  o->scene.add_to(*sub);
  add_whole(*sub, "--steps", o->steps, 0, most_steps, "instead of --seconds")->excludes("--seconds");
  sub->add_option("--csv", o->csv, "write time, energies, positions, velocities and sensors of every step to FILE");
  sub->add_option("--record", o->record, "write a recording to FILE: for sudar replay and sudar render");
  sub->add_option("--save", o->save, "FILE@STEP: write the whole state after that step");
  sub->add_option("--load", o->load, "go on from a saved state");
  sub->add_flag("--json", o->json, "the result as JSON (docs/json.md)");
  sub->callback([&chosen, o] { chosen = [o](const Catalogue& c) { return run(*o, c); }; });
}

}
