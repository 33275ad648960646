// The ray through the mouse was computed when the mouse moved or a button changed. Where the camera had moved since (it
// followed a body, flew, was turned), balls were shot from where the eye had been, and the wheel went towards a place
// that the mouse had left.
#include <gtest/gtest.h>

#include "ui/hand.h"

namespace sudar::ui {
namespace {

using Kind = InputEvent::Kind;
constexpr int right = 1, key_w = 'W';  // as GLFW calls them

struct StalePointer : testing::Test {
  Catalogue none;
  Simulation simulation;
  Controls controls{none, simulation};
  Hand hand{controls, [](int, int) { return Body{}; }};

  StalePointer() {
    controls.area = {0, 0, 800, 600};
    controls.camera.set({.eye = {0, 2, 10}, .target = {}});
    take({.kind = Kind::move, .x = 400, .y = 300});
  }
  void take(const InputEvent& e) { hand.take(e, controls.area); }
  const Camera& camera() const { return controls.camera.camera(); }
  // One click of the wheel over the middle of the picture takes an eighth of the way to the target.
  void expect_small_step_of_the_wheel() {
    const Camera before = camera();
    take({.kind = Kind::wheel, .y = 1});
    EXPECT_NEAR(double(length(camera().eye - before.eye)), 0.12 * double(length(before.target - before.eye)), 1e-3);
  }
};

TEST_F(StalePointer, WhileABodyIsFollowed) {
  controls.camera.look_at({30, 0, 0});
  take({.kind = Kind::key, .code = 'B', .down = true});  // shoots
  EXPECT_EQ(controls.pointer.from, camera().eye);
  controls.camera.look_at({60, 0, 0});
  expect_small_step_of_the_wheel();
}

TEST_F(StalePointer, InFlight) {
  take({.kind = Kind::button, .code = right, .down = true, .x = 400, .y = 300});
  take({.kind = Kind::key, .code = key_w, .down = true});
  for (int i = 0; i < 100; ++i) hand.fly(0.01);
  expect_small_step_of_the_wheel();
}

}
}
