// The verdicts of a scenario: the worst value is kept, times are kept, what was not reached has no verdict.
#include <sudar/scenario.h>

#include "unit/worlds.h"

namespace sudar_test {
namespace {

const Check::Entry& entry(const Check& c, std::string_view name) {
  for (const Check::Entry& e : c.entries()) {
    if (e.name == name) return e;
  }
  throw Error("check", "there is no " + std::string(name));
}

TEST(Check, KeepsTheWorstValue) {
  Check c;
  for (const double value : {1.0, 3.0, 2.0}) {
    c.visit(value, 0.1, true);
    c.below("low", value, 5, "m"), c.above("high", -value, -5), c.near("near", 10 - value, 10, 4),
        c.that("holds", true);
  }
  EXPECT_EQ(entry(c, "low").value, 3);
  EXPECT_EQ(entry(c, "low").at, 3);
  EXPECT_EQ(entry(c, "low").limit, 5);
  EXPECT_EQ(entry(c, "low").unit, "m");
  EXPECT_EQ(entry(c, "low").op, "<");
  EXPECT_EQ(entry(c, "high").value, -3);
  EXPECT_EQ(entry(c, "near").value, 7);
  EXPECT_EQ(entry(c, "near").tolerance, 4);
  EXPECT_TRUE(c.passed());
  EXPECT_EQ(c.entries().size(), 4u);
}

// Once failed, failed: a good value later does not mend it.
TEST(Check, FailureStays) {
  for (int kind = 0; kind < 4; ++kind) {
    Check c;
    for (const double value : {0.0, 9.0, 0.0}) {
      c.visit(value, 0.1, true);
      if (kind == 0) c.below("x", value, 5);
      if (kind == 1) c.above("x", -value, -5);
      if (kind == 2) c.near("x", value, 0, 5);
      if (kind == 3) c.that("x", value < 5);
    }
    EXPECT_EQ(entry(c, "x").pass, false) << kind;
    EXPECT_EQ(entry(c, "x").at, 9) << kind;
    EXPECT_FALSE(c.passed());
  }
}

TEST(Check, Limits) {
  Check c;
  c.below("below", 5, 5), c.above("above", 5, 5), c.near("near", 5, 4, 1), c.below("nan", std::nan(""), 5);
  EXPECT_EQ(entry(c, "below").pass, false);
  EXPECT_EQ(entry(c, "above").pass, false);
  EXPECT_EQ(entry(c, "near").pass, true);
  EXPECT_EQ(entry(c, "nan").pass, false);
}

// NaN is worse than any number, before and after.
TEST(Check, NanStays) {
  Check c;
  c.below("x", 1, 5), c.below("x", std::nan(""), 5), c.below("x", 4, 5);
  EXPECT_EQ(entry(c, "x").pass, false);
  EXPECT_TRUE(std::isnan(entry(c, "x").value));
}

// at, from, between (both ends count): the step that reaches a time, whatever the rounding of k · 0.1 s.
TEST(Check, Times) {
  Check c;
  int at = 0;
  for (int i = 1; i <= 50; ++i) {
    const double time = i * 0.1;
    c.visit(time, 0.1, true);
    c.at(2).below("at", time, 99), c.from(2).below("from", -time, 0), c.between(2, 3).below("between", time, 99);
    at += entry(c, "at").at == time;
  }
  EXPECT_EQ(at, 1);
  EXPECT_NEAR(entry(c, "at").at, 2, 1e-12);
  EXPECT_NEAR(entry(c, "from").at, 2, 1e-12);  // −2 is the worst
  EXPECT_NEAR(entry(c, "between").at, 3, 1e-12);
}

TEST(Check, NotReachedHasNoVerdict) {
  Check c;
  c.visit(1, 0.1, true);
  c.at(5).below("late", 9, 1);
  EXPECT_FALSE(entry(c, "late").pass.has_value());
  EXPECT_FALSE(c.passed());  // nothing was judged
  c.below("now", 0, 1);
  EXPECT_TRUE(c.passed());
  c.visit(1, 0.1, false);
  c.below("end", 9, 1);
  EXPECT_FALSE(entry(c, "end").pass.has_value());
  EXPECT_TRUE(c.passed());
  EXPECT_FALSE(Check{}.passed());
}

TEST(Check, SavesAndLoads) {
  Check c, restored;
  c.visit(1, 0.1, true);
  c.below("good", 1, 2, "m"), c.above("bad", 1, 2, "s"), c.at(7).near("later", 1, 2, 3);
  restored.load(c.save());
  EXPECT_EQ(restored.save(), c.save());
  EXPECT_EQ(entry(restored, "good").pass, true);
  EXPECT_EQ(entry(restored, "bad").pass, false);
  EXPECT_FALSE(entry(restored, "later").pass.has_value());
  restored.visit(2, 0.1, true);
  restored.below("good", 5, 2);
  EXPECT_EQ(entry(restored, "good").pass, false);
  const Bytes bytes = c.save();
  for (std::size_t n = 0; n < bytes.size(); ++n) {
    EXPECT_THROW(restored.load(Bytes(bytes.begin(), bytes.begin() + std::ptrdiff_t(n))), Error);
  }
}

}
}
