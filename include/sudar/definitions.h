// What a world is made of, as plain data: bodies, joints, forces, sensors, settings. Aggregates with useful defaults:
//   BodyDef{.shape = sphere(0.5), .at = {0, 4, 0}, .material = {.restitution = 0.8}}
// (Every field has an initialiser, be it {}: else -Wextra would complain about the fields that a user leaves out.)
// SI units, radians. Each aggregate is described once, by describe(), below it: that one list makes the errors that name
// a field, the recordings, the command line's --config and the inspector.
#pragma once

#include <sudar/shape.h>

#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace sudar::inline SUDAR_PRECISION {

// T is U or const U: lets one describe() serve readers and writers.
template <class T, class U>
concept Like = std::is_same_v<std::remove_const_t<T>, U>;

inline constexpr double infinite = std::numeric_limits<double>::infinity();
// The largest number that can be worked with; products of a mass, that is momenta and forces, may reach its square. A sum
// of a few such squares is finite, and in double, in which shapes are compared, that of fourth powers.
inline constexpr double greatest = sizeof(Real) == 4 ? 0x1p62 : 0x1p250;  // about 5·10¹⁸ and 2·10⁷⁵

// What a described number may be, or the length of a vector. `above` excludes the lower end.
struct Range {
  double low = -infinite, high = infinite;  // a number is finite in any case
  bool above = false;
};
inline constexpr Range any{-greatest, greatest};
inline constexpr Range positive{0, greatest, true};
inline constexpr Range not_negative{0, greatest};
inline constexpr Range invertible{1 / greatest, greatest};
// Of these the world looks at the products (src/world/physical.h).
inline constexpr Range any_finite{};
inline constexpr Range massive{0, infinite};
inline constexpr Range fraction{0, 1};
struct UnitLength {};  // a direction: must have length 1 within 1e-3
inline constexpr UnitLength unit_length{};
struct OrInfinite {};  // not negative, and infinity is allowed: no limit
inline constexpr OrInfinite or_infinite{};
struct NotNan {};  // any number, infinities too
inline constexpr NotNan not_nan{};
struct MayBeMissing {};
inline constexpr MayBeMissing may_be_missing{};

// --- bodies ---

enum class Motion : std::uint8_t {
  dynamic,    // moved by forces and impulses
  kinematic,  // moves with its velocity and spin, whatever it meets
  fixed,      // never moves
};
inline const char* const* names(Motion) { static constexpr const char* n[] = {"dynamic", "kinematic", "fixed", nullptr}; return n; }

struct Material {
  Real friction_static = Real(0.6);   // Coulomb, largest tangential / normal force without slip
  Real friction_dynamic = Real(0.6);  // the same while slipping
  Real restitution = 0;               // relative normal speed after / before an impact
  Real rolling = 0;                   // m: torque that resists rolling / normal force
  Real spinning = 0;                  // m: torque that resists spinning about the normal / normal force
};
template <class V, Like<Material> T>
void describe(V& v, T& d) {
  v("friction_static", d.friction_static, not_negative);
  v("friction_dynamic", d.friction_dynamic, not_negative);
  v("restitution", d.restitution, fraction);
  v("rolling", d.rolling, not_negative);
  v("spinning", d.spinning, not_negative);
}

// Two bodies may touch when each one's category is in the other's mask; but bodies of the same non-zero group always
// touch if it is positive and never if it is negative.
struct Filter {
  std::uint32_t category = 1, mask = 0xffffffffu;
  std::int32_t group = 0;
};
template <class V, Like<Filter> T>
void describe(V& v, T& d) {
  v("category", d.category, any);
  v("mask", d.mask, any);
  v("group", d.group, any);
}

// One of the shapes of a body that has several. What it leaves out is the body's.
struct ShapeDef {
  Shape shape{};
  Vec3 at{};                                // of the shape's frame, in the body's, m
  Quat turn{};                              // of the shape's frame, against the body's
  std::optional<Real> density{};            // kg/m³; parts of a body whose mass is given share it by volume times this
  std::optional<Material> material{};
  std::optional<Vec3> surface_velocity{};   // m/s, shape's axes
  std::optional<Filter> filter{};
};
template <class V, Like<ShapeDef> T>
void describe(V& v, T& d) {
  v("shape", d.shape, any);
  v("at", d.at, any);
  v("turn", d.turn, unit_length);
  v("density", d.density, Range{0, infinite, true});
  v("material", d.material, any);
  v("surface_velocity", d.surface_velocity, any);
  v("filter", d.filter, any);
}

// A body's frame is that of its shape; where it has several, each lies in the body's frame. Its mass, centre and inertia
// are the sums over its shapes, as if they did not overlap.
struct BodyDef {
  Shape shape{};
  std::vector<ShapeDef> shapes{};  // of a body that has several, instead of `shape`
  Pos at{};                        // of the body's frame, m
  Quat turn{};                     // of the body's frame
  Vec3 velocity{};                 // of the centre of mass, m/s
  Vec3 spin{};                     // angular velocity, rad/s, world axes
  Real density = 1000;             // kg/m³; used where mass is 0
  Real mass = 0;                   // kg; 0: from density
  std::optional<Vec3> center{};    // of mass, in the body's frame, m; none: the shapes'
  std::optional<Mat3> inertia{};   // about the centre of mass, body's axes, kg m²; none: the shapes'
  Material material{};
  Vec3 surface_velocity{};         // of the surface along itself while the body stands, like a belt's; m/s, body's axes
  Filter filter{};
  Motion motion = Motion::dynamic;
  Real gravity_factor = 1;         // times what Gravity does to it: 0 for what floats, negative for what rises
  bool sleeps = true;              // may be put to sleep where the world sleeps
  std::string name{};
};
template <class V, Like<BodyDef> T>
void describe(V& v, T& d) {
  v("shape", d.shape, may_be_missing);
  v("shapes", d.shapes, any);
  v("at", d.at, any);
  v("turn", d.turn, unit_length);
  v("velocity", d.velocity, any);
  v("spin", d.spin, any);
  v("density", d.density, Range{0, infinite, true});
  v("mass", d.mass, massive);
  v("center", d.center, any);
  v("inertia", d.inertia, any);
  v("material", d.material, any);
  v("surface_velocity", d.surface_velocity, any);
  v("filter", d.filter, any);
  v("motion", d.motion, any);
  v("gravity_factor", d.gravity_factor, Range{-1e6, 1e6});
  v("sleeps", d.sleeps, any);
  v("name", d.name, any);
}

// --- joints: a and b are bodies, a null body is the world; anchors and axes are given in world coordinates at creation ---

// The free coordinate of a hinge [rad] or slider [m], 0 at creation, is kept within low…high.
struct Limit {
  Real low = -std::numeric_limits<Real>::infinity(), high = std::numeric_limits<Real>::infinity();
};
template <class V, Like<Limit> T>
void describe(V& v, T& d) {
  v("low", d.low, not_nan);
  v("high", d.high, not_nan);
}

// What a joint's free coordinate is driven to, with at most `force` [N or N·m].
enum class DriveMode : std::uint8_t {
  off,
  speed,   // `target` is a speed, m/s or rad/s
  servo,   // `target` is a coordinate, m or rad; approached as fast as the force lets it stop there
  spring,  // `target` is a coordinate; pulled there by stiffness · (target − coordinate) + damping · (rate − its),
           // implicitly, less what a change of its rate takes to turn the armature
};
inline const char* const* names(DriveMode) {
  static constexpr const char* n[] = {"off", "speed", "servo", "spring", nullptr};
  return n;
}
struct Drive {
  DriveMode mode = DriveMode::off;
  Real target = 0;
  Real force = 0;
  Real max_speed = std::numeric_limits<Real>::infinity();  // of a servo, m/s or rad/s
  Real stiffness = 0, damping = 0;                         // of a spring, N/m and N s/m, or N m/rad and N m s/rad
  Real rate = 0;                                           // of a spring, at which damping does nothing: m/s or rad/s
  Real armature = 0;  // of a spring: inertia along the coordinate alone, as of a rotor behind a gear, kg or kg m²
};
template <class V, Like<Drive> T>
void describe(V& v, T& d) {
  v("mode", d.mode, any);
  v("target", d.target, any);
  v("force", d.force, or_infinite);
  v("max_speed", d.max_speed, or_infinite);
  v("stiffness", d.stiffness, not_negative), v("damping", d.damping, not_negative);
  v("rate", d.rate, any), v("armature", d.armature, not_negative);
}

struct Bar {  // keeps the distance between two points: thesis (3.22)
  Body a{}, b{};
  Pos at_a{}, at_b{};
  bool collide = false;  // may the two bodies touch each other?
};
struct Rope {  // keeps the distance between two points at most at `length`; 0: the distance at creation
  Body a{}, b{};
  Pos at_a{}, at_b{};
  Real length = 0;
  bool collide = false;
};
struct Ball {  // keeps two points together: thesis (3.23), fig. 3
  Body a{}, b{};
  Pos at{};
  bool collide = false;
};
struct Hinge {  // a ball joint that turns about one axis only: thesis (3.24), fig. 3
  Body a{}, b{};
  Pos at{};
  Vec3 axis{0, 0, 1};
  Limit limit{};
  Drive drive{};
  bool collide = false;
};
struct Slider {  // b slides along the axis, without turning against a
  Body a{}, b{};
  Pos at{};
  Vec3 axis{1, 0, 0};
  Limit limit{};
  Drive drive{};
  bool collide = false;
};
struct Fixed {  // b does not move against a
  Body a{}, b{};
  Pos at{};
  bool collide = false;
};
struct Plane {  // keeps a point of b in a plane of a
  Body a{}, b{};
  Pos at{};
  Vec3 normal{0, 1, 0};
  bool collide = false;
};
struct Muscle {  // drives the distance between two points
  Body a{}, b{};
  Pos at_a{}, at_b{};
  Drive drive{};
  bool collide = false;
};
struct Pulley {  // a rope from a over two points of the world to b: |at_a − over_a| + ratio |at_b − over_b| ≤ length
  Body a{}, b{};
  Pos at_a{}, over_a{}, over_b{}, at_b{};
  Real ratio = 1;   // of a block and tackle: b rises by 1/ratio of what a sinks
  Real length = 0;  // m; 0: that at creation
  bool collide = false;
};
struct Reel {  // a rope from a that winds on an axle of b, without slipping; taut at creation
  Body a{}, b{};
  Pos at_a{};              // where it is tied
  Pos at{};                // on the axle's line
  Vec3 axis{0, 0, 1};      // of the axle; b turning about it in the positive sense lets rope out
  Real radius = Real(0.1); // of the axle, m
  bool collide = false;
};

// The following hold less than a hinge or slider, or nothing: beside other joints of the same bodies they limit and
// drive single coordinates of these. A ball with two azimuths and a tilt has the three angles of a gimbal.
struct Orientation {  // b does not turn against a, and goes where it likes
  Body a{}, b{};
  Pos at{};  // where it is shown
  bool collide = false;
};
struct Azimuth {  // the angle of a direction of b about an axis of a; 0 at creation, unwound
  Body a{}, b{};
  Pos at{};                 // where it is shown
  Vec3 axis{0, 0, 1};       // of a
  Vec3 direction{1, 0, 0};  // of b, not along the axis
  Limit limit{};
  Drive drive{};
  bool collide = false;
};
struct Tilt {  // the angle between an axis of a and a direction of b: 0…π, also in limit and drive
  Body a{}, b{};
  Pos at{};  // where it is shown
  Vec3 axis{0, 0, 1};
  Vec3 direction{1, 0, 0};
  Limit limit{};
  Drive drive{};
  bool collide = false;
};
struct Stroke {  // the way of a point of b along an axis of a, 0 at creation
  Body a{}, b{};
  Pos at{};
  Vec3 axis{1, 0, 0};
  Limit limit{};
  Drive drive{};
  bool collide = false;
};
using JointDef = std::variant<Bar, Rope, Ball, Hinge, Slider, Fixed, Plane, Muscle, Pulley, Reel, Orientation, Azimuth,
                              Tilt, Stroke>;

template <class V, Like<Bar> T>
void describe(V& v, T& d) {
  v("a", d.a, any), v("b", d.b, any);
  v("at_a", d.at_a, any), v("at_b", d.at_b, any);
  v("collide", d.collide, any);
}
template <class V, Like<Rope> T>
void describe(V& v, T& d) {
  v("a", d.a, any), v("b", d.b, any);
  v("at_a", d.at_a, any), v("at_b", d.at_b, any);
  v("length", d.length, not_negative);
  v("collide", d.collide, any);
}
template <class V, Like<Muscle> T>
void describe(V& v, T& d) {
  v("a", d.a, any), v("b", d.b, any);
  v("at_a", d.at_a, any), v("at_b", d.at_b, any);
  v("drive", d.drive, any);
  v("collide", d.collide, any);
}
template <class V, Like<Pulley> T>
void describe(V& v, T& d) {
  v("a", d.a, any), v("b", d.b, any);
  v("at_a", d.at_a, any), v("over_a", d.over_a, any), v("over_b", d.over_b, any), v("at_b", d.at_b, any);
  v("ratio", d.ratio, invertible), v("length", d.length, not_negative);
  v("collide", d.collide, any);
}
template <class V, Like<Reel> T>
void describe(V& v, T& d) {
  v("a", d.a, any), v("b", d.b, any);
  v("at_a", d.at_a, any), v("at", d.at, any), v("axis", d.axis, unit_length), v("radius", d.radius, invertible);
  v("collide", d.collide, any);
}
template <class V, class T>
requires(Like<T, Ball> || Like<T, Fixed> || Like<T, Orientation>) void describe(V& v, T& d) {
  v("a", d.a, any), v("b", d.b, any);
  v("at", d.at, any);
  v("collide", d.collide, any);
}
template <class V, class T>
requires(Like<T, Hinge> || Like<T, Slider> || Like<T, Stroke>) void describe(V& v, T& d) {
  v("a", d.a, any), v("b", d.b, any);
  v("at", d.at, any), v("axis", d.axis, unit_length);
  v("limit", d.limit, any), v("drive", d.drive, any);
  v("collide", d.collide, any);
}
template <class V, class T>
requires(Like<T, Azimuth> || Like<T, Tilt>) void describe(V& v, T& d) {
  v("a", d.a, any), v("b", d.b, any);
  v("at", d.at, any), v("axis", d.axis, unit_length), v("direction", d.direction, unit_length);
  v("limit", d.limit, any), v("drive", d.drive, any);
  v("collide", d.collide, any);
}
template <class V, Like<Plane> T>
void describe(V& v, T& d) {
  v("a", d.a, any), v("b", d.b, any);
  v("at", d.at, any), v("normal", d.normal, unit_length);
  v("collide", d.collide, any);
}

// --- forces: constant during a step unless said otherwise ---

struct Gravity {  // the same everywhere: thesis (3.5)
  Vec3 acceleration{0, Real(-9.81), 0};  // m/s²
};
// Resistance of a still medium: F = −(A + B|v|) v and the angular twin, integrated implicitly, so that it never
// overshoots however long the step (thesis (3.6) with its direction restored).
struct Drag {
  Body body{};                  // null: every body
  Real linear = 0;              // A / m, 1/s
  Real quadratic = 0;           // B / m, 1/m
  Real angular = 0;             // 1/s
  Real angular_quadratic = 0;   // 1/rad
  Real angular_per_radius = 0;  // 1/(m s): adds this times the body's bounding radius to `angular`
};
struct NBody {  // every two bodies attract each other: F = G m₁ m₂ r / (r² + softening²)^(3/2) (H. Plummer 1911)
  Real gravitational_constant = Real(6.6743e-11);  // m³/(kg s²)
  Real softening = 0;                              // m
};
struct Thruster {  // a force that turns with the body
  Body body{};
  Vec3 force{};  // N, body axes
  Vec3 at{};     // m, body frame
};
using Force = std::variant<Gravity, Drag, NBody, Thruster>;

template <class V, Like<Gravity> T>
void describe(V& v, T& d) { v("acceleration", d.acceleration, any); }
template <class V, Like<Drag> T>
void describe(V& v, T& d) {
  v("body", d.body, any);
  v("linear", d.linear, not_negative), v("quadratic", d.quadratic, not_negative);
  v("angular", d.angular, not_negative), v("angular_quadratic", d.angular_quadratic, not_negative);
  v("angular_per_radius", d.angular_per_radius, not_negative);
}
template <class V, Like<NBody> T>
void describe(V& v, T& d) {
  v("gravitational_constant", d.gravitational_constant, any);
  v("softening", d.softening, not_negative);
}
template <class V, Like<Thruster> T>
void describe(V& v, T& d) { v("body", d.body, any), v("force", d.force, any_finite), v("at", d.at, any_finite); }

struct Wrench {
  Vec3 force, torque;  // N, N·m about a named point; world axes
};

// --- sensors: the prototype's, each a channel: one number a step, read by World::value and written to CSV ---

enum class SensorKind : std::uint8_t {
  acceleration,   // of a's centre of mass over the last step, m/s²
  distance,       // between the centres of a and b, m
  maximum_speed,  // of a so far, m/s
  odometer,       // length of the way of a's centre so far, m
};
inline const char* const* names(SensorKind) {
  static constexpr const char* n[] = {"acceleration", "distance", "maximum_speed", "odometer", nullptr};
  return n;
}
struct Sensor {
  SensorKind kind = SensorKind::distance;
  Body a{}, b{};  // b: null is the world's origin
  std::string name{};
};
template <class V, Like<Sensor> T>
void describe(V& v, T& d) { v("kind", d.kind, any), v("a", d.a, any), v("b", d.b, any), v("name", d.name, any); }
using SensorId = Handle<struct SensorTag>;

// --- settings ---

enum class Solver : std::uint8_t {
  impulse_2007,  // the thesis's: impulses pass by pass, contacts found in every sub-step; exact and slow
  soft_step,     // soft contacts that do not sink, found once a step; fast
};
inline const char* const* names(Solver) { static constexpr const char* n[] = {"impulse_2007", "soft_step", nullptr}; return n; }
enum class Broad : std::uint8_t {  // docs/broad_phase.md: all find the same pairs
  brute,          // every changed body against every other one
  grid,           // spatial hashing with cells of many sizes
  sweep,          // sweep and prune: end points on three axes, kept in order
  kinetic_sweep,  // the same, by the events of their motion
  tree,           // hierarchies of bounding boxes
};
inline const char* const* names(Broad) {
  static constexpr const char* n[] = {"brute", "grid", "sweep", "kinetic_sweep", "tree", nullptr};
  return n;
}
enum class Integrator : std::uint8_t {
  symplectic_euler,
  rk4,  // for bodies in islands without contacts and joints; the others use symplectic_euler
};
inline const char* const* names(Integrator) { static constexpr const char* n[] = {"symplectic_euler", "rk4", nullptr}; return n; }
enum class Mix : std::uint8_t { min, geometric, average, max };  // how the two bodies' values become the pair's
inline const char* const* names(Mix) { static constexpr const char* n[] = {"min", "geometric", "average", "max", nullptr}; return n; }

// The thesis's solver (docs/thesis.md). N₁, N₂, b, δ_max as there.
struct Impulse2007 {
  std::int32_t collision_passes = 40;        // N₁, at most
  std::int32_t contact_passes = 80;          // N₂, at most
  Real correction = Real(0.2);               // b, share of the overlap beyond slop that one sub-step removes
  Real slop = Real(0.01);                    // δ_max, m · length_unit
  Real joint_correction = Real(0.3);         // b of joints
  bool joint_correction_in_velocity = false; // joints are pulled back in the real velocity, as in the prototype's net
  bool exact_joints = true;                  // joints of what touches nothing keep energy (RATTLE); else all by passes
  bool one_point_contact = false;            // as in the thesis: a contact is one point, the centre of the overlap
  bool friction_per_increment = false;       // as in the thesis: the friction cone is tested per increment
  bool shock_propagation = false;            // a last sweep from the ground up, lower levels frozen
};
template <class V, Like<Impulse2007> T>
void describe(V& v, T& d) {
  v("collision_passes", d.collision_passes, Range{0, 100000}), v("contact_passes", d.contact_passes, Range{0, 100000});
  v("correction", d.correction, fraction), v("slop", d.slop, not_negative);
  v("joint_correction", d.joint_correction, fraction);
  v("joint_correction_in_velocity", d.joint_correction_in_velocity, any);
  v("exact_joints", d.exact_joints, any);
  v("one_point_contact", d.one_point_contact, any), v("friction_per_increment", d.friction_per_increment, any);
  v("shock_propagation", d.shock_propagation, any);
}

// The fast solver (src/dynamics/soft_step.h).
struct SoftStep {
  std::int32_t substeps = 0;     // 0: as Config::substeps says
  Real contact_frequency = 30;   // Hz, at most 1/8 of the sub-steps' rate; twice as stiff against what does not move
  Real contact_damping = 10;     // ratio ζ
  Real push_speed = 3;           // overlap is undone no faster, m/s · length_unit
  bool carry_loads = true;       // soft contacts do not sink under what they carry
  Real joint_frequency = 60;     // Hz, of joints too many to be solved exactly; at most a quarter of the sub-steps' rate
  Real joint_damping = 2;        // ratio ζ
  std::int32_t lanes = 0;        // contacts solved side by side, at most; 0: as many as the processor can; changes no bit
};
template <class V, Like<SoftStep> T>
void describe(V& v, T& d) {
  v("substeps", d.substeps, Range{0, 10000});
  v("contact_frequency", d.contact_frequency, positive), v("contact_damping", d.contact_damping, not_negative);
  v("push_speed", d.push_speed, not_negative), v("carry_loads", d.carry_loads, any);
  v("joint_frequency", d.joint_frequency, positive), v("joint_damping", d.joint_damping, not_negative);
  v("lanes", d.lanes, Range{0, 16});
}

struct Config {
  Solver solver = Solver::impulse_2007;
  Broad broad = Broad::tree;
  Integrator integrator = Integrator::symplectic_euler;
  double dt = 1.0 / 60;        // s, of World::step()
  std::int32_t substeps = 4;
  std::int32_t workers = 1;    // threads that share a step, the caller's included; changes no bit of the results
  bool sleep = true;           // quiet islands that touch or hang on something stop being computed
  Real length_unit = 1;        // how many units of length a metre has: 1000 for a scene in millimetres
  Real time_factor = 1;        // k of thesis (3.4): simulated seconds per second of step
  Mix friction_mix = Mix::geometric, restitution_mix = Mix::max;
  Impulse2007 impulse_2007{};
  SoftStep soft_step{};
};
template <class V, Like<Config> T>
void describe(V& v, T& d) {
  v("solver", d.solver, any), v("broad", d.broad, any), v("integrator", d.integrator, any);
  v("dt", d.dt, positive), v("substeps", d.substeps, Range{1, 10000});
  v("workers", d.workers, Range{1, 256});
  v("sleep", d.sleep, any);
  v("length_unit", d.length_unit, positive), v("time_factor", d.time_factor, positive);
  v("friction_mix", d.friction_mix, any), v("restitution_mix", d.restitution_mix, any);
  v("impulse_2007", d.impulse_2007, any), v("soft_step", d.soft_step, any);
}

}
