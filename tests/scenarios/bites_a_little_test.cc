// A tolerance that is too wide lets wrong physics pass. So every scenario that has a law to state runs with its physics
// a little wrong, and the checks that are named here must tell. Not named are limits that leave room on purpose (gaps
// of joints, overlap, drift of what stands), what is counted (dominoes that fell, boxes at their goals), and times that
// a fiftieth of gravity or a tenth of friction do not change by the length of a step; checks_bite takes more away.
#include "scenarios/every_scenario.h"

#include <functional>
#include <map>

using namespace sudar;

namespace {

void heavier(World& w) {
  Vec3 sum;
  for (const ForceId f : w.forces()) {
    if (const auto* gravity = std::get_if<Gravity>(&w[f])) sum += gravity->acceleration;
  }
  w.add(Gravity{sum * Real(0.02)});
}

void add_air(World& w) { w.add(Drag{.linear = Real(0.01), .angular = Real(0.01)}); }

void change_materials(World& w, const std::function<void(Material&)>& change) {
  const std::vector<Body> bodies = w.bodies();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      Material m = w.pair_material(bodies[i], bodies[j]);
      change(m);
      w.set_pair_material(bodies[i], bodies[j], m);
    }
  }
}
void smoother(World& w) {
  change_materials(w, [](Material& m) {
    for (Real* x : {&m.friction_static, &m.friction_dynamic, &m.rolling, &m.spinning}) *x *= Real(0.9);
  });
}
void duller(World& w) {
  change_materials(w, [](Material& m) { m.restitution *= Real(0.95); });
}

void a_tenth_of_the_passes(World& w) {
  Config c = w.config();
  c.impulse_2007.collision_passes /= 10, c.impulse_2007.contact_passes /= 10;
  w.set_config(c);
}

struct Bite {
  const char* scenario;
  void (*wrong)(World&);
  std::vector<const char*> told_by;
};
const std::vector<Bite>& bites() {
  static const std::vector<Bite> all = {
      {"friction", smoother, {"creep down the incline"}},
      {"spin", heavier, {"the ball stops after"}},
      {"spin", smoother, {"the ball stops after"}},
      {"spinning_ball", duller, {"apex after the bounce"}},
      {"spinning_ball", add_air, {"speed sideways after the bounce", "spin after the bounce"}},
      {"sticks", smoother, {"stick 4: its foot lets go at", "stick 4: slides a way, x"}},
      {"train", a_tenth_of_the_passes, {"movement of the locomotive"}},
      {"billiards", heavier, {"its speed then", "its spin then"}},
      {"billiards", smoother, {"its speed then", "its spin then"}},
      {"billiards", add_air, {"the cue ball hits"}},
      {"bouncing_boxes",
       duller,
       {"apex with e = 1 − 2^−1", "apex with e = 1 − 2^−2", "apex with e = 1 − 2^−3", "apex with e = 1 − 2^−4",
        "apex with e = 1 − 2^−5", "apex with e = 1 − 2^−6", "apex with e = 1 − 2^−7", "apex with e = 1 − 2^−8",
        "apex with e = 1 − 2^−9"}},
      {"elastic_row", duller, {"kinetic energy"}},
      {"elastic_row", a_tenth_of_the_passes, {"kinetic energy", "cubes that move"}},
      {"elastic_spin", duller, {"kinetic energy"}},
      {"elastic_spin", add_air, {"the first impact"}},
      {"cradle", duller, {"speed of the ball that leaves", "speed of the fastest other"}},
      {"cradle", heavier, {"the ball hits"}},
      {"jack", heavier, {"off the parabola in flight"}},
      {"jack", add_air, {"spin gained or lost in flight"}},
      {"stool", heavier, {"leg 1 carries", "leg 2 carries", "leg 3 carries"}},
      {"net", a_tenth_of_the_passes, {"joint gap"}},
      {"arm", a_tenth_of_the_passes, {"joint gap"}},
      {"trebuchet", a_tenth_of_the_passes, {"joint gap"}},
      {"trebuchet", add_air, {"it lands where a parabola ends"}},
      {"dzhanibekov",
       add_air,
       {"angular momentum / at the start", "kinetic energy / at the start", "time between turns", "turns over"}},
      {"gyroscope", heavier, {"gone round"}},
      {"gyroscope", add_air, {"tilt"}},
      {"tautochrone",
       heavier,
       {"ball 1 is at the bottom after", "ball 2 is at the bottom after", "ball 3 is at the bottom after"}},
      {"solar_system",
       add_air,
       {"Mercury: a turn takes", "Venus: a turn takes", "Earth: a turn takes", "Mars: a turn takes",
        "largest change of a distance from the sun"}},
      {"wall", add_air, {"the ball hits"}},
      {"wall", a_tenth_of_the_passes, {"largest movement of an untouched brick"}},
  };
  return all;
}

void bites_a_little(const ScenarioEntry& entry) {
  for (const Bite& bite : bites()) {
    if (std::string_view(bite.scenario) != entry.name) continue;
    Session session(entry, {});
    bite.wrong(session.world());
    std::map<std::string, std::optional<bool>> verdicts;
    for (const Check::Entry& e : run(session).entries()) verdicts[e.name] = e.pass;
    for (const char* name : bite.told_by) {
      ASSERT_TRUE(verdicts.contains(name)) << "no such check: " << name;
      EXPECT_EQ(verdicts[name], false) << "does not tell: " << name;
    }
  }
}

}

int main(int argc, char** argv) {
  for (const Bite& bite : bites()) scenarios().find(bite.scenario);  // throws where there is none
  return test_every_scenario(argc, argv, bites_a_little, "bites_a_little");
}
