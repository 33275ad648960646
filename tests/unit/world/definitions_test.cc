// Bad definitions and dead handles come back as an Error that names the field, and nothing half-made stays.
#include <functional>

#include "unit/worlds.h"

namespace sudar_test {
namespace {

const Real nan = std::numeric_limits<Real>::quiet_NaN(), infinity = std::numeric_limits<Real>::infinity();
const Real huge = std::numeric_limits<Real>::max(), tiny = std::numeric_limits<Real>::denorm_min();

struct Scene {
  World w{sleepy()};
  Body a = w.add(cube({0, 0.5, 0})), b = w.add(cube({3, 0.5, 0}));
  Body floor_ = add_floor(w), wall = w.add({.shape = box({1, 1, 1}), .at = {9, 0, 0}, .motion = Motion::fixed});
  Body dead = w.add(cube({5, 5, 5}));
  Joint ball = w.join(Ball{.a = a, .b = b, .at = {1.5, 0.5, 0}});
  Joint dead_joint = w.join(Ball{.a = a, .b = dead, .at = {1.5, 0.5, 0}});
  ForceId gravity = w.add(Gravity{}), dead_force = w.add(Gravity{});
  SensorId dead_sensor = w.add(Sensor{.a = dead});
  Scene() {
    w.remove(dead), w.remove(dead_force);  // the joint and the sensor go with the body
    step(w, 3);
  }
};

struct Case {
  const char* field;
  std::function<void(Scene&)> what;
};

void expect_refused(const std::vector<Case>& cases) {
  Scene scene;
  const std::uint64_t hash = scene.w.hash();
  const Bytes saved = scene.w.save();
  int number = 0;
  for (const Case& c : cases) {
    try {
      c.what(scene);
      ADD_FAILURE() << "case " << number << " was taken: " << c.field;
    } catch (const Error& e) {
      EXPECT_EQ(e.field, c.field) << "case " << number << ": " << e.what();
      EXPECT_NE(std::string(e.what()).find(c.field), std::string::npos);
    }
    ASSERT_EQ(scene.w.hash(), hash) << "case " << number << " left something: " << c.field;
    ASSERT_EQ(scene.w.save(), saved) << "case " << number << " left something: " << c.field;
    ++number;
  }
  EXPECT_TRUE(scene.w.step().quarantined.empty());
}

Case body(const char* field, const std::function<void(BodyDef&)>& spoil) {
  return {field, [spoil](Scene& s) {
            BodyDef def = cube({0, 9, 0});
            spoil(def);
            s.w.add(def);
          }};
}

// Only spheres collide with hollows; what would fall through in silence is refused instead.
TEST(Definitions, OnlySpheresGoIntoHollows) {
  const BodyDef bowl{.shape = hollow_sphere(2), .motion = Motion::fixed};
  const auto refused = [](World& w, const BodyDef& def) {
    try {
      w.add(def);
      return false;
    } catch (const Error& e) { return e.field == "shape"; }
  };
  World w;
  w.add(bowl);
  EXPECT_FALSE(refused(w, {.shape = sphere(1)}));
  EXPECT_FALSE(refused(w, {.shape = half_space(), .motion = Motion::fixed}));
  EXPECT_TRUE(refused(w, {.shape = box({1, 1, 1})}));
  EXPECT_TRUE(refused(w, {.shape = cylinder(1, 1), .at = {100, 0, 0}}));
  EXPECT_FALSE(refused(w, {.shape = box({1, 1, 1}), .filter = {.category = 2, .mask = 0}}));
  World later;
  later.add({.shape = box({1, 1, 1})});
  EXPECT_TRUE(refused(later, bowl));
}

TEST(Definitions, Bodies) {
  expect_refused({
      body("shape", [](BodyDef& d) { d.shape = {}; }),
      body("at", [](BodyDef& d) { d.at.y = std::nan(""); }),
      body("at", [](BodyDef& d) { d.at.x = std::numeric_limits<double>::infinity(); }),
      body("turn",
           [](BodyDef& d) {
             d.turn = {0, 0, 0, 0};
           }),
      body("turn",
           [](BodyDef& d) {
             d.turn = {0, 0, 0, 2};
           }),
      body("turn", [](BodyDef& d) { d.turn.w = nan; }),
      body("velocity", [](BodyDef& d) { d.velocity.z = nan; }),
      body("velocity", [](BodyDef& d) { d.velocity.z = infinity; }),
      body("spin", [](BodyDef& d) { d.spin.x = nan; }),
      body("spin", [](BodyDef& d) { d.spin.x = huge; }),
      body("density", [](BodyDef& d) { d.density = 0; }),
      body("density", [](BodyDef& d) { d.density = -1; }),
      body("density", [](BodyDef& d) { d.density = infinity; }),
      body("density",
           [](BodyDef& d) {
             d.mass = 0, d.density = huge, d.shape = box({9, 9, 9});
           }),
      body("density", [](BodyDef& d) { d.mass = 0, d.density = tiny; }),
      body("mass", [](BodyDef& d) { d.mass = -1; }),
      body("mass", [](BodyDef& d) { d.mass = nan; }),
      body("mass", [](BodyDef& d) { d.mass = infinity; }),
      body("mass", [](BodyDef& d) { d.mass = tiny; }),
      body("shape",
           [](BodyDef& d) {
             d.mass = huge, d.shape = box({9, 9, 9});
           }),
      body("material.friction_static", [](BodyDef& d) { d.material.friction_static = -1; }),
      body("material.friction_dynamic", [](BodyDef& d) { d.material.friction_dynamic = nan; }),
      body("material.restitution", [](BodyDef& d) { d.material.restitution = Real(1.01); }),
      body("material.restitution", [](BodyDef& d) { d.material.restitution = Real(-0.01); }),
      body("surface_velocity", [](BodyDef& d) { d.surface_velocity.y = infinity; }),
      body("motion", [](BodyDef& d) { d.motion = Motion(7); }),
      body("motion", [](BodyDef& d) { d.shape = half_space(); }),
      body("motion", [](BodyDef& d) { d.shape = half_space(), d.motion = Motion::kinematic; }),
      body("motion", [](BodyDef& d) { d.shape = hollow_sphere(1); }),
      body("motion", [](BodyDef& d) { d.shape = hollow_cylinder(1, 1), d.motion = Motion::kinematic; }),
      body("velocity",
           [](BodyDef& d) {
             d.motion = Motion::fixed, d.velocity = {1, 0, 0};
           }),
      body("spin",
           [](BodyDef& d) {
             d.motion = Motion::fixed, d.spin = {1, 0, 0};
           }),
      body("spin",
           [](BodyDef& d) {
             d.motion = Motion::kinematic, d.spin = {huge, huge, 0};
           }),
  });
}

// A shape that is none is refused where it is made.
TEST(Definitions, Shapes) {
  const std::vector<Vec3> flat{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  const std::vector<Vec3> broken{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, nan}};
  EXPECT_THROW(hull(flat), Error);
  EXPECT_THROW(hull(broken), Error);
  EXPECT_THROW(box({1, 0, 1}), Error);
  EXPECT_THROW(sphere(-1), Error);
  EXPECT_THROW(sphere(nan), Error);
}

TEST(Definitions, Joints) {
  expect_refused({
      {"ball.b", [](Scene& s) { s.w.join(Ball{.a = s.a, .b = s.a}); }},
      {"ball.b", [](Scene& s) { s.w.join(Ball{}); }},
      {"ball.a", [](Scene& s) { s.w.join(Ball{.a = s.dead, .b = s.b}); }},
      {"hinge.b", [](Scene& s) { s.w.join(Hinge{.a = s.a, .b = s.dead}); }},
      {"ball.a", [](Scene& s) { s.w.join(Ball{.a = s.floor_, .b = s.wall}); }},
      {"ball.a", [](Scene& s) { s.w.join(Ball{.a = s.wall}); }},
      {"ball.at",
       [](Scene& s) {
         s.w.join(Ball{.a = s.a, .at = {0, std::nan(""), 0}});
       }},
      {"hinge.axis",
       [](Scene& s) {
         s.w.join(Hinge{.a = s.a, .axis = {0, 0, 2}});
       }},
      {"hinge.axis",
       [](Scene& s) {
         s.w.join(Hinge{.a = s.a, .axis = {0, 0, 0}});
       }},
      {"slider.axis",
       [](Scene& s) {
         s.w.join(Slider{.a = s.a, .axis = {nan, 0, 0}});
       }},
      {"plane.normal",
       [](Scene& s) {
         s.w.join(Plane{.a = s.a, .normal = {0, 3, 0}});
       }},
      {"hinge.limit.low", [](Scene& s) { s.w.join(Hinge{.a = s.a, .limit = {.low = 1, .high = -1}}); }},
      {"hinge.limit.high", [](Scene& s) { s.w.join(Hinge{.a = s.a, .limit = {.high = nan}}); }},
      {"slider.limit.low", [](Scene& s) { s.w.join(Slider{.a = s.a, .limit = {.low = infinity, .high = infinity}}); }},
      {"slider.drive.force", [](Scene& s) { s.w.join(Slider{.a = s.a, .drive = {.force = -1}}); }},
      {"slider.drive.target", [](Scene& s) { s.w.join(Slider{.a = s.a, .drive = {.target = infinity}}); }},
      {"slider.drive.max_speed", [](Scene& s) { s.w.join(Slider{.a = s.a, .drive = {.max_speed = nan}}); }},
      {"slider.drive.mode", [](Scene& s) { s.w.join(Slider{.a = s.a, .drive = {.mode = DriveMode(9)}}); }},
      {"slider.drive.stiffness", [](Scene& s) { s.w.join(Slider{.a = s.a, .drive = {.stiffness = -1}}); }},
      {"pulley.ratio", [](Scene& s) { s.w.join(Pulley{.a = s.a, .b = s.b, .ratio = 0}); }},
      {"reel.radius", [](Scene& s) { s.w.join(Reel{.b = s.b, .at_a = {0, 9, 0}, .radius = -1}); }},
      {"reel.at_a", [](Scene& s) { s.w.join(Reel{.b = s.b, .at_a = {0, Real(0.5), 0}, .radius = 1}); }},
      {"azimuth.direction", [](Scene& s) { s.w.join(Azimuth{.a = s.a, .b = s.b, .axis = {0, 1, 0}, .direction = {0, 1, 0}}); }},
      {"tilt.direction", [](Scene& s) { s.w.join(Tilt{.a = s.a, .b = s.b, .direction = {0, 2, 0}}); }},
      {"stroke.drive.armature", [](Scene& s) { s.w.join(Stroke{.a = s.a, .b = s.b, .drive = {.armature = -1}}); }},
      {"rope.length", [](Scene& s) { s.w.join(Rope{.a = s.a, .length = -1}); }},
      {"bar.at_b",
       [](Scene& s) {
         s.w.join(Bar{.a = s.a, .b = s.b, .at_a = {1, 1, 1}, .at_b = {1, 1, 1}});
       }},
      {"bar.at_a",
       [](Scene& s) {
         s.w.join(Bar{.a = s.a, .b = s.b, .at_a = {std::nan(""), 1, 1}});
       }},
  });
}

TEST(Definitions, ForcesAndSensors) {
  expect_refused({
      {"acceleration",
       [](Scene& s) {
         s.w.add(Gravity{{0, nan, 0}});
       }},
      {"linear", [](Scene& s) { s.w.add(Drag{.linear = -1}); }},
      {"angular_per_radius", [](Scene& s) { s.w.add(Drag{.angular_per_radius = nan}); }},
      {"body", [](Scene& s) { s.w.add(Drag{.body = s.dead}); }},
      {"body", [](Scene& s) { s.w.add(Thruster{}); }},
      {"body", [](Scene& s) { s.w.add(Thruster{.body = s.dead}); }},
      {"force",
       [](Scene& s) {
         s.w.add(Thruster{.body = s.a, .force = {nan, 0, 0}});
       }},
      {"at",
       [](Scene& s) {
         s.w.add(Thruster{.body = s.a, .at = {infinity, 0, 0}});
       }},
      {"softening", [](Scene& s) { s.w.add(NBody{.softening = -1}); }},
      {"gravitational_constant", [](Scene& s) { s.w.add(NBody{.gravitational_constant = infinity}); }},
      {"a", [](Scene& s) { s.w.add(Sensor{}); }},
      {"a", [](Scene& s) { s.w.add(Sensor{.a = s.dead}); }},
      {"b", [](Scene& s) { s.w.add(Sensor{.a = s.a, .b = s.dead}); }},
      {"kind", [](Scene& s) { s.w.add(Sensor{.kind = SensorKind(9), .a = s.a}); }},
  });
}

TEST(Definitions, Changes) {
  expect_refused({
      {"body", [](Scene& s) { s.w.remove(s.dead); }},
      {"body", [](Scene& s) { s.w.remove(Body{}); }},
      {"joint", [](Scene& s) { s.w.remove(s.dead_joint); }},
      {"force", [](Scene& s) { s.w.remove(s.dead_force); }},
      {"sensor", [](Scene& s) { s.w.remove(s.dead_sensor); }},
      {"body",
       [](Scene& s) {
         s.w.push(s.dead, {1, 0, 0}, {});
       }},
      {"force",
       [](Scene& s) {
         s.w.push(s.a, {nan, 0, 0}, {});
       }},
      {"at",
       [](Scene& s) {
         s.w.push(s.a, {1, 0, 0}, {std::nan(""), 0, 0});
       }},
      {"body",
       [](Scene& s) {
         s.w.twist(s.dead, {1, 0, 0});
       }},
      {"torque",
       [](Scene& s) {
         s.w.twist(s.a, {0, nan, 0});
       }},
      {"body", [](Scene& s) { s.w.place(s.dead, {}); }},
      {"at",
       [](Scene& s) {
         s.w.place(s.a, {{0, std::nan(""), 0}, {}});
       }},
      {"turn",
       [](Scene& s) {
         s.w.place(s.a, {{}, {1, 1, 0, 0}});
       }},
      {"body", [](Scene& s) { s.w.set_velocity(s.dead, {}, {}); }},
      {"body", [](Scene& s) { s.w.set_surface_velocity(s.dead, {}); }},
      {"surface_velocity",
       [](Scene& s) {
         s.w.set_surface_velocity(s.a, {0, nan, 0});
       }},
      {"a", [](Scene& s) { s.w.set_pair_material(s.dead, s.a, {}); }},
      {"b", [](Scene& s) { s.w.set_pair_material(s.a, s.dead, {}); }},
      {"b", [](Scene& s) { s.w.set_pair_material(s.a, s.a, {}); }},
      {"material.restitution", [](Scene& s) { s.w.set_pair_material(s.a, s.b, Material{.restitution = 2}); }},
      {"material.friction_static", [](Scene& s) { s.w.set_pair_material(s.a, s.b, Material{.friction_static = nan}); }},
      {"body",
       [](Scene& s) {
         s.w.set_velocity(s.wall, {1, 0, 0}, {});
       }},
      {"velocity",
       [](Scene& s) {
         s.w.set_velocity(s.a, {nan, 0, 0}, {});
       }},
      {"spin",
       [](Scene& s) {
         s.w.set_velocity(s.a, {}, {0, infinity, 0});
       }},
      {"spin",
       [](Scene& s) {
         s.w.set_velocity(s.a, {}, {0, huge, 0});
       }},
      {"joint", [](Scene& s) { s.w.set_drive(s.dead_joint, {}); }},
      {"joint", [](Scene& s) { s.w.set_drive(s.ball, {}); }},
      {"body", [](Scene& s) { s.w.wake(s.dead); }},
      {"dt", [](Scene& s) { s.w.step(0); }},
      {"body", [](Scene& s) { s.w[s.dead]; }},
      {"joint", [](Scene& s) { s.w[s.dead_joint]; }},
      {"force", [](Scene& s) { s.w[s.dead_force]; }},
      {"sensor", [](Scene& s) { s.w[s.dead_sensor]; }},
      {"sensor", [](Scene& s) { s.w.value(s.dead_sensor); }},
      {"a", [](Scene& s) { s.w.touching(s.dead, s.a); }},
      {"direction",
       [](Scene& s) {
         s.w.ray_cast({}, {0, 2, 0}, 1);
       }},
  });
}

Case setting(const char* field, const std::function<void(Config&)>& spoil) {
  return {field, [spoil](Scene& s) {
            Config c = s.w.config();
            spoil(c);
            s.w.set_config(c);
          }};
}
TEST(Definitions, Settings) {
  expect_refused({
      setting("dt", [](Config& c) { c.dt = 0; }),
      setting("dt", [](Config& c) { c.dt = std::nan(""); }),
      setting("substeps", [](Config& c) { c.substeps = 0; }),
      setting("substeps", [](Config& c) { c.substeps = 10001; }),
      setting("length_unit", [](Config& c) { c.length_unit = 0; }),
      setting("time_factor", [](Config& c) { c.time_factor = -1; }),
      setting("broad", [](Config& c) { c.broad = Broad(77); }),
      setting("solver", [](Config& c) { c.solver = Solver(77); }),
      setting("friction_mix", [](Config& c) { c.friction_mix = Mix(4); }),
      setting("impulse_2007.contact_passes", [](Config& c) { c.impulse_2007.contact_passes = -1; }),
      setting("impulse_2007.correction", [](Config& c) { c.impulse_2007.correction = 2; }),
      setting("impulse_2007.slop", [](Config& c) { c.impulse_2007.slop = nan; }),
  });
  Config c;
  c.dt = -1;
  EXPECT_THROW(World{c}, Error);
}

// --- handles ---

TEST(Handles, DieWithWhatTheyName) {
  World w(steady());
  const Body a = w.add(cube({0, 0, 0})), b = w.add(cube({5, 0, 0}));
  const Joint j = w.join(Ball{.a = a, .b = b, .at = {2, 0, 0}});
  const ForceId thruster = w.add(Thruster{.body = a}), drag = w.add(Drag{.body = a}), everywhere = w.add(Drag{});
  const SensorId of_a = w.add(Sensor{.a = a}), to_a = w.add(Sensor{.a = b, .b = a}), of_b = w.add(Sensor{.a = b});
  w.remove(a);
  EXPECT_FALSE(w.alive(a));
  EXPECT_TRUE(w.alive(b));
  EXPECT_FALSE(w.alive(j));
  EXPECT_EQ(w.forces(), std::vector{everywhere});
  EXPECT_EQ(w.sensors(), std::vector{of_b});
  EXPECT_EQ(w.bodies(), std::vector{b});
  EXPECT_TRUE(w.joints().empty());
  EXPECT_THROW(w[thruster], Error);
  EXPECT_THROW(w[drag], Error);
  EXPECT_THROW(w[of_a], Error);
  EXPECT_THROW(w[to_a], Error);
  step(w, 3);
}

// A slot is used again, under another generation; nothing of the old one is left in it.
TEST(Handles, AreNotReused) {
  World w(steady());
  w.add(Gravity{});
  BodyDef def = cube({0, 0, 0});
  def.name = "first", def.velocity = {1, 2, 3};
  const Body first = w.add(def);
  w.push(first, {100, 0, 0}, {1, 1, 1});
  w.remove(first);
  const Body second = w.add(cube({1, 0, 0}));
  EXPECT_EQ(second.index, first.index);
  EXPECT_NE(second.generation, first.generation);
  EXPECT_FALSE(w.alive(first));
  EXPECT_TRUE(w.find("first").null());
  w.step();
  expect_near(w[second].velocity(), Vec3d{0, -0.0981, 0}, 1e-6);
  EXPECT_EQ(w[second].name(), "");
}

TEST(Handles, NullIsDead) {
  World w;
  EXPECT_FALSE(w.alive(Body{}));
  EXPECT_FALSE(w.alive(Joint{}));
  EXPECT_TRUE(Body{}.null());
}

}
}
