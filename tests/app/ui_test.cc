// What the window does, without a window: scenes between two steps, the physics thread's independence of who looks at
// it, what the mouse's camera turns round.
#include <gtest/gtest.h>

#include <future>

#include "ui/hand.h"
#include "unit/worlds.h"

namespace sudar_test {
namespace {

using namespace sudar::ui;

// A ball that falls and bounces, and one more with every tenth step.
struct Rain : Scenario {
  static constexpr double seconds = 1;
  int steps = 0;
  void state(State& s) override { s("steps", steps); }
  void config(Config& c) override { c = steady(); }
  void build(World& w) override {
    w.add(Gravity{});
    sudar_test::add_floor(w);
    drop(w);
  }
  void drop(World& w) { w.add({.shape = sphere(0.5), .at = {0.3 * (steps % 70), 3, 0}, .mass = 1}); }
  void control(World& w, const Input&) override {
    if (++steps % 10 == 0) drop(w);
  }
  void check(const World&, Check&) override {}
};
const ScenarioEntry rain{
    abi_of_this_file(), "rain", "Tests/Rain", "", Rain::seconds, 1,
    [](const ScenarioEntry&) -> Scenario* { return new Rain; },
    [](Scenario* s) { delete s; }};

struct Reached {
  std::int64_t steps = 0;
  std::uint64_t hash = 0;
};

// The state after at least 200 steps at ten times real time, of a window that looks at it `pictures` times a second.
Reached run_watched(int pictures) {
  Simulation simulation;
  simulation.set_speed(10);
  simulation.start(rain, {});
  const auto pause = std::chrono::microseconds(1'000'000 / pictures);
  for (;;) {
    const View v = simulation.view();
    if (v.after && v.after->steps >= 200) break;
    std::this_thread::sleep_for(pause);
  }
  std::promise<Reached> reached;
  simulation.post([&](History& h) {
    const World& w = h.run().world();
    reached.set_value({w.steps(), w.hash()});
  });
  return reached.get_future().get();
}

TEST(PhysicsThread, ItsResultDoesNotDependOnPictures) {
  for (const int pictures : {5, 2000}) {
    const Reached window = run_watched(pictures);
    Session headless(rain);
    while (headless.world().steps() < window.steps) headless.step();
    EXPECT_EQ(window.hash, headless.world().hash()) << pictures << " pictures a second, " << window.steps << " steps";
  }
}

view::Scene scene_of(const World& w) { return view::make_scene(w); }

TEST(Interpolation, HalfWayBetweenTwoSteps) {
  World w(steady());
  const Body ball = w.add({.shape = sphere(1), .velocity = {2, 0, 0}, .spin = {0, 1, 0}, .mass = 1});
  const Body gone = w.add({.shape = sphere(1), .at = {9, 0, 0}, .mass = 1});
  const view::Scene before = scene_of(w);
  w.step(0.5);
  w.remove(gone);
  const Body fresh = w.add({.shape = sphere(1), .at = {0, 9, 0}, .mass = 1});
  const view::Scene after = scene_of(w), half = view::mix(before, after, 0.5);
  ASSERT_EQ(half.instances.size(), 2u);
  for (const view::Instance& i : half.instances) {
    if (i.body == ball) {
      EXPECT_NEAR(i.pose.p.x, 0.5, 1e-5);
      EXPECT_NEAR(double(rotate(i.pose.q, Vec3{1, 0, 0}).z), -std::sin(0.25), 1e-3);  // half of half a radian
    } else {
      EXPECT_EQ(i.body, fresh);
      EXPECT_EQ(i.pose.p.y, 9);  // it was not there before: it is where it is
    }
  }
  EXPECT_EQ(view::mix(before, after, 1).instances[0].pose, after.instances[0].pose);
}

TEST(Interpolation, ShareOfTheWay) {
  const auto moment = [](std::int64_t run) {
    auto m = std::make_shared<Moment>();
    m->run = run;
    return m;
  };
  const Clock::time_point start{};
  View v;
  v.before = v.after = moment(1);
  v.since = start, v.span = 0.1;
  const auto share = [&](double seconds) {
    return v.share(start + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds)));
  };
  EXPECT_EQ(share(-1), 0);
  EXPECT_NEAR(share(0.025), 0.25, 1e-6);
  EXPECT_EQ(share(5), 1);  // never beyond what was computed
  v.paused = true;
  EXPECT_EQ(share(0.025), 1);
  v.paused = false;
  v.before = moment(0);  // another run: nothing lies between them
  EXPECT_EQ(share(0.025), 1);
}

TEST(Camera, TurnsRoundWhatItFlewTo) {
  Catalogue none;
  Simulation simulation;
  Controls controls(none, simulation);
  Hand hand(controls, [](int, int) { return Body{}; });
  controls.area = {0, 0, 800, 600};
  controls.focus = {.centre = {}, .radius = 5};
  controls.camera.set({.eye = {0, 0, 80}, .target = {}});
  const auto take = [&](const InputEvent& e) { hand.take(e, controls.area); };
  take({.kind = InputEvent::Kind::button, .code = 1, .down = true, .x = 400, .y = 300});
  take({.kind = InputEvent::Kind::key, .code = 'W', .down = true});
  while (controls.camera.camera().eye.z > 10) hand.fly(0.02);
  EXPECT_NEAR(controls.camera.camera().target.z, 0, 1e-3);  // not 70 m behind it
}

}
}
