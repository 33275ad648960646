// A session: builds with parameters and settings, steps, checks, and goes on after save and load in a fresh instance.
#include <sudar/session.h>

#include "unit/worlds.h"

namespace sudar_test {
namespace {

// A ball is dropped wherever "space" is pressed; while "up" is held, the first one is pushed up; along the view with
// "v".
struct Drops : Scenario {
  static constexpr double seconds = 2;
  static constexpr const char* about = "balls dropped by a key";
  Real height = 3;
  Body first;
  int dropped = 0;
  void params(Params& p) override { p("height", height, 1, 10, "m"); }
  void state(State& s) override { s("first", first), s("dropped", dropped); }
  void config(Config& c) override { c.dt = 0.01, c.substeps = 1; }
  void build(World& w) override {
    w.add(Gravity{});
    add_floor(w);
    first = w.add({.shape = sphere(Real(0.5)), .at = {0, double(height), 0}, .mass = 1});
  }
  void control(World& w, const Input& in) override {
    if (in.pressed("space")) w.add({.shape = sphere(Real(0.2)), .at = {double(++dropped), 5, 0}});
    if (in.held("up")) w.push(first, {0, 12, 0}, w[first].center());
    if (in.pressed("v")) w.set_velocity(first, in.view * Real(2), {});
  }
  void observe(const World& w, Check& c) override { c.above("height", w[first].pose().p.y, 0.4, "m"); }
  void check(const World&, Check& c) override { c.that("dropped", dropped == 2); }
};

const ScenarioEntry drops{.abi = abi_of_this_file(),
                          .name = "drops",
                          .place = "Tests/Drops",
                          .about = Drops::about,
                          .seconds = Drops::seconds,
                          .picture = 1,
                          .create = [](const ScenarioEntry&) -> Scenario* { return new Drops; },
                          .destroy = [](Scenario* s) { delete s; }};

Catalogue catalogue() {
  Catalogue c;
  c.add(&drops);
  return c;
}

constexpr const char* keys = "0.1:space 0.2:up 0.3:up+space 0.4:up 1:none 1.2:v";

void run_to(Session& s, KeyScript& script, double time) {
  while (s.world().time() < time - s.dt() / 2) script.apply(s.world().time(), s.input), s.step();
}

TEST(Session, RunsToItsVerdict) {
  Session s(drops, {.set = {{"height", 4}}});
  EXPECT_EQ(s.params().at(0).value, 4);
  EXPECT_EQ(s.seconds(), 2);
  EXPECT_EQ(s.dt(), 0.01);
  KeyScript script(keys);
  while (!s.done()) script.apply(s.world().time(), s.input), s.step();
  EXPECT_EQ(s.world().steps(), 200);
  EXPECT_TRUE(s.finish().passed());
  EXPECT_EQ(s.check().entries().size(), 2u);
}

TEST(Session, CutShortHasNoVerdictOnTheEnd) {
  Session s(drops, {.seconds = 1.0});
  while (!s.done()) s.step();
  EXPECT_EQ(s.world().steps(), 100);
  const Check& check = s.finish();
  EXPECT_EQ(check.entries().at(0).pass, true);
  EXPECT_FALSE(check.entries().at(1).pass.has_value());
}

TEST(Session, TakesSettings) {
  Session s(drops, {.config = {{"dt", "0.02"}, {"impulse_2007.contact_passes", "10"}}});
  EXPECT_EQ(s.world().config().dt, 0.02);
  EXPECT_EQ(s.world().config().impulse_2007.contact_passes, 10);
  EXPECT_THROW(Session(drops, {.set = {{"width", 3}}}), Error);
  EXPECT_THROW(Session(drops, {.set = {{"height", 30}}}), Error);
  EXPECT_THROW(Session(drops, {.config = {{"dt", "-1"}}}), Error);
}

// With keys held and pressed, from every tenth step, in a fresh instance: the same bits and the same verdict.
TEST(Session, GoesOnAfterLoad) {
  const Catalogue all = catalogue();
  Session whole(drops, {.set = {{"height", 4}}});
  KeyScript script(keys);
  run_to(whole, script, 2);
  for (int stop = 0; stop <= 190; stop += 10) {
    Session first(drops, {.set = {{"height", 4}}});
    KeyScript one(keys), two(keys);
    run_to(first, one, stop * 0.01);
    Session second = Session::load(all, first.save());
    two.skip(second.world().time() - second.dt());
    run_to(second, two, 2);
    ASSERT_EQ(second.world().hash(), whole.world().hash()) << "saved at step " << stop;
    EXPECT_EQ(second.params().at(0).value, 4);
    EXPECT_EQ(second.finish().save(), Session::load(all, whole.save()).finish().save());
  }
}

// What fields_of() lists, set_field() takes back.
TEST(Settings, FieldsThereAndBack) {
  Config c;
  c.broad = Broad::grid, c.dt = 1.0 / 97, c.sleep = false, c.impulse_2007.correction = Real(0.1);
  Config copy;
  for (const auto& [path, value] : fields_of(c)) set_field(copy, path, value);
  EXPECT_EQ(fields_of(copy), fields_of(c));
  EXPECT_EQ(copy.dt, c.dt);
  EXPECT_EQ(copy.impulse_2007.correction, c.impulse_2007.correction);
  EXPECT_NE(fields_of(c), fields_of(Config{}));
}

TEST(Session, RefusesDamagedData) {
  const Catalogue all = catalogue();
  Session s(drops);
  s.step();
  const Bytes whole = s.save();
  EXPECT_THROW(Session::load(Catalogue{}, whole), Error);  // its scenario does not exist
  for (std::size_t n = 0; n < whole.size(); n += 1 + n / 100) {
    EXPECT_THROW(Session::load(all, std::span(whole).first(n)), Error);
    Bytes turned = whole;
    turned[n] ^= std::byte{4};
    EXPECT_THROW(Session::load(all, turned), Error);
  }
}

TEST(Catalogue, FindsAndRefuses) {
  Catalogue c = catalogue();
  EXPECT_EQ(&c.find("drops"), &drops);
  try {
    c.find("drop");
    ADD_FAILURE();
  } catch (const Error& e) { EXPECT_STREQ(e.what(), "scene: 'drop' does not exist; did you mean 'drops'?"); }
  EXPECT_THROW(c.add(&drops), Error);
  ScenarioEntry foreign = drops;
  foreign.abi = "another engine";
  foreign.name = "other";
  EXPECT_THROW(c.add(&foreign), Error);
  ScenarioEntry earlier = drops;
  earlier.name = "another", earlier.place = "A/Before";
  c.add(&earlier);
  EXPECT_EQ(c.all().front(), &earlier);
}

}
}
