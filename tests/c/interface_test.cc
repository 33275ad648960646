// The C interface: fields by path, errors that name the field, handles that know what they are of, the same bits.
#include <sudar.h>

#include <sudar/world.h>

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace {

using World = std::unique_ptr<sudar_world, decltype(&sudar_world_free)>;
using Definition = std::unique_ptr<sudar_definition, decltype(&sudar_definition_free)>;
using Shape = std::unique_ptr<sudar_shape, decltype(&sudar_shape_free)>;

World world(const sudar_definition* config = nullptr) { return {sudar_world_new(config), sudar_world_free}; }
Definition define(const char* kind) { return {sudar_define(kind), sudar_definition_free}; }
Definition ball(double x) {
  Definition d = define("body");
  const Shape s(sudar_sphere(0.5), sudar_shape_free);
  EXPECT_EQ(sudar_set_shape(d.get(), "shape", s.get()), 0);
  const double at[] = {x, 0, 0};
  EXPECT_EQ(sudar_set_numbers(d.get(), "at", 3, at), 0);
  return d;
}

TEST(C, SetsEveryKindOfField) {
  const Definition body = ball(1);
  const double center[] = {0, 0.1, 0}, inertia[] = {1, 0, 0, 0, 2, 0, 0, 0, 2.5};
  EXPECT_EQ(sudar_set_number(body.get(), "mass", 3), 0);
  EXPECT_EQ(sudar_set_number(body.get(), "sleeps", 0), 0);
  EXPECT_EQ(sudar_set_number(body.get(), "filter.group", -2), 0);
  EXPECT_EQ(sudar_set_number(body.get(), "material.restitution", 0.5), 0);
  EXPECT_EQ(sudar_set_numbers(body.get(), "center", 3, center), 0);
  EXPECT_EQ(sudar_set_numbers(body.get(), "inertia", 9, inertia), 0);
  EXPECT_EQ(sudar_set_text(body.get(), "motion", "kinematic"), 0);
  EXPECT_EQ(sudar_set_text(body.get(), "name", "one"), 0);
  const World w = world();
  EXPECT_NE(sudar_add(w.get(), body.get()), SUDAR_NONE) << sudar_error();

  sudar::World other;
  other.add({.shape = sudar::sphere(sudar::Real(0.5)),
             .at = {1, 0, 0},
             .mass = 3,
             .center = sudar::Vec3{0, sudar::Real(0.1), 0},
             .inertia = sudar::Mat3::diagonal({1, 2, sudar::Real(2.5)}),
             .material = {.restitution = sudar::Real(0.5)},
             .filter = {.group = -2},
             .motion = sudar::Motion::kinematic,
             .sleeps = false,
             .name = "one"});
  EXPECT_EQ(sudar_hash(w.get()), other.hash());
}

TEST(C, NamesTheFieldThatIsWrong) {
  const Definition body = ball(0), hinge = define("hinge"), config = define("config");
  const double two[] = {1, 2};
  const auto wrong = [](int result, const char* field) {
    EXPECT_EQ(result, -1);
    EXPECT_STREQ(sudar_error_field(), field);
    EXPECT_NE(std::string(sudar_error()).find(field), std::string::npos);
  };
  wrong(sudar_set_number(body.get(), "colour", 1), "colour");
  wrong(sudar_set_number(body.get(), "material.colour", 1), "material.colour");
  wrong(sudar_set_number(body.get(), "material", 1), "material");
  wrong(sudar_set_number(body.get(), "mass.x", 1), "mass.x");
  wrong(sudar_set_number(body.get(), "motion", 1), "motion");
  wrong(sudar_set_number(body.get(), "sleeps", 2), "sleeps");
  wrong(sudar_set_number(config.get(), "substeps", 1.5), "substeps");
  wrong(sudar_set_number(config.get(), "substeps", NAN), "substeps");
  wrong(sudar_set_text(body.get(), "motion", "flying"), "motion");
  wrong(sudar_set_numbers(body.get(), "at", 2, two), "at");
  wrong(sudar_set_shape(body.get(), "at", nullptr), "at");
  wrong(sudar_set_number(body.get(), nullptr, 1), "path");
  wrong(sudar_set_number(nullptr, "mass", 1), "definition");
  EXPECT_EQ(sudar_define("wheelbarrow"), nullptr);
  EXPECT_STREQ(sudar_error_field(), "kind");
  EXPECT_EQ(sudar_sphere(-1), nullptr);
  EXPECT_STREQ(sudar_error_field(), "radius");
  EXPECT_EQ(sudar_set_number(config.get(), "dt", -1), 0);
  EXPECT_EQ(sudar_world_new(config.get()), nullptr);
  EXPECT_STREQ(sudar_error_field(), "dt");
  const World w = world();
  EXPECT_EQ(sudar_add(w.get(), hinge.get()), SUDAR_NONE);
  EXPECT_EQ(sudar_add(w.get(), config.get()), SUDAR_NONE);
  EXPECT_EQ(sudar_step(nullptr, 1), -1);
  EXPECT_EQ(sudar_hash(w.get()), sudar::World().hash());  // nothing has changed
}

TEST(C, HandlesKnowWhatTheyAreOf) {
  const World w = world();
  const sudar_handle body = sudar_add(w.get(), ball(1).get()), gravity = sudar_add(w.get(), define("Gravity").get());
  const Definition hinge = define("hinge");
  EXPECT_EQ(sudar_set_body(hinge.get(), "a", SUDAR_NONE), 0);
  EXPECT_EQ(sudar_set_body(hinge.get(), "b", gravity), -1);
  EXPECT_EQ(sudar_set_body(hinge.get(), "b", body), 0);
  const sudar_handle joint = sudar_add(w.get(), hinge.get());
  ASSERT_NE(joint, SUDAR_NONE) << sudar_error();
  double angle = 0, at[3];
  EXPECT_EQ(sudar_get_coordinate(w.get(), body, &angle), -1);
  EXPECT_EQ(sudar_get_pose(w.get(), joint, at, nullptr), -1);
  EXPECT_EQ(sudar_step(w.get(), 10), 0);
  EXPECT_EQ(sudar_get_coordinate(w.get(), joint, &angle), 0);
  EXPECT_LT(angle, -0.01);
  EXPECT_EQ(sudar_remove(w.get(), joint), 0);
  EXPECT_EQ(sudar_get_coordinate(w.get(), joint, &angle), -1);
  EXPECT_NE(std::string(sudar_error()).find("removed"), std::string::npos);
  EXPECT_EQ(sudar_remove(w.get(), gravity), 0);
  EXPECT_EQ(sudar_remove(w.get(), body), 0);
  EXPECT_EQ(sudar_get_pose(w.get(), body, at, nullptr), -1);
}

TEST(C, MovesAndAsks) {
  const World w = world();
  const sudar_handle body = sudar_add(w.get(), ball(0).get());
  const double at[] = {0, 2, 0}, turn[] = {0, 0, 1, 0}, v[] = {1, 0, 0}, spin[] = {0, 3, 0};
  EXPECT_EQ(sudar_set_pose(w.get(), body, at, turn), 0);
  EXPECT_EQ(sudar_set_velocity(w.get(), body, v, spin), 0);
  double p[3], q[4], u[3], s[3];
  EXPECT_EQ(sudar_get_pose(w.get(), body, p, q), 0);
  EXPECT_EQ(sudar_get_velocity(w.get(), body, u, s), 0);
  EXPECT_EQ(p[1], 2);
  EXPECT_EQ(q[2], 1);
  EXPECT_EQ(u[0], 1);
  EXPECT_EQ(s[1], 3);
  const double from[] = {0, 10, 0}, down[] = {0, -1, 0}, up[] = {0, 1, 0};
  sudar_handle hit = 0;
  EXPECT_EQ(sudar_ray_cast(w.get(), from, down, INFINITY, &hit, p, nullptr), 1);
  EXPECT_EQ(hit, body);
  EXPECT_NEAR(p[1], 2.5, 1e-5);
  EXPECT_EQ(sudar_ray_cast(w.get(), from, up, INFINITY, &hit, p, nullptr), 0);
  EXPECT_EQ(hit, SUDAR_NONE);
  EXPECT_EQ(sudar_ray_cast(w.get(), from, from, 1, &hit, p, nullptr), -1);
  EXPECT_EQ(sudar_push(w.get(), body, up, nullptr), 0);
  EXPECT_EQ(sudar_twist(w.get(), body, up), 0);
  EXPECT_EQ(sudar_push(w.get(), body, nullptr, nullptr), -1);
}

TEST(C, SavedAndLoadedGoesOnWithTheSameBits) {
  const World w = world(), other = world();
  sudar_add(w.get(), ball(0).get());
  sudar_add(w.get(), define("gravity").get());
  sudar_step(w.get(), 5);
  std::vector<char> data(sudar_save(w.get(), nullptr, 0));
  ASSERT_GT(data.size(), 100u);
  EXPECT_EQ(sudar_save(w.get(), data.data(), data.size()), data.size());
  EXPECT_EQ(sudar_load(other.get(), data.data(), data.size() / 2), -1);
  EXPECT_EQ(sudar_load(other.get(), data.data(), data.size()), 0);
  sudar_step(w.get(), 5);
  sudar_step(other.get(), 5);
  EXPECT_EQ(sudar_hash(w.get()), sudar_hash(other.get()));
  EXPECT_EQ(sudar_time(w.get()), sudar_time(other.get()));
}

}
