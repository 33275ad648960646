// A saved run that went on pressed keys again: the keys held were not saved, so the next step took them for new ones,
// and the script began at its first line. A run with keys that was saved and loaded ended elsewhere.
#include <sudar/session.h>

#include "unit/worlds.h"

namespace sudar_test {
namespace {

// Jumps when "space" goes down, is pushed while "right" is held.
struct Jumper : Scenario {
  Body b;
  void state(State& s) override { s("b", b); }
  void build(World& w) override {
    w.add(Gravity{});
    add_floor(w);
    b = w.add(cube({0, 0.5, 0}));
  }
  void control(World& w, const Input& in) override {
    if (in.pressed("space")) w.push(b, {0, 100, 0}, w[b].center());
    if (in.held("right")) w.push(b, {10, 0, 0}, w[b].center());
  }
};
const ScenarioEntry jumper{.abi = abi_of_this_file(),
                           .name = "jumper",
                           .place = "Tests/Jumper",
                           .about = "",
                           .seconds = 2,
                           .picture = 1,
                           .create = [](const ScenarioEntry&) -> Scenario* { return new Jumper; },
                           .destroy = [](Scenario* s) { delete s; }};

void run_to(Session& s, int steps) {
  KeyScript script("0.1:space 0.3:space+right 0.5:right 0.7:space 1.4:none 1.5:right");
  script.skip(s.world().time() - s.dt());
  while (s.world().steps() < steps) script.apply(s.world().time(), s.input), s.step();
}

TEST(ResumedKeys, GoOnAsTheyWere) {
  Catalogue all;
  all.add(&jumper);
  Session whole(jumper);
  run_to(whole, 120);
  for (int stop = 0; stop < 120; ++stop) {
    Session first(jumper);
    run_to(first, stop);
    Session second = Session::load(all, first.save());
    run_to(second, 120);
    ASSERT_EQ(second.world().hash(), whole.world().hash()) << "saved at step " << stop;
  }
}

}
}
