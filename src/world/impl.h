// The inside of a World: the arrays of the lower layers side by side, and the systems that only the world calls in
// sequence (stages.h). Everything that can change a later bit is saved (snapshot.cc); the rest is rebuilt by load.
#pragma once

#include <sudar/world.h>

#include <unordered_map>

#include "base/pending_set.h"
#include "base/pool.h"
#include "collision/broad/broad.h"
#include "collision/narrow/pairs.h"
#include "dynamics/impulse_2007.h"
#include "dynamics/lone_impact.h"
#include "dynamics/soft_step.h"
#include "dynamics/rest.h"
#include "dynamics/sleepers.h"
#include "world/geometry_store.h"
#include "world/ops.h"

namespace sudar::inline SUDAR_PRECISION {

// A sensor's memory: its channel's value, and what it needs of the step before.
struct SensorMemory {
  double value = 0;
  Pos position;    // of a
  Vec3d velocity;  // of a
};
template <class V, Like<SensorMemory> T>
void describe(V& v, T& d) { v("value", d.value, any), v("position", d.position, any), v("velocity", d.velocity, any); }
static_assert(sizeof(SensorMemory) == 7 * sizeof(double), "saved as bytes");

// The material of a pair that the user set.
struct PairMaterial {
  ProxyPair key;  // body slots, the smaller one first
  Material material;
};
template <class V, Like<PairMaterial> T>
void describe(V& v, T& d) { v("key", d.key, any), v("material", d.material, any); }
static_assert(sizeof(PairMaterial) == 8 + sizeof(Material), "saved as bytes");

struct BodyPair {
  std::uint32_t a, b;  // slots
};

// A pair of several parts, and whether any touched before the sub-step changed that.
struct TouchBefore {
  std::uint32_t pair;
  bool touching;
};

// A body while stage `impact` is at work.
struct ImpactPlace {
  std::uint32_t mover = 0;  // its number, if it is one
  bool is_mover = false;
  bool came = false;        // it moved when the step was solved
};

// From 1 to Handle::worlds − 1, each call the next.
std::uint32_t new_world_number();

struct World::Impl {
  // `number`: of the world, for its handles (new_world_number, or that of the world that was saved).
  Impl(const Config& c, std::uint32_t number);

  // --- state ---
  Config config;
  Bodies bodies;                        // and their shapes
  std::vector<std::string> body_names;  // by slot
  std::vector<PairMaterial> pair_materials;  // sorted; all other pairs mix theirs
  Joints joints;
  Forces forces;
  Contacts contacts;
  std::vector<Sensor> sensors;          // by slot, like the two below
  std::vector<SensorMemory> sensor_memory;
  Slots sensor_slots;
  PairTable pairs;                      // `row` is a slot of contacts
  std::vector<Proxy> proxies;           // by shape slot; their fat boxes decide which pairs exist
  std::vector<double> way;              // by shape slot: how far any of its points can have come so far, m
  std::int64_t steps = 0;
  // time = clock_start + clock_steps · clock_step: multiplied, never summed
  double clock_start = 0, clock_step = 0;
  std::int64_t clock_steps = 0;

  // --- outside the state ---
  GeometryStore geometry;
  std::uint32_t number;                 // of this world and of those loaded from it

  // --- rebuilt, or living for one step ---
  std::unique_ptr<Pool> pool = std::make_unique<Pool>();  // stays when a snapshot is loaded
  std::unique_ptr<BroadPhase> broad;
  std::vector<std::uint32_t> changed;       // proxies that are new, moved or gone since the broad phase was told
  std::vector<std::uint32_t> searched;      // those of which it was told since the last stage `pairs`
  std::vector<ProxyPair> found;             // and what it found
  JointGraph joint_graph;
  std::vector<PlaneProxy> planes;           // the half spaces, ascending
  std::vector<BodyPair> parted;             // that a new joint forbids to touch, since the last search for pairs
  std::unordered_map<std::string, std::vector<std::uint32_t>> named;  // bodies by name, ascending; only looked up
  std::vector<std::uint32_t> hollows, meshes;  // shapes that are, ascending
  std::vector<TouchBefore> touched_before;  // wholes of which parts began or ceased to touch in this sub-step
  PendingSet awake_bodies, moving_kinematic, awake_joints;
  Sleepers sleepers;
  HeldByFaces held_by_faces;
  std::vector<std::uint32_t> pushed;        // bodies whose force or torque may not be 0
  std::vector<std::uint32_t> awake, smooth, kinematic, active_joints;
  std::vector<Pose> shape_poses;            // by shape slot, as the next one
  std::vector<const Geometry*> geometries;
  std::vector<std::uint8_t> looked_at;      // by pair: in the last stage `collide`
  static constexpr std::uint8_t left_to_impact = 2;  // and it is no contact, since its impact is still to come
  std::vector<std::uint32_t> coming;        // those, by key
  std::vector<std::uint32_t> touching;      // pairs that touch and can change, island after island
  std::vector<ActiveContact> active_contacts;  // the same
  std::vector<std::uint32_t> near;          // pairs with a triangle that may touch within the step, island after island
  std::vector<ActiveContact> near_contacts; // the same
  Unions unions;
  std::vector<std::uint32_t> island_of;     // by body slot, of those awake: number in `islands`
  std::vector<Island> islands;
  double last_dt = 0;                       // of the last step
  double h = 0;                             // length of the sub-step at work, simulated s
  std::vector<ImpactPlace> impact_places;   // by body slot; as made outside stage `impact`
  std::vector<Pose> departures;             // by body slot: where what moves was before the last stage `solve`
  Impulse2007Solver impulse_2007;
  SoftStepSolver soft_step;
  LoneImpact lone_impact;
  StepOutcome outcome;
  Events events;
  Profile profile;

  // --- recording ---
  bool recording = false;
  std::vector<Operation> log;               // since the last step
  std::vector<std::uint64_t> stage_hashes;  // of the last sub-step, filled while recording

  double time() const { return clock_start + double(clock_steps) * clock_step; }
  void step(double dt);

  // Validates, performs and, while recording, keeps an operation; what throws has changed nothing.
  template <class Op>
  auto operate(const Op& op) {
    if constexpr (std::is_void_v<decltype(perform(op))>) {
      perform(op);
      if (recording) log.push_back(op);
    } else {
      const auto made = perform(op);
      if (recording) log.push_back(op);
      return made;
    }
  }
  void replay(const Operation& op);

  // operations.cc
  Body perform(const AddBody&);
  ShapeId perform(const AddShape&);
  ForceId perform(const AddForce&);
  SensorId perform(const AddSensor&);
  Joint perform(const AddJoint&);
  void perform(const RemoveBody&);
  void perform(const RemoveShape&);
  void perform(const RemoveJoint&);
  void perform(const RemoveForce&);
  void perform(const RemoveSensor&);
  void perform(const Push&);
  void perform(const Torque&);
  void perform(const Place&);
  void perform(const SetVelocity&);
  void perform(const SetSurfaceVelocity&);
  void perform(const SetPairMaterial&);
  void perform(const SetDrive&);
  void perform(const SetConfig&);
  void perform(const Wake&);
  void perform(const Load&);  // snapshot.cc

  // Throws Error(what, …) unless the handle is alive, and of this world.
  void require(Body, const char* what) const;
  void require(Joint, const char* what) const;
  void require(ShapeId, const char* what) const;
  void require(ForceId, const char* what) const;
  void require(SensorId, const char* what) const;

  // upkeep.cc
  const Geometry& geometry_of(std::uint32_t shape) const { return geometry[bodies.shapes.geometry[shape]].geometry(); }
  bool is_half_space(std::uint32_t shape) const { return geometry_of(shape).kind == ShapeKind::half_space; }
  std::uint32_t body_of(std::uint32_t shape) const { return bodies.shapes.body[shape]; }
  BodyPair bodies_of(const ProxyPair& key) const { return {body_of(key.a), body_of(key.b)}; }
  Material pair_material(const ProxyPair&) const;  // of two shapes
  // Whether contacts are looked for before every sub-step, or once a step.
  bool detects_each_substep() const {
    return config.solver == Solver::impulse_2007 ? Impulse2007Solver::detects_each_substep
                                                 : SoftStepSolver::detects_each_substep;
  }
  int substeps() const { return sudar::substeps(config); }
  int substeps_at_once() const { return detects_each_substep() ? 1 : substeps(); }  // that one walk over the stages makes
  StepView view();  // what stage `solve` is given
  Real step_length() const { return Real(config.dt * double(config.time_factor)); }  // simulated s
  // Of shapes.
  Vec3 velocity_of(std::uint32_t shape) const;        // of its centre of mass
  Real contact_margin(std::uint32_t shape) const;     // how near a shape at rest is felt, m
  Real pair_margin(std::uint32_t a, std::uint32_t b) const;  // how near two must be to get a contact
  Real pair_turn(std::uint32_t a, std::uint32_t b) const;    // how far they may turn in a step, rad
  // Share of a ball inside a shape that may come to lie behind a surface unseen: less than 1, so that its centre does not.
  static constexpr Real unseen_share = Real(0.75);
  // Who comes this many times as far in a (sub-)step has its impact solved at its very moment, however late that is.
  static constexpr Real leap = 4;
  Real unseen_depth(std::uint32_t a, std::uint32_t b) const;  // of the thinner of the two that impacts move, m
  Real smaller_radius(std::uint32_t a, std::uint32_t b) const;  // of those of the two whose bodies are dynamic
  Vec3 coming_way(std::uint32_t shape) const;
  void settle_boxes();                                // tells the broad phase of all changes
  bool renew_box(std::uint32_t shape, bool force);    // keeps the fat box around the shape; whether it is another one
  void touch_proxy(std::uint32_t shape, bool force);  // the same, and notes a change
  void describe_proxy(std::uint32_t shape);           // all of it but the box
  void wake_near(std::uint32_t shape);                // what sleeps where it does not move
  void enter(std::uint32_t shape);                    // it has come: box, plane, hollow
  void leave(std::uint32_t shape);                    // it goes, and its pairs
  // Of bodies.
  std::vector<std::uint32_t> pairs_of(std::uint32_t body) const;  // by key
  void end_pair(std::uint32_t pair);                 // it goes, its contact too; its bodies wake if they touched
  void note_touch(const ProxyPair&);                 // a part of it is about to begin or cease to touch
  bool forbidden(const BodyPair&) const;             // by a joint between the two
  void enlist(std::uint32_t body);                   // it moves: so its pairs and joints may change
  void enlist_joint(std::uint32_t joint);            // it has come
  void wake_island(std::uint32_t body);
  void wake_around(std::uint32_t body);              // what sleeps where a still body was put, and what hangs on it
  void wake_all();
  void rebuild();                                    // everything that is a function of the state

  // snapshot.cc
  void write_state(Writer&) const;
  void read_state(Reader&);
  void check_state() const;  // throws Error("data", …) where something would be used that is not there
  std::uint64_t hash() const;
};

// How snapshots are written, as a number: changes with every field that they gain, lose or rename. See base/file_header.h.
std::uint64_t layout_of_state();

}
