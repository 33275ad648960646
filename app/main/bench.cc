// sudar bench: what the scenes cost, beside the thesis's prototype. States figures and judges nothing.
#include <algorithm>
#include <cstdio>
#include <iostream>

#include "bench/thesis.h"
#include "main/command.h"
#include "main/numbers.h"
#include "main/picture_bench.h"
#include "main/progress.h"
#include "main/report.h"

namespace sudar::app {

using namespace bench;

namespace {

struct BenchOptions {
  std::vector<std::string> scenes;
  bool thesis = false, picture = false, json = false;
  int repeat = 1, bodies = 2000;
};

std::vector<ThesisCase> chosen_cases(const BenchOptions& o, const Catalogue& catalogue) {
  const std::span<const ThesisCase> all = thesis_cases();
  if (o.scenes.empty()) return {all.begin(), all.end()};
  std::vector<ThesisCase> cases;
  for (const std::string& scene : o.scenes) {
    const std::size_t before = cases.size();
    std::copy_if(all.begin(), all.end(), std::back_inserter(cases),
                 [&](const ThesisCase& c) { return c.scene == scene; });
    if (cases.size() > before) continue;
    const ScenarioEntry& entry = catalogue.find(scene);
    if (o.thesis) throw Error(scene, "the prototype's speed in this scene is not known: leave out --thesis");
    cases.push_back({entry.name, entry.name, {}, {}});
  }
  return cases;
}

// Our time by the prototype's: below 1 we are faster. Only where that is known.
double ratio(const ThesisCase& c, const ThesisResult& r) { return r.meter.step_us_median() / *c.prototype_us; }

// Right-aligned in so many columns; a dash where there is no number.
std::string cell(std::optional<double> number, int width, int digits) {
  char text[32];
  if (number) std::snprintf(text, sizeof text, "%*.*f", width, digits, *number);
  else std::snprintf(text, sizeof text, "%*s", width, "-");
  return text;
}

Json with_prototype(const ThesisCase& c, const ThesisResult& r) {
  Json j = report(r.session, r.meter);
  if (c.prototype_us) {
    j["prototype"] = {{"title", c.title}, {"us_per_step", *c.prototype_us}, {"ratio", ratio(c, r)}};
  }
  return j;
}

int bench_picture(const BenchOptions& o) {
  const PictureCost c = measure_pictures(o.bodies, 1280, 720);
  if (o.json) {
    const auto picture = [](const PictureCost::Picture& p) { return Json{{"ms", p.ms}, {"cpu_ms", p.cpu_ms}}; };
    const Json j = {{"driver", c.driver},
                    {"width", c.width},
                    {"height", c.height},
                    {"bodies", c.bodies},
                    {"plain", picture(c.plain)},
                    {"fine", picture(c.fine)},
                    {"step_us", {{"alone", c.alone_us}, {"beside", c.beside_us}}},
                    {"step_clock_us", {{"alone", c.alone_clock_us}, {"beside", c.beside_clock_us}}}};
    std::cout << j.dump(2) << '\n';
    return 0;
  }
  std::printf("%zu bodies with shadows, %d × %d, %s\n", c.bodies, c.width, c.height, c.driver.c_str());
  const auto line = [](const char* name, const PictureCost::Picture& p) {
    std::printf("picture, %-6s %6.1f ms (%.1f ms of all cores): %.1f a second\n", name, p.ms, p.cpu_ms, 1e3 / p.ms);
  };
  line("plain", c.plain), line("fine", c.fine);
  std::printf("step alone %.0f µs (%.0f µs by the clock), beside pictures %.0f µs (%.0f µs by the clock)\n", c.alone_us,
              c.alone_clock_us, c.beside_us, c.beside_clock_us);
  return 0;
}

int bench(const BenchOptions& o, const Catalogue& catalogue) {
  if (o.picture) return bench_picture(o);
  const std::vector<ThesisCase> cases = chosen_cases(o, catalogue);
  const int each = o.repeat * (warm_up_steps + measured_steps);
  Progress progress("bench", double(each) * double(cases.size()));
  Json all = Json::array();
  if (!o.json) {
    std::printf(
        "median of %d steps after %d, sleeping off, one thread; prototype: Java, 2007.\n"
        "Ratio: our time by the prototype's, less is better; below 1 we are faster than it.\n"
        "Passes: those used for impacts + contacts + correction of positions. Times: of a point in a pass of the contacts,\n"
        "of a joint in a pass, of all impacts in a step.\n\n"
        "scene             bodies joints contacts points    µs/step prototype  ratio       passes  ns/point ns/joint µs/impacts\n",
        measured_steps, warm_up_steps);
  }
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const ThesisCase& c = cases[i];
    const ThesisResult r = measure(c, catalogue, o.repeat, [&](int done) { progress.show(double(i) * each + done); });
    const World& w = r.session.world();
    progress.clear();
    if (o.json) {
      all.push_back(with_prototype(c, r));
      continue;
    }
    std::printf("%-17s %6zu %6zu %8.0f %6.0f %10.1f %s %s %4.0f + %2.0f + %2.0f %9.1f %8.1f %10.1f\n", c.title, w.bodies().size(),
                w.joints().size(), r.meter.contacts_median(), r.meter.points_median(), r.meter.step_us_median(),
                cell(c.prototype_us, 9, 0).c_str(),
                cell(c.prototype_us ? std::optional(ratio(c, r)) : std::nullopt, 6, 2).c_str(), r.meter.collision().used(),
                r.meter.contact().used(), r.meter.correction().used(), r.meter.contact().ns_per_visit(), r.meter.joint().ns_per_visit(),
                r.meter.collision().us_per_step());
    std::fflush(stdout);
  }
  if (o.json) std::cout << all.dump(2) << '\n';
  return 0;
}

}

void add_bench(CLI::App& app, Action& chosen) {
  CLI::App* sub = app.add_subcommand("bench", "measure the speed: µs a step, less is better");
  const auto o = std::make_shared<BenchOptions>();
  sub->add_option("scenes", o->scenes, "only these, any of sudar list; else those of --thesis");
  sub->add_flag("--thesis", o->thesis, "only scenes whose speed the thesis's prototype is known for");
  sub->add_flag("--picture", o->picture, "a picture of many bodies, and the physics thread beside it");
  add_whole(*sub, "--bodies", o->bodies, 1, 100000, "of the picture")->default_str("2000");
  add_whole(*sub, "--repeat", o->repeat, 1, 1000, "runs of each scene; the fastest counts")->default_str("1");
  sub->add_flag("--json", o->json, "the results as JSON (docs/json.md)");
  sub->callback([&chosen, o] { chosen = [o](const Catalogue& c) { return bench(*o, c); }; });
}

}
