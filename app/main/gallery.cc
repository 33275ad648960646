// sudar without a sub-command: every scenario is run with its checks and drawn once, at its telling moment, into out/.
#include <cstdio>
#include <filesystem>

#include "main/command.h"
#include "main/playback.h"
#include "main/progress.h"
#include "main/report.h"
#include "view/offscreen.h"

namespace sudar::app {

using namespace bench;
using namespace view;

namespace {

constexpr int width = 1280, height = 720;
constexpr const char* folder = "out";

struct Row {
  std::string file;
  std::int64_t steps;
  double seconds, us_per_step;
  int checks, failed;
};

Image draw(Offscreen& offscreen, const Playback& p) {
  const Scene scene = scene_of(p);
  const std::optional<Camera> own = p.camera();
  const Camera camera = own && !unset(*own) ? *own : framing(scene, double(width) / height);
  return offscreen.picture(scene, camera, {}, width, height);
}

Row run_and_draw(const ScenarioEntry& entry, Offscreen& offscreen, const std::function<void(double)>& progress) {
  Session session(entry);
  const std::unique_ptr<Playback> p = play(session);
  Meter meter(session.world());
  const std::string file = std::string(folder) + "/" + std::filesystem::path(entry.name).filename().string() + ".png";
  const auto run_to = [&](double time) {
    while (session.world().time() < time - 1e-9) {
      p->step();
      meter.after_step(session.world());
      progress(session.world().time());
    }
  };
  run_to(p->telling_moment());
  write_png(file, draw(offscreen, *p), provenance(*p));
  run_to(session.seconds());
  Row row{file, session.world().steps(), session.world().time(), meter.step_us_median(), 0, 0};
  for (const Check::Entry& c : session.finish().entries()) {
    row.checks += 1;
    row.failed += c.pass && !*c.pass ? 1 : 0;
  }
  return row;
}

}

int make_gallery(const Catalogue& catalogue, const std::string& scene, const std::string& reason) {
  std::vector<const ScenarioEntry*> entries = catalogue.all();
  if (!scene.empty()) entries = {&catalogue.find(scene)};
  std::printf("%s: drawing into the folder %s/ instead.\nSee sudar --help for what else there is.\n\n", reason.c_str(),
              folder);
  std::printf("scene              simulated    steps   µs/step  checks  picture\n");
  std::fflush(stdout);
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw Error(folder, "the folder cannot be made (" + error.message() + ")");
  Offscreen offscreen;
  double total = 0, before = 0;
  for (const ScenarioEntry* e : entries) total += e->seconds;
  int failed = 0;
  Progress progress("drawing", total);
  for (const ScenarioEntry* e : entries) {
    const Row row = run_and_draw(*e, offscreen, [&](double time) { progress.show(before + time); });
    before += e->seconds;
    failed += row.failed;
    progress.clear();
    const std::string checks = row.failed ? std::to_string(row.failed) + " FAILED" : std::to_string(row.checks) + " ok";
    std::printf("%-16s %9.4g s %8lld %9.1f %7s  %s\n", e->name, row.seconds, static_cast<long long>(row.steps),
                row.us_per_step, checks.c_str(), row.file.c_str());
    std::fflush(stdout);
  }
  return failed ? 1 : 0;
}

}
