// A fixed wall put into a sleeping box went unnoticed: pairs of which nobody moves are not collided, and neither a
// fixed body that is added or placed nor a kinematic one at rest counts as moving. The box slept on inside the wall.
#include "unit/worlds.h"

namespace sudar_test {
namespace {

struct Bedroom {
  World w{sleepy()};
  Body b = w.add(cube({0, 0.5, 0}));
  Bedroom() {
    w.add(Gravity{});
    add_floor(w);
    step(w, 200);
    EXPECT_TRUE(w[b].asleep());
  }
  void expect_pushed_out() {
    EXPECT_FALSE(w[b].asleep());
    step(w, 300);
    EXPECT_GT(w[b].center().x, 0.08);
  }
};

TEST(ObstacleOnSleeper, AddedOnesWake) {
  for (const Motion motion : {Motion::fixed, Motion::kinematic}) {
    Bedroom room;
    room.w.add({.shape = box({1, 1, 1}), .at = {-0.9, 0.5, 0}, .motion = motion});
    room.expect_pushed_out();
  }
}
TEST(ObstacleOnSleeper, PlacedOnesWake) {
  for (const Motion motion : {Motion::fixed, Motion::kinematic}) {
    Bedroom room;
    const Body wall = room.w.add({.shape = box({1, 1, 1}), .at = {-9, 0.5, 0}, .motion = motion});
    step(room.w, 1);
    ASSERT_TRUE(room.w[room.b].asleep());
    room.w.place(wall, {{-0.9, 0.5, 0}, {}});
    room.expect_pushed_out();
  }
}
TEST(ObstacleOnSleeper, HalfSpacesWake) {
  Bedroom room;
  room.w.add({.shape = half_space(),
              .at = {-0.4, 0, 0},
              .turn = axis_angle(Vec3{0, 0, 1}, Real(-pi / 2)),
              .motion = Motion::fixed});
  room.expect_pushed_out();
}

}
}
