// sudar verify: how right the engine is, case by case (docs/verification.md).
#include "verify/known_failures.h"
#include "verify/report.h"

#include <cmath>
#include <cstdio>
#include <iostream>

#include <nlohmann/json.hpp>

#include "main/command.h"
#include "main/progress.h"
#include "main/scene_options.h"

namespace sudar::app {

using namespace verify;

namespace {

using Json = nlohmann::ordered_json;

struct VerifyOptions {
  std::vector<std::string> cases, set;
  std::string solver = names(Solver{})[std::size_t(Config{}.solver)], report;
  bool quick = false, full = false, list = false, json = false, strict = false;
  unsigned jobs = 0;

  Options options() const {
    Options o{.cases = cases, .set = parse_parameters(set), .jobs = jobs, .pictures = !report.empty()};
    if (quick && full) throw Error("--quick", "and --full exclude each other");
    o.effort = quick ? Effort::quick : full ? Effort::full : Effort::normal;
    o.solvers.clear();
    for (int s = 0; names(Solver{})[s] != nullptr; ++s) {
      if (solver == names(Solver{})[s]) o.solvers.push_back(Solver(s));
    }
    if (o.solvers.empty()) throw Error("--solver", "\"" + solver + "\" given, expected: " + choices(names(Solver{})));
    return o;
  }
};

void list_cases() {
  for (const Case& c : all_cases()) {
    std::printf("%-5s %-16s %s\n", c.id, c.group, c.title);
    for (const Parameter& p : c.parameters) { std::printf("%24s = %g (%s)\n", p.name, p.value, p.range().c_str()); }
  }
}

void print(const Result& r, Effort effort) {
  const KnownFailure* known = r.passed() ? nullptr : known_failure(r.of->id, effort, r.solver);
  std::printf("%-5s %s, %s%s (%.2f s)\n", r.of->id, r.of->title, r.set.c_str(),
              r.passed() ? "" : known != nullptr ? ": fails as known" : ": FAILED", r.seconds);
  if (known != nullptr) std::printf("      %s\n", known->reason);
  if (!r.failure.empty()) std::printf("      %s\n", r.failure.c_str());
  for (const Quantity& q : r.quantities) {
    std::printf("      %-6s %-46s %14.9g %14.9g  error %9.3g %s %9.3g %s\n", q.pass() ? "ok" : "FAILED",
                q.name.c_str(), q.exact, q.got, q.error(), q.refuted ? "to be above" : "of", q.tolerance, q.unit.c_str());
  }
}

Json json_of(const std::vector<Result>& results) {
  Json all = Json::array();
  for (const Result& r : results) {
    Json entry{{"id", r.of->id}, {"name", r.of->title}, {"solver", nullptr}};
    if (r.solver) entry["solver"] = solver_name(*r.solver);
    const auto add = [&](const std::string& quantity, const Quantity& q) {
      Json e = entry;
      e["quantity"] = quantity, e["unit"] = q.unit, e["parameters"] = Json(r.parameters);
      e["exact"] = q.exact, e["got"] = q.got, e["error"] = q.error(), e["tolerance"] = q.tolerance;
      e["pass"] = q.pass(), e["seconds"] = r.seconds;
      all.push_back(e);
    };
    for (const Quantity& q : r.quantities) add(q.name, q);
    const double unknown = std::nan("");
    if (!r.failure.empty()) add(r.failure, {"", "", unknown, unknown, 0});
  }
  return all;
}

std::string measured() {
  const Config c;
  return "Sudar " SUDAR_VERSION ", " + std::string(sizeof(Real) == 4 ? "single" : "double") + " precision, " +
         std::to_string(std::lround(1 / c.dt)) + " Hz × " + std::to_string(c.substeps) + " sub-steps";
}

int verify(const VerifyOptions& v) {
  if (v.list) {
    list_cases();
    return 0;
  }
  Progress progress("verify", 1);
  const Options options = v.options();
  const std::vector<Result> results = run_cases(options, [&](double share) { progress.show(share); });
  progress.clear();
  const Tally tally = count(results);
  if (!v.report.empty()) write_report(results, v.report, measured());
  if (v.json) {
    std::cout << json_of(results).dump(2) << '\n';
  } else {
    for (const Result& r : results) print(r, options.effort);
    std::printf("\n%s\n", tally.text().c_str());
  }
  const Surprises found = surprises(results, options);
  const auto say = [](const Surprise& s, const char* what) {
    const std::string with = s.solver ? std::string(" with ") + solver_name(*s.solver) : "";
    std::fprintf(stderr, "sudar: %s %s\n", s.of->id, (what + with).c_str());
  };
  for (const Surprise& s : found.failed) say(s, "fails, and is not known to");
  for (const Surprise& s : found.passed) say(s, "passes: take it off the known failures");
  const bool all = tally.passed == tally.cases && tally.beside_passed == tally.beside;
  return found.none() && (all || !v.strict) ? 0 : 1;
}

}

void add_verify(CLI::App& app, Action& chosen) {
  CLI::App* sub = app.add_subcommand("verify", "compare with exact results");
  const auto v = std::make_shared<VerifyOptions>();
  sub->add_option("cases", v->cases, "only these, by their numbers");
  sub->add_flag("--quick", v->quick, "those that take little time");
  sub->add_flag("--full", v->full, "those that take long, too");
  sub->add_flag("--list", v->list, "name the cases and their parameters, run none");
  sub->add_option("--set", v->set, "parameter of the cases: NAME=VALUE; may be repeated")->allow_extra_args(false);
  sub->add_option("--solver", v->solver, "by which solver: " + choices(names(Solver{})))->capture_default_str();
  add_whole(*sub, "--jobs", v->jobs, 1, 1024, "cases at once; else as many as the processor has cores");
  sub->add_option("--report", v->report, "writes pages for a browser with curves into this folder");
  sub->add_flag("--strict", v->strict, "exit 1 for every failure, those that are known, too");
  sub->add_flag("--json", v->json, "the results as JSON (docs/verification.md)");
  sub->callback([&chosen, v] { chosen = [v](const Catalogue&) { return verify(*v); }; });
}

}
