// sudar bench: what the scenes cost, beside the thesis's prototype. States figures and judges nothing.
#include <algorithm>
#include <cstdio>
#include <iostream>

#include "bench/thesis.h"
#include "main/command.h"
#include "main/progress.h"
#include "main/report.h"

namespace sudar::app {

using namespace bench;

namespace {

struct BenchOptions {
  std::vector<std::string> scenes;
  bool thesis = false, json = false;
  int repeat = 1;
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
    catalogue.find(scene);  // throws where there is no such scene at all
    throw Error(scene, "the prototype's speed in this scene is not known");
  }
  return cases;
}

Json with_prototype(const ThesisCase& c, const ThesisResult& r) {
  Json j = report(r.session, r.meter);
  j["prototype"] = {
      {"title", c.title}, {"us_per_step", c.prototype_us}, {"ratio", r.meter.step_us_median() / c.prototype_us}};
  return j;
}

int bench(const BenchOptions& o, const Catalogue& catalogue) {
  if (!o.thesis) throw Error("bench", "say what to measure: --thesis");
  const std::vector<ThesisCase> cases = chosen_cases(o, catalogue);
  const int each = o.repeat * (warm_up_steps + measured_steps);
  Progress progress("bench", double(each) * double(cases.size()));
  Json all = Json::array();
  if (!o.json) {
    std::printf(
        "median of %d steps after %d, sleeping off, one thread; prototype: Java, 2007.\n"
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
    std::printf("%-17s %6zu %6zu %8.0f %6.0f %10.1f %9.0f %6.2f %4.0f + %2.0f + %2.0f %9.1f %8.1f %10.1f\n", c.title, w.bodies().size(),
                w.joints().size(), r.meter.contacts_median(), r.meter.points_median(), r.meter.step_us_median(),
                c.prototype_us, r.meter.step_us_median() / c.prototype_us, r.meter.collision().used(),
                r.meter.contact().used(), r.meter.correction().used(), r.meter.contact().ns_per_visit(), r.meter.joint().ns_per_visit(),
                r.meter.collision().us_per_step());
    std::fflush(stdout);
  }
  if (o.json) std::cout << all.dump(2) << '\n';
  return 0;
}

}

void add_bench(CLI::App& app, Action& chosen) {
  CLI::App* sub = app.add_subcommand("bench", "measure the speed");
  const auto o = std::make_shared<BenchOptions>();
  sub->add_option("scenes", o->scenes, "only these");
  sub->add_flag("--thesis", o->thesis, "the scenes whose speed the thesis's prototype is known for");
  sub->add_option("--repeat", o->repeat, "runs of each scene; the fastest counts")->check(CLI::Range(1, 1000));
  sub->add_flag("--json", o->json, "the results as JSON (docs/json.md)");
  sub->callback([&chosen, o] { chosen = [o](const Catalogue& c) { return bench(*o, c); }; });
}

}
