// Joints: state by slot (fields.def), and what a joint demands where it is now, as rows. Solvers consume the rows; which
// joint it was they never ask.
#pragma once

#include "dynamics/bodies.h"
#include "dynamics/parts.h"

namespace sudar::inline SUDAR_PRECISION {

// Accumulated in the last sub-step: the block's rows, the two ends of the limit, the drive. On a; b gets the opposite.
struct JointImpulse {
  std::array<Real, 6> rows{};
  Real low = 0, high = 0, drive = 0;
  // Of the impacts before it, the block's rows and the limit: part of the load, never warm-started.
  std::array<Real, 6> struck{};
  Real struck_limit = 0;
};
template <class V, Like<JointImpulse> T>
void describe(V& v, T& d) {
  v("rows", d.rows, any), v("low", d.low, any), v("high", d.high, any), v("drive", d.drive, any);
  v("struck", d.struck, any), v("struck_limit", d.struck_limit, any);
}

struct Joints {
#define JOINT_FIELD(type, name, unit, stage) std::vector<type> name;
#include "dynamics/fields.def"
  std::vector<JointDef> definition;
  Slots slots;

  // Makes a joint of the validated definition between bodies where they are now.
  std::uint32_t add(const JointDef& def, const Bodies& bodies);
  void remove(std::uint32_t i) { slots.give_back(i); }
  std::uint32_t size() const { return slots.size(); }
  // The body's frame has changed: old → new.
  void turn_frame(std::uint32_t i, std::uint32_t body, const Transform& to_new);
  bool touches(std::uint32_t i, std::uint32_t body) const { return a[i] == body || b[i] == body; }

  friend void write(Writer&, const Joints&);
  friend void read(Reader&, Joints&);
};

// The anchors as they are now, in the world.
Pos anchor_a(const Joints&, const Bodies&, std::uint32_t i);
Pos anchor_b(const Joints&, const Bodies&, std::uint32_t i);
// The joint's axes on either body, → world.
Quat frame_a(const Joints&, const Bodies&, std::uint32_t i);
Quat frame_b(const Joints&, const Bodies&, std::uint32_t i);

// What a joint demands: `count` rows as one block, and perhaps a free coordinate with a limit and a drive.
struct JointRows {
  std::array<Row, 6> rows;
  int count = 0;
  bool free = false;   // has a coordinate
  Row rate;            // the coordinate's rate
  Real value = 0;      // and value, which repeats after
  Real period = 0;     // 0: never
};
JointRows rows_of(const Joints&, const Bodies&, std::uint32_t i);
// The same where its bodies are, or would be, by their centres of mass; of the world, anywhere.
struct JointEnds {
  Pose a, b;
};
JointRows rows_of(const Joints&, const JointEnds&, std::uint32_t i);

// How far the joint is from holding: its linear rows, and a length beyond its limit, m.
Real gap_of(const Joints&, const Bodies&, std::uint32_t i);

// The servo or motor of a joint, null where its kind has none.
const Drive* drive_of(const JointDef&);
Drive* drive_of(JointDef&);
// The coordinate next to `previous` that is `value` or whole periods away from it.
Real unwind(Real previous, Real value, Real period);

// Fields that all kinds of joints have.
inline Body body_a(const JointDef& def) { return std::visit([](const auto& d) { return d.a; }, def); }
inline Body body_b(const JointDef& def) { return std::visit([](const auto& d) { return d.b; }, def); }
inline bool may_collide(const JointDef& def) { return std::visit([](const auto& d) { return d.collide; }, def); }

}
