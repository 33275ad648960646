// Masses of 10³⁸ kg, pushes of 3·10³⁸ N and steps of 10⁹ s were taken, each finite, and a step later the body whose weight,
// speed or way was not was quarantined. What a number makes with what the world knows already is told at the door:
// whatever number is set to whatever value, it is refused by name, or nothing breaks in the next step. (What only shows on the
// way, like the pull of bodies that come near, a thruster's or a crash at such speeds, still ends in quarantine.)
#include <functional>

#include "unit/worlds.h"

namespace sudar_test {
namespace {

// Sets one of the numbers of a described aggregate, the n-th, and says which that was.
class Spoiler {
 public:
  Spoiler(int n, double value) : n_(n), value_(value) {}
  template <class T, class Rule>
  void operator()(const char* name, T& x, const Rule& rule) {
    const std::string outer = path_;
    path_ = path_.empty() ? name : path_ + "." + name;
    visit(x, rule);
    path_ = outer;
  }
  const std::string& field() const { return field_; }  // empty: there are not so many

 private:
  template <class T, class Rule>
  void visit(T& x, const Rule& rule) {
    if constexpr (std::is_floating_point_v<T>) {
      if (n_-- == 0) x = T(value_), field_ = path_;
    } else if constexpr (std::is_same_v<T, Vec3> || std::is_same_v<T, Pos>) {
      visit(x.x, rule), visit(x.y, rule), visit(x.z, rule);
    } else if constexpr (requires { x.has_value(); }) {
      if (x) visit(*x, rule);
    } else if constexpr (requires { describe(*this, x); }) {
      describe(*this, x);
    }
  }
  int n_;
  double value_;
  std::string path_, field_;
};

// From the largest number down through its root, and what can be worked with, to the smallest.
std::vector<double> extremes() {
  const double largest = double(std::numeric_limits<Real>::max()), root = std::sqrt(largest);
  std::vector<double> values;
  for (const double x : {largest, 0.3 * largest, 0.03 * largest, largest / 1e8, root * 1e4, root, greatest,
                         greatest / 10, greatest / 1e6, std::sqrt(root)}) {
    values.push_back(x), values.push_back(-x);
  }
  values.push_back(double(std::numeric_limits<Real>::min()));
  values.push_back(double(std::numeric_limits<Real>::denorm_min()));
  return values;
}

// A field may be refused by the name of one that it contradicts.
bool names(const std::string& refused, const std::string& spoiled) {
  constexpr std::pair<const char*, const char*> others[] = {
      {"mass", "shape"}, {"density", "shape"}, {"limit.high", "limit.low"}, {"radius", "at_a"}};
  const auto ends_with = [](const std::string& s, const std::string& end) {
    return s.size() >= end.size() && s.compare(s.size() - end.size(), end.size(), end) == 0;
  };
  for (const auto& [field, other] : others) {
    if (ends_with(spoiled, field) && ends_with(refused, other)) return true;
  }
  return ends_with(refused, spoiled);
}

struct Scene {
  World w{steady()};
  Body floor_ = add_floor(w), lying = w.add(cube({0, 0.5, 0})), hanging = w.add(cube({5, 5, 0}));
  Joint hinge = w.join(Hinge{.b = hanging, .at = {5, 6, 0}});
  Scene() {
    w.add(Gravity{});
    w.step();
  }
};

template <class Def, class Apply>
void try_all(const Def& def, Apply apply) {
  int refused = 0, taken = 0;
  for (const double value : extremes()) {
    for (int n = 0;; ++n) {
      Def d = def;
      Spoiler spoiler(n, value);
      describe(spoiler, d);
      if (spoiler.field().empty()) break;
      SCOPED_TRACE(spoiler.field() + " = " + std::to_string(value));
      Scene s;
      const std::uint64_t hash = s.w.hash();
      try {
        apply(s, d);
      } catch (const Error& e) {
        EXPECT_TRUE(names(e.field, spoiler.field())) << e.what();
        EXPECT_EQ(s.w.hash(), hash);
        ++refused;
        continue;
      }
      ++taken;
      EXPECT_TRUE(s.w.step().quarantined.empty());
    }
  }
  EXPECT_GT(refused, 0);
  EXPECT_GT(taken, 0);
}

TEST(Overflow, OfBodies) {
  const auto add = [](Scene& s, const BodyDef& d) { s.w.add(d); };
  BodyDef def = cube({0, 1.5, 0});
  try_all(def, add);
  def.mass = 0;
  try_all(def, add);
  def.center = Vec3{0, 0, 0}, def.inertia = Mat3::identity(), def.mass = 1;
  try_all(def, add);
  def.motion = Motion::kinematic, def.at.y = 3;  // clear of the others: what it crushes shows on the way only
  try_all(def, add);
  def.motion = Motion::fixed;
  try_all(def, add);
}

TEST(Overflow, OfForces) {
  const auto add = [](Scene& s, const auto& d) { s.w.add(d); };
  try_all(Gravity{}, add);
  try_all(NBody{}, add);
  try_all(Drag{}, [](Scene& s, const Drag& d) {
    s.w.add(d);
    s.w.set_velocity(s.hanging, {100, 0, 0}, {0, 100, 0});
  });
}

TEST(Overflow, OfJoints) {
  const auto join = [](Scene& s, auto d) {
    d.b = s.lying;
    s.w.join(d);
  };
  try_all(Bar{.at_a = {0, 2, 0}, .at_b = {0, 1, 0}}, join);
  try_all(Rope{.at_a = {0, 2, 0}, .at_b = {0, 1, 0}}, join);
  try_all(Ball{.at = {0, 1, 0}}, join);
  try_all(Fixed{.at = {0, 1, 0}}, join);
  try_all(Plane{.at = {0, 1, 0}}, join);
  try_all(Pulley{.at_a = {3, 1, 0}, .over_a = {3, 5, 0}, .over_b = {0, 5, 0}, .at_b = {0, 1, 0}}, join);
  try_all(Orientation{.at = {0, 1, 0}}, join);
  try_all(Reel{.at_a = {1, 5, 0}, .at = {0, 1, 0}}, join);
  for (const DriveMode mode : {DriveMode::speed, DriveMode::servo, DriveMode::spring}) {
    const Drive drive{.mode = mode, .target = 1, .force = 10, .max_speed = 1, .stiffness = 10, .damping = 1, .armature = 1};
    try_all(Hinge{.at = {0, 1, 0}, .limit = {-2, 2}, .drive = drive}, join);
    try_all(Slider{.at = {0, 1, 0}, .limit = {-2, 2}, .drive = drive}, join);
    try_all(Stroke{.at = {0, 1, 0}, .limit = {-2, 2}, .drive = drive}, join);
    try_all(Azimuth{.at = {0, 1, 0}, .limit = {-2, 2}, .drive = drive}, join);
    try_all(Tilt{.at = {0, 1, 0}, .limit = {1, 2}, .drive = drive}, join);
    try_all(Muscle{.at_a = {0, 2, 0}, .at_b = {0, 1, 0}, .drive = drive}, join);
    try_all(drive, [](Scene& s, const Drive& d) { s.w.set_drive(s.hinge, d); });
  }
}

struct Pushed {
  Vec3 force{0, 1, 0};
  Pos at{};
};
template <class V, Like<Pushed> T>
void describe(V& v, T& d) { v("force", d.force, any), v("at", d.at, any); }
struct Twisted { Vec3 torque; };
template <class V, Like<Twisted> T>
void describe(V& v, T& d) { v("torque", d.torque, any); }
struct Placed { Pos at; };
template <class V, Like<Placed> T>
void describe(V& v, T& d) { v("at", d.at, any); }
struct Moved { Vec3 velocity, spin; };
template <class V, Like<Moved> T>
void describe(V& v, T& d) { v("velocity", d.velocity, any), v("spin", d.spin, any); }
struct Carried { Vec3 surface_velocity; };
template <class V, Like<Carried> T>
void describe(V& v, T& d) { v("surface_velocity", d.surface_velocity, any); }

TEST(Overflow, OfWhatIsDoneToBodies) {
  for (const auto body : {&Scene::lying, &Scene::hanging}) {
    const Pos above = body == &Scene::lying ? Pos{0, 1, 0} : Pos{5, 5.5, 0};
    try_all(Pushed{.at = above}, [=](Scene& s, const Pushed& p) { s.w.push(s.*body, p.force, p.at); });
    try_all(Twisted{}, [=](Scene& s, const Twisted& t) { s.w.twist(s.*body, t.torque); });
    try_all(Placed{}, [=](Scene& s, const Placed& p) { s.w.place(s.*body, {p.at, {}}); });
    try_all(Moved{}, [=](Scene& s, const Moved& m) { s.w.set_velocity(s.*body, m.velocity, m.spin); });
  }
  try_all(Carried{}, [](Scene& s, const Carried& c) { s.w.set_surface_velocity(s.floor_, c.surface_velocity); });
  try_all(Material{}, [](Scene& s, const Material& m) { s.w.set_pair_material(s.lying, s.floor_, m); });
}

TEST(Overflow, OfSettings) {
  try_all(Config{}, [](Scene& s, const Config& c) { s.w.set_config(c); });
}

std::string refused(const std::function<void(World&)>& what, bool gravity = true) {
  World w(steady());
  if (gravity) w.add(Gravity{});
  try {
    what(w);
    EXPECT_TRUE(w.step().quarantined.empty());
    return "";
  } catch (const Error& e) { return e.field; }
}

// The products, each of two numbers that are good alone; and their like that the precision does hold.
TEST(Overflow, OfProducts) {
  const double scale = by_precision(1, 1e113);  // to the square of `greatest`
  const auto body = [](Real mass, Vec3 velocity = {}) {
    return [=](World& w) { w.add({.shape = box({1, 1, 1}), .velocity = velocity, .mass = mass}); };
  };
  EXPECT_EQ(refused(body(Real(1e38 * scale))), "mass");
  EXPECT_EQ(refused(body(Real(1e36 * scale))), "");
  EXPECT_EQ(refused(body(Real(1e36 * scale), {1000, 0, 0})), "velocity");
  // An inertia that cannot be is told before a mass that cannot be.
  const Real much = Real(2e38 * scale);
  EXPECT_EQ(refused([&](World& w) {
    w.add({.shape = box({1, 1, 1}), .mass = much, .inertia = Mat3::diagonal({much, 1, 1})});
  }), "inertia");
  const auto push = [](Real mass, Real force) {
    return [=](World& w) { w.push(w.add({.shape = box({1, 1, 1}), .mass = mass}), {force, 0, 0}, {}); };
  };
  EXPECT_EQ(refused(push(1, Real(3e38 * scale))), "force");
  EXPECT_EQ(refused(push(1, Real(1e30 * scale))), "force");
  EXPECT_EQ(refused(push(Real(1e24 * scale), Real(1e30 * scale))), "");
  // Two pushes add up.
  EXPECT_EQ(refused([&](World& w) {
    const Body b = w.add({.shape = box({1, 1, 1}), .mass = Real(1e24 * scale)});
    for (int i = 0; i < 5; ++i) w.push(b, {Real(1e37 * scale), 0, 0}, {});
  }), "force");
  EXPECT_EQ(refused([&](World& w) { w.add(cube({})), w.step(by_precision(1e9, 1e38)); }), "dt");
  EXPECT_EQ(refused([&](World& w) { w.add(cube({})), w.step(1e9); }, false), "");
  // Gravity that comes after the bodies.
  EXPECT_EQ(refused([&](World& w) { body(Real(1e36 * scale))(w), w.add(Gravity{{0, -1e4, 0}}); }), "acceleration");
  // A longer step than the one that a speed was good for.
  EXPECT_EQ(refused([&](World& w) {
    body(1, {Real(by_precision(1e15, 1e72)), 0, 0})(w);
    w.step(1e5);
  }, false), "dt");
}

}
}
