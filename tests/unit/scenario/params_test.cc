// Parameters, settings by path, keys by script, the state that a scenario remembers.
#include <sudar/session.h>

#include "unit/worlds.h"

namespace sudar_test {
namespace {

struct Values {
  int count = 3;
  Real size = Real(1.5);
  double far = 2;
  bool on = true;
  void visit(Params& p) {
    p("count", count, 1, 10), p("size", size, 0, 2, "m"), p("far", far, -5, 5), p("on", on, "whether");
  }
};

std::string refusal(const std::map<std::string, double>& given) {
  try {
    Params p(given);
    Values v;
    v.visit(p);
    p.require_all_known();
    return "";
  } catch (const Error& e) { return e.what(); }
}

TEST(Params, ListAndSet) {
  Params list;
  Values v;
  v.visit(list);
  ASSERT_EQ(list.entries().size(), 4u);
  EXPECT_EQ(list.entries()[0].name, "count");
  EXPECT_EQ(list.entries()[0].kind, Params::Kind::integer);
  EXPECT_EQ(list.entries()[0].value, 3);
  EXPECT_EQ(list.entries()[0].high, 10);
  EXPECT_EQ(list.entries()[1].kind, Params::Kind::real);
  EXPECT_EQ(list.entries()[1].about, "m");
  EXPECT_EQ(list.entries()[3].kind, Params::Kind::boolean);

  Params set({{"count", 7}, {"size", 0.25}, {"on", 0}});
  v.visit(set);
  set.require_all_known();
  EXPECT_EQ(v.count, 7);
  EXPECT_EQ(v.size, Real(0.25));
  EXPECT_EQ(v.far, 2);
  EXPECT_FALSE(v.on);
  EXPECT_EQ(set.entries()[0].value, 7);
}

TEST(Params, RefuseByName) {
  EXPECT_EQ(refusal({{"count", 1}, {"size", 0}, {"far", 5}}), "");
  EXPECT_EQ(refusal({{"count", 0}}), "count: is 0, must be a whole number from 1 to 10");
  EXPECT_EQ(refusal({{"count", 2.5}}), "count: is 2.5, must be a whole number from 1 to 10");
  EXPECT_EQ(refusal({{"size", 2.01}}), "size: is 2.01, must be from 0 to 2");
  EXPECT_EQ(refusal({{"far", std::nan("")}}), "far: is nan, must be from -5 to 5");
  EXPECT_EQ(refusal({{"on", 2}}), "on: is 2, must be a whole number from 0 to 1");
  EXPECT_EQ(refusal({{"colour", 2}}), "colour: is no parameter of this scenario; there is: count, size, far, on");
}

// --- settings ---

std::string refused_field(std::string_view path, std::string_view value) {
  Config c;
  try {
    set_field(c, path, value);
    return "";
  } catch (const Error& e) { return e.what(); }
}

TEST(SetField, EveryKindOfField) {
  Config c;
  set_field(c, "dt", "0.02");
  set_field(c, "substeps", "7");
  set_field(c, "sleep", "false");
  set_field(c, "friction_mix", "max");
  set_field(c, "impulse_2007.contact_passes", "20");
  set_field(c, "impulse_2007.slop", "1e-3");
  EXPECT_EQ(c.dt, 0.02);
  EXPECT_EQ(c.substeps, 7);
  EXPECT_FALSE(c.sleep);
  EXPECT_EQ(c.friction_mix, Mix::max);
  EXPECT_EQ(c.impulse_2007.contact_passes, 20);
  EXPECT_EQ(c.impulse_2007.slop, Real(1e-3));
}
TEST(SetField, RefusesByPath) {
  EXPECT_EQ(refused_field("dt", "soon"), "dt: is 'soon', must be a number");
  EXPECT_EQ(refused_field("dt", ""), "dt: is '', must be a number");
  EXPECT_EQ(refused_field("substeps", "2.5"), "substeps: is '2.5', must be a whole number");
  EXPECT_EQ(refused_field("sleep", "maybe"), "sleep: is 'maybe', must be true or false");
  EXPECT_EQ(refused_field("friction_mix", "most"),
            "friction_mix: is 'most', must be one of min, geometric, average, max");
  EXPECT_NE(refused_field("impulse_2007.passes", "2").find("impulse_2007.contact_passes"), std::string::npos);
  EXPECT_NE(refused_field("impulse_2007", "2"), "");
}

// --- keys ---

TEST(Keys, FollowTheScript) {
  KeyScript script("0:up+left 1.5:none 2:space");
  Input in;
  script.apply(0, in);
  EXPECT_TRUE(in.held("up") && in.held("left") && in.pressed("up"));
  in.clear_pressed();
  script.apply(1, in);
  EXPECT_TRUE(in.held("up"));
  EXPECT_FALSE(in.pressed("up"));
  script.apply(1.5, in);
  EXPECT_FALSE(in.held("up") || in.held("left"));
  script.apply(2.5, in);
  EXPECT_TRUE(in.held("space") && in.pressed("space"));
}
// A key that goes down and up between two steps was pressed.
TEST(Keys, ShortTapsCount) {
  KeyScript script("1:space 1.001:none");
  Input in;
  script.apply(2, in);
  EXPECT_TRUE(in.pressed("space"));
  EXPECT_FALSE(in.held("space"));
}
TEST(Keys, HeldOnesAreNotPressedAgain) {
  Input in;
  in.set({"a"});
  in.clear_pressed();
  in.set({"a", "b"});
  EXPECT_FALSE(in.pressed("a"));
  EXPECT_TRUE(in.pressed("b"));
}
TEST(Keys, RefuseBadScripts) {
  for (const char* bad : {"up", "0:", ":up", "x:up", "-1:up", "nan:up", "2:up 1:none"}) {
    EXPECT_THROW(KeyScript{bad}, Error) << bad;
  }
  for (const char* good : {"", "0:none", " 0:up  1:down ", "0:up 0:down"}) EXPECT_NO_THROW(KeyScript{good}) << good;
}

// --- state ---

struct Memory {
  int dropped = 0;
  Body last;
  std::vector<double> heights;
  void visit(State& s) { s("dropped", dropped), s("last", last), s("heights", heights); }
};

TEST(State, WritesAndReads) {
  Memory before{7, {3, 1}, {1.5, 2.5}}, after;
  State write;
  before.visit(write);
  State read(write.bytes());
  EXPECT_FALSE(read.all_read());
  after.visit(read);
  EXPECT_TRUE(read.all_read());
  EXPECT_EQ(after.dropped, 7);
  EXPECT_EQ(after.last, before.last);
  EXPECT_EQ(after.heights, before.heights);
}

}
}
