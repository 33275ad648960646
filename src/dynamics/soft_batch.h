// What the parts of soft_step share: some islands that are solved at once.
#pragma once

#include "dynamics/colours.h"
#include "dynamics/soft_rows.h"
#include "dynamics/solve.h"
#include "dynamics/support.h"

namespace sudar::inline SUDAR_PRECISION {

// Lengths, m · length_unit, of docs/soft_step.md.
inline constexpr Real soft_reach = Real(0.010);        // a loaded point is held softly until it is so far apart
inline constexpr Real soft_support_gap = Real(0.018);  // nearer points may carry
inline constexpr Real soft_touch = Real(0.003);       // so near must come what has carried nothing yet: what is dropped falls

// Of a constraint of some frequency [Hz] and damping ratio in sub-steps of length h (soft_step.h).
struct Softness {
  Real bias_rate, mass_scale, impulse_scale;
};
inline Softness softness(Real frequency, Real damping, Real h) {
  const Real omega = Real(2 * pi) * frequency;
  const Real a1 = 2 * damping + h * omega, a2 = h * omega * a1, a3 = 1 / (1 + a2);
  return {omega / a1, a2 * a3, a3};
}

// A contact of the batch.
struct SoftContact {
  static constexpr std::uint32_t none = 0xffffffffu;

  std::uint32_t in_view;              // number in StepView::contacts
  std::uint32_t a, b;                 // numbers of the bodies
  std::uint32_t group = 0, lane = 0;  // where its row lies
  std::uint32_t count = 0;            // of points
  std::uint32_t support = none;       // its number among supports
  Real approach = 0, sliding = 0;     // fastest at the start of the step, m/s
  bool fresh = false;                 // has carried nothing yet
  bool pressed = false;               // was pressed in the last step
};

// What solving a batch needs; used again for the next.
struct SoftWorkspace {
  std::vector<std::uint32_t> slots;     // of bodies by number: 0 stays where it is, then kinematic ones, then dynamic ones
  std::vector<SoftBody> bodies;
  std::vector<SoftMotion> motions;      // of dynamic bodies, in the order of their numbers
  std::vector<Pos> places;              // where bodies were when the step began
  std::vector<SoftContact> contacts;
  Colours colours;
  std::vector<SoftRows> rows;
  std::vector<std::uint32_t> bouncing;  // contacts
  std::vector<Support> supports;
  SupportLoads support_loads;
  std::vector<std::uint32_t> movers;    // numbers of dynamic bodies
  std::vector<Real> weights, radii;
  std::vector<double> heights;
  std::vector<Wrench> loads;
  std::vector<std::uint32_t> joints;    // slots
  std::vector<std::pair<std::uint32_t, std::uint32_t>> joint_places;  // group and lane of their rows
  std::vector<SoftBallRows> ball_rows;
  StepOutcome out;
};

class SoftBatch {
 public:
  // `number_of`: by slot, the number of each body of the batch; 0 for what stays where it is.
  SoftBatch(const StepView& in, std::span<const std::uint32_t> number_of, SoftWorkspace& work)
      : in_(in), set_(in.config.soft_step), number_of_(number_of), w_(work), unit_(in.config.length_unit), h_(in.h),
        gravity_(gravity(in.forces)) {}

 protected:
  bool moves(std::uint32_t n) const { return w_.bodies[n].inverse_mass > 0; }
  std::uint32_t first_mover() const { return std::uint32_t(in_.kinematic.size()) + 1; }
  std::uint32_t end() const { return std::uint32_t(w_.slots.size()); }
  SoftMotion& motion(std::uint32_t n) const { return w_.motions[(n - first_mover()) / SoftLanes::count]; }
  std::uint32_t lane_of(std::uint32_t n) const { return (n - first_mover()) % SoftLanes::count; }

  const ActiveContact& view(const SoftContact& c) const { return in_.contacts[c.in_view]; }
  SoftRows& row_of(const SoftContact& c) const { return w_.rows[c.group]; }
  Real threshold() const { return 2 * length(gravity_) * h_; }  // slower is resting, m/s

  static void set(Vec3T<SoftLanes>& to, std::uint32_t lane, const Vec3& v) {
    to.x[lane] = v.x, to.y[lane] = v.y, to.z[lane] = v.z;
  }
  static Vec3 get(const Vec3T<SoftLanes>& from, std::uint32_t lane) { return {from.x[lane], from.y[lane], from.z[lane]}; }
  static void set_inertia(SoftBody& body, const Mat3& m) {
    body.xx = m.c0.x, body.xy = m.c1.x, body.xz = m.c2.x, body.yy = m.c1.y, body.yz = m.c2.y, body.zz = m.c2.z;
  }
  static Mat3 inverse_inertia(const SoftBody& b) {
    return {{b.xx, b.xy, b.xz}, {b.xy, b.yy, b.yz}, {b.xz, b.yz, b.zz}};
  }

  const StepView& in_;
  const SoftStep& set_;
  std::span<const std::uint32_t> number_of_;
  SoftWorkspace& w_;
  Real unit_, h_;
  Vec3 gravity_;
};

}
