#include "verify/runner.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>

#include "verify/known_failures.h"
#include "verify/numerics.h"

namespace sudar::verify {

bool Result::passed() const {
  return failure.empty() && !quantities.empty() &&
         std::all_of(quantities.begin(), quantities.end(), [](const Quantity& q) { return q.pass(); });
}

const Case& find_case(std::string_view id) {
  for (const Case& c : all_cases()) {
    if (c.id == id) return c;
  }
  throw Error(std::string(id), "is no case: sudar verify --list names them");
}

Tally count(const std::vector<Result>& results) {
  Tally tally;
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (i > 0 && results[i].of == results[i - 1].of) continue;
    bool passed = true;
    for (std::size_t k = i; k < results.size() && results[k].of == results[i].of; ++k) passed &= results[k].passed();
    const bool catalogue = results[i].of->id[0] == 'V';
    ++(catalogue ? tally.cases : tally.beside);
    (catalogue ? tally.passed : tally.beside_passed) += passed ? 1 : 0;
  }
  return tally;
}

Surprises surprises(const std::vector<Result>& results, const Options& o) {
  Surprises found;
  std::vector<std::pair<Surprise, bool>> passed;
  for (const Result& r : results) {
    const Surprise one{r.of, r.solver};
    auto at = std::ranges::find(passed, one, &std::pair<Surprise, bool>::first);
    if (at == passed.end()) at = passed.insert(at, {one, true});
    at->second &= r.passed();
  }
  for (const auto& [of, all] : passed) {
    const bool known = known_failure(of.of->id, o.effort, of.solver) != nullptr;
    if (!all && !known) found.failed.push_back(of);
    if (all && known && o.set.empty()) found.passed.push_back(of);
  }
  return found;
}

std::string Tally::text() const {
  return std::to_string(passed) + " of " + std::to_string(cases) + " cases pass" +
         (beside > 0 ? "; beside them " + std::to_string(beside_passed) + " of " + std::to_string(beside) : "");
}

const char* solver_name(Solver solver) { return names(solver)[std::size_t(solver)]; }

namespace {

std::vector<const Case*> chosen_cases(const Options& o) {
  std::vector<const Case*> chosen;
  for (const std::string& id : o.cases) chosen.push_back(&find_case(id));
  if (!o.cases.empty()) return chosen;
  for (const Case& c : all_cases()) {
    if ((o.bites ? c.bite.effort : c.effort) <= o.effort) chosen.push_back(&c);
  }
  return chosen;
}

Values known_to(const Case& c, const Values& set) {
  Values known;
  for (const Parameter& p : c.parameters) {
    if (const auto at = set.find(p.name); at != set.end()) known.insert(*at);
  }
  return known;
}

std::vector<Result> plan(const Options& o) {
  const std::vector<const Case*> cases = chosen_cases(o);
  for (const auto& given : o.set) {
    const bool known =
        std::any_of(cases.begin(), cases.end(), [&](const Case* c) { return !known_to(*c, {given}).empty(); });
    if (!known) throw Error(given.first, "is no parameter of the chosen cases");
  }
  std::vector<Result> results;
  for (const Case* c : cases) {
    std::vector<ParameterSet> sets{{"defaults", {}}};
    if (o.bites)
      sets = {{"bite", c->bite.values}};
    else if (const Values own = known_to(*c, o.set); !own.empty())
      sets = {{"chosen", own}};
    else
      sets.insert(sets.end(), c->sets.begin(), c->sets.end());
    std::vector<const char*> taken{""};
    if (o.bites) taken.insert(taken.end(), c->without.begin(), c->without.end());
    for (const ParameterSet& set : sets) {
      if (set.effort > o.effort) continue;
      for (const char* without : taken) {
        const Result r{.of = c,
                       .set = set.name,
                       .parameters = values_of(*c, set.values),
                       .solver = {},
                       .without = without,
                       .sweeps = set.sweeps};
        if (!c->uses_solver) results.push_back(r);
        for (const Solver solver : o.solvers) {
          if (c->uses_solver && (!c->only || c->only == solver)) results.push_back(r), results.back().solver = solver;
        }
      }
    }
  }
  return results;
}

// The case with ever shorter sub-steps: the deviations fall as h^order.
void measure_order(const Case& c, Result& r, Run::Setting setting) {
  for (const int times : {1, 2, 4, 8}) {
    setting.substeps = c.sweep_from * times;
    setting.pictures = false;
    Run run(c, r.parameters, setting);
    c.run(run);
    r.sweep.emplace_back(run.h(), run.deviation());
  }
  std::vector<std::pair<double, double>> logs;
  for (const auto& [h, error] : r.sweep) logs.emplace_back(std::log(h), std::log(error));
  r.quantities.push_back({std::string("order of ") + c.sweep, "1", c.order, slope(logs), 0.2});
}

void run_one(const Options& o, Result& r) {
  const auto start = std::chrono::steady_clock::now();
  const Case& c = *r.of;
  try {
    const Run::Setting setting{.solver = r.solver.value_or(Solver::impulse_2007),
                               .without = r.without,
                               .substeps = o.bites ? c.bite.substeps : Run::Setting{}.substeps,
                               .effort = o.effort,
                               .pictures = o.pictures};
    Run run(c, r.parameters, setting);
    c.run(run);
    r.quantities = run.quantities();
    r.plots = run.plots();
    if (run.picture().moments() > 0) r.picture = run.picture().svg();
    if (*c.sweep != 0 && r.sweeps && o.effort != Effort::quick && !o.bites) measure_order(c, r, setting);
  } catch (const std::exception& e) { r.failure = e.what(); }
  r.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}

std::vector<Result> run_cases(const Options& o, const std::function<void(double share)>& progress) {
  std::vector<Result> results = plan(o);
  std::atomic<std::size_t> next = 0, done = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < results.size(); i = next++) {
      run_one(o, results[i]);
      ++done;
    }
  };
  const unsigned jobs = o.jobs > 0 ? o.jobs : std::max(1u, std::thread::hardware_concurrency());
  std::vector<std::thread> threads;
  for (unsigned j = 0; j < jobs; ++j) threads.emplace_back(work);
  while (done < results.size()) {
    progress(double(done) / double(results.size()));
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  for (std::thread& t : threads) t.join();
  return results;
}

}
