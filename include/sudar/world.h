// The world: bodies, joints and forces that move in steps. Owns everything, may be moved, is not shared between threads.
//   World w;
//   w.add(Gravity{});
//   Body b = w.add({.shape = sphere(0.5), .at = {0, 4, 0}});
//   for (int i = 0; i < 600; ++i) w.step();
//   w[b].pose().p.y;
// Bad data throws Error (base.h) and changes nothing; a handle that is dead or of another world does too, and so does
// whatever is asked of a world that was moved from. Every change goes through the functions of this class, each of which is an operation that a Recorder (record.h) keeps.
#pragma once

#include <sudar/definitions.h>
#include <sudar/distance.h>
#include <sudar/profile.h>

#include <array>
#include <optional>
#include <string_view>

namespace sudar::inline SUDAR_PRECISION {

class World;

using Bytes = std::vector<std::byte>;

// What the last step reported, in an order that does not depend on machine, broad phase or threads.
struct Events {
  struct Touch {  // two bodies that began or ceased to touch (not by being removed: then the handle is dead), with
    Body a, b;    // one shape each: bodies of several shapes may touch with several pairs of them
    ShapeId shape_a, shape_b;
  };
  struct Hit {  // an impact
    Body a, b;
    Pos at;
    Vec3 normal;  // from b to a
    Real speed;   // of approach, m/s
  };
  struct Quarantined {  // a body whose state turned non-finite: it is frozen where it last was finite, and no longer collides
    Body body;
    std::string reason;
  };
  std::vector<Touch> begun, ended;
  std::vector<Hit> hits;
  std::vector<Quarantined> quarantined;
};

// One touching pair of shapes, as the last sub-step left it.
struct Contact {
  struct Point {
    Pos at;
    Real separation;      // m; negative: overlap
    Real normal_impulse;  // N·s, of the last sub-step
    Vec3 friction;        // N·s, on a
    Real cone_share;      // |friction| / (friction_static · normal_impulse): 1 is the edge of the cone
  };
  Body a, b;
  Vec3 normal;  // from b to a
  std::array<Point, 4> points;
  int count = 0;
  Real friction_static = 0, friction_dynamic = 0, restitution = 0;
  bool slipping = false;  // friction is at the edge of its cone, and the bodies move along each other
  ShapeId shape_a{}, shape_b{};
};

struct RayHit {
  Body body;
  Pos at;
  Vec3 normal;    // of the surface; of a body in which the ray starts: against the ray
  Real distance;  // m
  ShapeId shape;
};
// What a ray looks for.
struct RayQuery {
  Filter filter{0xffffffffu, 0xffffffffu, 0};  // shapes that may touch it (definitions.h); else it passes through
  bool from_inside = false;  // a shape in which it starts is hit at once; else it does not see it
  bool all = false;          // every shape on its way, nearest first; else the nearest
};

// Kinetic and potential energy [J], momentum [N·s] and angular momentum about the origin [N·m·s] of all dynamic bodies.
struct Energy {
  double kinetic = 0, potential = 0;  // potential: in Gravity and NBody
  double total() const { return kinetic + potential; }
};
struct Momentum {
  Vec3d linear, angular;
};

// How well the last step's constraints hold.
struct Quality {
  Real penetration_max = 0, penetration_mean = 0;  // m, over touching points
  Real joint_gap_max = 0, joint_gap_mean = 0;      // m, over joints
};

// A look at one of a body's shapes; valid until the world changes.
class ShapeView {
 public:
  Body body() const;
  Pose pose() const;                     // of its frame
  Transform at() const;                  // of its frame, in the body's
  const Shape& shape() const;
  Real density() const;                  // kg/m³
  const Material& material() const;
  const Vec3& surface_velocity() const;  // m/s, shape's axes
  const Filter& filter() const;

 private:
  friend class World;
  friend class BodyView;
  ShapeView(const World* w, std::uint32_t i) : world_(w), index_(i) {}
  const World* world_;
  std::uint32_t index_;
};

// A look at one body; valid until the world changes.
class BodyView {
 public:
  Pose pose() const;       // of the body's frame: that of its shape, if it has one
  Pos center() const;      // of mass
  Vec3 velocity() const;   // of the centre of mass, m/s
  Vec3 spin() const;       // rad/s, world axes
  Vec3 angular_momentum() const;  // about the centre of mass, world axes
  Vec3 velocity_at(const Pos& point) const;
  Real mass() const;       // kg; a body of half spaces and hollows has none: 0
  Mat3 inertia() const;    // about the centre of mass, world axes
  double kinetic_energy() const;
  std::vector<ShapeId> shapes() const;   // in the order in which it got them
  const Shape& shape() const;            // this and the next two: of the first of them
  const Material& material() const;
  const Vec3& surface_velocity() const;  // m/s, shape's axes
  Real radius() const;                   // of a ball about the centre of mass that holds all of them, m
  const std::string& name() const;
  Motion motion() const;
  Real gravity_factor() const;
  bool asleep() const;
  bool quarantined() const;

 private:
  friend class World;
  ShapeView first() const;
  BodyView(const World* w, std::uint32_t i) : world_(w), index_(i) {}
  const World* world_;
  std::uint32_t index_;
};

class JointView {
 public:
  const JointDef& definition() const;
  Pos anchor_a() const;      // the two anchors as they are now
  Pos anchor_b() const;
  Quat frame_a() const;      // the joint's axes on its two bodies, → world: x is the axis of a hinge, slider or plane; the
  Quat frame_b() const;      // angle of a hinge is that from a's y to b's y about it
  Real gap() const;          // how far the joint is from holding, m; of a rope or slider also how far beyond its limit
  Real coordinate() const;  // angle of a hinge, azimuth [unwound] or tilt [rad], way of a slider or stroke, length of a
                            // rope or muscle [m]; else 0
  Wrench load() const;       // that the joint exerted on its body b in the last sub-step, about anchor b

 private:
  friend class World;
  JointView(const World* w, std::uint32_t i) : world_(w), index_(i) {}
  const World* world_;
  std::uint32_t index_;
};

class World {
 public:
  explicit World(const Config& = {});
  World(World&&) noexcept;
  World& operator=(World&&) noexcept;
  ~World();

  // --- making and changing: every one is a recorded operation ---
  Body add(const BodyDef&);
  ForceId add(const Force&);
  SensorId add(const Sensor&);
  // Another shape for a body, and one less. Mass, centre of mass and inertia are renewed from the shapes at their densities
  // (a given mass had set those; a center or inertia that was given holds no more). The body goes on as it went: spin and
  // the velocity of each of its points stay, so that it gains the momentum of what is added and gives away that of
  // what is removed, as if they had moved along. Joints keep their anchors. The last shape cannot be removed.
  ShapeId add(Body, const ShapeDef&);
  void remove(ShapeId);
  Joint join(const JointDef&);
  void remove(Body);  // and its joints, forces and sensors; wakes what lay on it
  void remove(Joint);
  void remove(ForceId);
  void remove(SensorId);
  void push(Body, const Vec3& force, const Pos& at);           // N, during the next step() only
  void twist(Body, const Vec3& torque);                        // N·m, world axes, during the next step() only
  void place(Body, const Pose&);                               // of the body's frame
  void set_velocity(Body, const Vec3& velocity, const Vec3& spin);
  void set_surface_velocity(Body, const Vec3&);                // of all its shapes; m/s, body's axes
  // What holds where the two touch, with whatever shapes, instead of the mix of their materials; none: the mix again.
  void set_pair_material(Body a, Body b, const std::optional<Material>&);
  void set_drive(Joint, const Drive&);  // of a joint that has one
  void set_config(const Config&);
  void wake(Body);

  const Events& step();            // by config().dt
  const Events& step(double dt);   // s

  // --- looking ---
  const Config& config() const;
  double time() const;             // simulated seconds: the sum of dt · time_factor
  std::int64_t steps() const;
  std::vector<Body> bodies() const;
  std::vector<Joint> joints() const;
  std::vector<ForceId> forces() const;
  std::vector<SensorId> sensors() const;
  bool alive(Body) const;
  bool alive(Joint) const;
  bool alive(ShapeId) const;
  Body find(std::string_view name) const;  // null: no such body
  BodyView operator[](Body) const;
  ShapeView operator[](ShapeId) const;
  JointView operator[](Joint) const;
  const Force& operator[](ForceId) const;
  const Sensor& operator[](SensorId) const;
  double value(SensorId) const;
  std::vector<Contact> contacts() const;
  bool touching(Body, Body) const;
  Material pair_material(Body a, Body b) const;  // what holds where they touch: set, or mixed from their first shapes'
  // direction: of length 1; length: m, may be infinite. Throws Error. A ray that starts inside a shape does not see it,
  // unless the query says so.
  std::optional<RayHit> ray_cast(const Pos& from, const Vec3& direction, Real length) const;  // the nearest
  std::vector<RayHit> ray_cast(const Pos& from, const Vec3& direction, Real length, const RayQuery&) const;
  std::vector<Box> fat_boxes() const;    // of all shapes but half spaces: what the broad phase compares
  std::vector<Box> broad_boxes() const;  // what it is made of: cells or nodes; for pictures
  // For each of bodies() the smallest index among those that it hangs together with, by contacts and joints of dynamic
  // bodies.
  std::vector<std::uint32_t> islands() const;
  SignedDistance distance(Body a, Body b) const;  // between the shapes nearest to each other, touching or not (distance.h)
  Energy energy() const;
  Momentum momentum() const;
  const Events& events() const;
  const Profile& profile() const;  // of the last step
  Quality quality() const;

  // --- state: a world restored from save() goes on with the same bits ---
  Bytes save() const;
  // Replaces everything; throws Error and changes nothing when the data is bad. Recorded, as whatever changes a world.
  void load(std::span<const std::byte>);
  std::uint64_t hash() const;         // of everything that can change a later bit, settings included
  std::uint64_t motion_hash() const;  // of the poses and velocities of all bodies: equal across broad phases

  struct Impl;  // src/world/impl.h
  Impl& impl() { return *impl_; }
  const Impl& impl() const { return *impl_; }

 private:
  // A pointer that knows when there is nothing behind it.
  class Inside {
   public:
    Inside& operator=(std::unique_ptr<Impl>);
    Impl& operator*() const {  // throws Error in a world that was moved from
      if (!p_) throw Error("world", "is empty: it was moved from");
      return *p_;
    }
    Impl* operator->() const { return &**this; }

   private:
    std::unique_ptr<Impl> p_;
  };
  Inside impl_;
};

}
