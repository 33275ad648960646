// Data that was taken and led to NaN or to the wrong thing: each comes back as an Error that names the field.
#include <sudar/session.h>

#include <functional>

#include "unit/worlds.h"

namespace sudar_test {
namespace {

void expect_refused(const char* field, const std::function<void(World&)>& what) {
  World w(steady());
  const std::uint64_t hash = w.hash();
  try {
    what(w);
    ADD_FAILURE() << field << " was taken";
  } catch (const Error& e) {
    EXPECT_EQ(e.field, field) << e.what();
    EXPECT_EQ(w.hash(), hash);
  }
}

// A step so short that it is zero in single precision divided by zero.
TEST(BadData, StepThatThePrecisionCannotHold) {
  expect_refused("dt", [](World& w) { w.step(std::numeric_limits<double>::denorm_min()); });
  expect_refused("dt", [](World& w) { w.step(by_precision(1e300, infinite)); });
  expect_refused("dt", [](World& w) { w.step(-1); });
  expect_refused("dt", [](World& w) { w.step(std::nan("")); });
}

// A limit from infinity on, or up to minus infinity, can never be met.
TEST(BadData, LimitThatNothingMeets) {
  const Real infinity = std::numeric_limits<Real>::infinity();
  for (const Limit limit : {Limit{infinity, infinity}, Limit{-infinity, -infinity}}) {
    World w(steady());
    const Body b = w.add(cube({0, 0, 0}));
    EXPECT_THROW(w.join(Hinge{.b = b, .limit = limit}), Error);
  }
}

// An anchor at 10⁵⁰ m is a finite position, but not a finite arm in single precision.
TEST(BadData, AnchorOutOfReach) {
  World w(steady());
  const Body b = w.add(cube({0, 0, 0}));
  const std::uint64_t hash = w.hash();
  const double far = by_precision(1e50, 1e308);
  try {
    w.join(Ball{.b = b, .at = {far, 0, 0}});
    ADD_FAILURE() << "taken";
  } catch (const Error& e) {
    EXPECT_EQ(e.field, "ball.at");
    EXPECT_EQ(w.hash(), hash);
  }
}

// Every body without a name is called "", and so none is.
TEST(BadData, NobodyIsCalledNothing) {
  World w(steady());
  w.add(cube({0, 0, 0}));
  EXPECT_TRUE(w.find("").null());
}

TEST(BadData, RaysThatAreNone) {
  World w(steady());
  w.add(cube({0, 0, 0}));
  EXPECT_THROW(w.ray_cast({std::nan(""), 0, 0}, {1, 0, 0}, 10), Error);
  EXPECT_THROW(w.ray_cast({-2, 0, 0}, {1, 0, 0}, Real(std::nan(""))), Error);
  EXPECT_THROW(w.ray_cast({-2, 0, 0}, {1, 0, 0}, -1), Error);
  EXPECT_TRUE(w.ray_cast({-2, 0, 0}, {1, 0, 0}, std::numeric_limits<Real>::infinity()));
}

// Converted to an integer without a look at its size: whatever the processor makes of it.
TEST(BadData, SettingsThatNoIntegerHolds) {
  Config c;
  for (const char* value : {"1e99", "-1e99", "nan", "inf", "2147483648"}) {
    EXPECT_THROW(set_field(c, "substeps", value), Error) << value;
  }
  EXPECT_THROW(set_field(c, "dt", "nan"), Error);
}

// A key without a name was held.
TEST(BadData, KeysWithoutAName) {
  for (const char* script : {"0:up+", "0:+up", "0:up++left"}) EXPECT_THROW(KeyScript{script}, Error) << script;
}

}
}
