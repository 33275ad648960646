// The cases of `sudar verify`: the quick ones pass but for those that are known to fail and explained, and every one
// bites.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>

#include "verify/peers.h"
#include "verify/runner.h"

using namespace sudar;
using namespace sudar::verify;

namespace {

// A failure that is not known is a regression; one that is known and gone has to leave the list.
class CasesWith : public testing::TestWithParam<Solver> {};

TEST_P(CasesWith, FailAsKnown) {
  const Options options{.effort = Effort::quick, .solvers = {GetParam()}};
  const std::vector<Result> results = run_cases(options);
  const Surprises found = surprises(results, options);
  for (const Result& r : results) {
    if (r.passed() || std::ranges::find(found.failed, r.of, &Surprise::of) == found.failed.end()) continue;
    EXPECT_EQ(r.failure, "") << r.of->id;
    for (const Quantity& q : r.quantities) {
      if (!q.pass())
        ADD_FAILURE() << r.of->id << ' ' << r.set << ": " << q.name << " is " << q.got << ", not " << q.exact << " ± "
                      << q.tolerance;
    }
  }
  for (const Surprise& s : found.passed)
    ADD_FAILURE() << s.of->id << " passes: take it out of known_failures.cc and docs/verification.md";
}

INSTANTIATE_TEST_SUITE_P(Solvers, CasesWith, testing::Values(Solver::impulse_2007, Solver::soft_step),
                         [](const auto& info) { return std::string(solver_name(info.param)); });

// Whether a quantity tells the case from the same without part of its physics: right with it and wrong without, or at
// least ten times as wrong.
bool tells(const Quantity& whole, const Quantity& without) {
  return !whole.refuted && !without.pass() && (whole.pass() || without.error() > 10 * whole.error());
}

// The cases that cannot show their bite by passing, since they fail whatever the parameters: see docs/verification.md.
const std::set<std::string> never_pass = sizeof(Real) == 4 ? std::set<std::string>{"V09", "V42", "B2", "B3"}
                                                           : std::set<std::string>{"V36", "V42", "B2", "B3"};

void expect_bites(Effort effort) {
  std::vector<std::string> cases;
  for (const Case& c : all_cases()) {
    if (c.bite.effort == effort) cases.push_back(c.id);
  }
  const Result* whole = nullptr;
  const std::vector<Result> results = run_cases({.cases = cases, .effort = Effort::quick, .bites = true});
  for (const Result& r : results) {
    EXPECT_EQ(r.failure, "") << r.of->id;
    EXPECT_FALSE(r.of->without.empty()) << r.of->id << " does not say what may be taken away";
    if (r.without.empty()) {
      whole = &r;
      EXPECT_EQ(r.passed(), !never_pass.contains(r.of->id)) << r.of->id << " with the parameters of its bite";
      continue;
    }
    bool told = false;
    for (const Quantity& q : whole->quantities) {
      for (const Quantity& w : r.quantities) told |= w.name == q.name && tells(q, w);
    }
    EXPECT_TRUE(told) << r.of->id << " is as right without " << r.without;
  }
}

TEST(Cases, BiteWithoutTheirPhysics) { expect_bites(Effort::quick); }

// Minutes: not among the tests that are always run (docs/verification.md).
TEST(SlowCases, BiteWithoutTheirPhysics) { expect_bites(Effort::full); }

// The report and the page for readers hold the same table.
TEST(Cases, OtherEnginesAreAsInTheDocs) {
  std::ostringstream page;
  page << std::ifstream(SUDAR_SOURCE "/docs/verification.md").rdbuf();
  for (const PeerRow& row : peer_rows()) {
    ASSERT_EQ(row.values.size(), peer_columns().size()) << row.engine;
    std::string line = std::string("| ") + row.engine + " |";
    for (const char* value : row.values) line += std::string(" ") + value + " |";
    EXPECT_NE(page.str().find(line), std::string::npos) << "docs/verification.md lacks " << line;
  }
  std::string head = "| engine |", ours = "| **Sudar, impulse_2007, 60/4** |";
  for (const PeerColumn& column : peer_columns()) {
    head += std::string(" ") + column.title + " |";
    const std::string value = our_value(column, run_cases({.cases = {column.id}, .effort = Effort::quick}));
    EXPECT_NE(value, "–") << column.title << " is not measured any more";
    ours += " " + value + " |";
  }
  if constexpr (sizeof(Real) == 4) {
    EXPECT_NE(page.str().find(head + "\n"), std::string::npos) << "docs/verification.md lacks " << head;
    EXPECT_NE(page.str().find(ours + "\n"), std::string::npos) << "docs/verification.md lacks " << ours;
  }
}

TEST(Cases, AreLawsNotNumbers) {
  std::set<std::string> ids;
  for (const Case& c : all_cases()) {
    EXPECT_TRUE(ids.insert(c.id).second) << c.id << " twice";
    EXPECT_FALSE(c.sets.empty()) << c.id << " runs one set of parameters only";
    for (const ParameterSet& set : c.sets) EXPECT_NO_THROW(values_of(c, set.values)) << c.id;
  }
}

}
