#include "dynamics/soft_step.h"

#include <algorithm>

#include "dynamics/colours.h"
#include "dynamics/integrate.h"
#include "dynamics/reference_islands.h"
#include "dynamics/soft_rows.h"
#include "dynamics/support.h"

namespace sudar::inline SUDAR_PRECISION {

namespace {

// Lengths, m · length_unit. Labs of recipe R6 (docs/notes/soft_step.md).
constexpr Real reach = Real(0.010);         // a loaded point is held softly until it is so far apart
constexpr Real support_gap = Real(0.018);   // nearer points may carry
constexpr Real upright = Real(0.3);         // cosine between normal and vertical above which a contact carries
constexpr Real follow = Real(0.01);         // share by which a reference follows a growing load in a step

struct Softness {
  Real bias_rate, mass_scale, impulse_scale;
};
Softness softness(Real frequency, Real damping, Real h) {
  const Real omega = Real(2 * pi) * frequency;
  const Real a1 = 2 * damping + h * omega, a2 = h * omega * a1, a3 = 1 / (1 + a2);
  return {omega / a1, a2 * a3, a3};
}

constexpr std::uint32_t none = 0xffffffffu;

// A contact of the batch.
struct SoftContact {
  std::uint32_t in_view;       // number in StepView::contacts
  std::uint32_t a, b;          // numbers of the bodies
  std::uint32_t group = 0, lane = 0;  // where its row lies
  std::uint32_t count = 0;            // of points
  std::uint32_t support = none;       // its number among supports
  Real approach = 0, sliding = 0;     // fastest at the start of the step, m/s
  bool fresh = false;                 // new
  bool pressed = false;               // was pressed in the last step
};

// What solving some islands at once needs; used again for the next.
struct Workspace {
  std::vector<std::uint32_t> slots;  // of bodies by number; 0: what stays where it is
  std::vector<SoftBody> bodies;
  std::vector<SoftMotion> motions;   // of dynamic bodies, in the order of their numbers
  std::vector<Pos> places;           // where bodies were when the step began
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
  StepOutcome out;
};

class Batch {
 public:
  Batch(const StepView& in, std::span<const std::uint32_t> number_of, Workspace& work)
      : in_(in), set_(in.config.soft_step), number_of_(number_of), w_(work), unit_(in.config.length_unit), h_(in.h),
        gravity_(gravity(in.forces)),
        passes_settings_{in.h, set_.push_speed * unit_, set_.carry_loads ? reach * unit_ : Real(0)} {}

  void run(std::span<const std::uint32_t> islands) {
    gather_bodies(islands);
    gather_contacts(islands);
    const SoftPassTable& passes = soft_passes(set_.lanes);
    const auto bodies = [&](auto visit) { visit(w_.motions.data(), w_.motions.size(), w_.bodies.data(), passes_settings_); };
    const auto contacts = [&](auto visit) { visit(w_.rows.data(), w_.rows.size(), w_.bodies.data(), passes_settings_); };
    for (int k = 0; k < in_.substeps; ++k) {
      if (k > 0 && vary(in_.forces)) publish(), load_forces();
      bounce();
      bodies(passes.begin);
      leave_bouncing_alone();
      if (k == 0) contacts(passes.warm);
      contacts(passes.solve);
      bodies(passes.drift);
      carry_kinematic();
      contacts(passes.relax);
      bodies(passes.settle);
    }
    publish();
    store();
  }

 private:
  // --- bodies ---

  bool moves(std::uint32_t n) const { return w_.bodies[n].inverse_mass > 0; }

  std::uint32_t first_mover() const { return std::uint32_t(in_.kinematic.size()) + 1; }
  std::uint32_t end() const { return std::uint32_t(w_.slots.size()); }
  SoftMotion& motion(std::uint32_t n) { return w_.motions[(n - first_mover()) / SoftLanes::count]; }
  std::uint32_t lane_of(std::uint32_t n) const { return (n - first_mover()) % SoftLanes::count; }

  void gather_bodies(std::span<const std::uint32_t> islands) {
    w_.slots.assign(1, no_body);
    w_.slots.insert(w_.slots.end(), in_.kinematic.begin(), in_.kinematic.end());
    for (const std::uint32_t k : islands) {
      const auto bodies = in_.islands[k].bodies.of(in_.awake);
      w_.slots.insert(w_.slots.end(), bodies.begin(), bodies.end());
    }
    w_.bodies.assign(end() + SoftLanes::count, {});  // so that the last lanes have a place
    w_.motions.clear();
    for (std::uint32_t n = 1; n < first_mover(); ++n) {
      w_.bodies[n].v = in_.bodies.velocity[w_.slots[n]];
      w_.bodies[n].w = in_.bodies.spin[w_.slots[n]];
    }
    w_.places.resize(end());
    for (std::uint32_t n = first_mover(); n < end(); ++n) gather(n);
    load_forces();
  }

  void gather(std::uint32_t n) {
    const Bodies& b = in_.bodies;
    const std::uint32_t slot = w_.slots[n], lane = lane_of(n);
    if (lane == 0) add_motion(n);
    SoftMotion& m = motion(n);
    ++m.used;
    if (!b.dynamic(slot)) return;
    SoftBody& body = w_.bodies[n];
    const Vec3 spin = spin_of(b, slot);
    const Quat& q = b.orientation[slot];
    w_.places[n] = b.position[slot];
    body.inverse_mass = b.inverse_mass[slot];
    body.v = b.velocity[slot], body.w = spin;
    set_inertia(body, b.inverse_inertia_world(slot));
    m.orientation.x[lane] = q.x, m.orientation.y[lane] = q.y, m.orientation.z[lane] = q.z, m.orientation.w[lane] = q.w;
    set(m.momentum, lane, b.angular_momentum[slot]), set(m.spin, lane, spin);
    set(m.inertia, lane, b.inertia[slot]), set(m.inverse_inertia, lane, b.inverse_inertia[slot]);
  }

  // Lanes without a body turn, too, and must stay finite.
  void add_motion(std::uint32_t first) {
    SoftMotion& m = w_.motions.emplace_back();
    m.first = first;
    for (std::uint32_t lane = 0; lane < SoftLanes::count; ++lane) {
      m.orientation.w[lane] = 1, m.falls[lane] = 1;
      set(m.inertia, lane, {1, 1, 1});
    }
  }

  static void set_inertia(SoftBody& body, const Mat3& m) {
    body.xx = m.c0.x, body.xy = m.c1.x, body.xz = m.c2.x, body.yy = m.c1.y, body.yz = m.c2.y, body.zz = m.c2.z;
  }
  static Mat3 inverse_inertia(const SoftBody& b) {
    return {{b.xx, b.xy, b.xz}, {b.xy, b.yy, b.yz}, {b.xz, b.yz, b.zz}};
  }

  void load_forces() {
    const auto slots = std::span(w_.slots).subspan(first_mover());
    evaluate(in_.forces, in_.bodies, slots, w_.loads);
    for (std::uint32_t n = first_mover(); n < end(); ++n) {
      if (!moves(n)) continue;
      SoftMotion& m = motion(n);
      SoftBody& body = w_.bodies[n];
      const std::uint32_t lane = lane_of(n);
      const Wrench& load = w_.loads[n - first_mover()];
      const Vec3 a = load.force * body.inverse_mass, turning = inverse_inertia(body) * load.torque;
      const DragRates drag = drag_on(in_.forces, in_.bodies, w_.slots[n]);
      set(m.acceleration, lane, a), set(m.angular_acceleration, lane, turning);
      m.drag[lane] = drag.linear, m.quadratic_drag[lane] = drag.quadratic;
      m.angular_drag[lane] = drag.angular, m.quadratic_angular_drag[lane] = drag.angular_quadratic;
      const Real step = h_ * Real(in_.substeps);
      if (!is_finite(body.v + a * step) || !is_finite(body.w + turning * step)) {
        give_up(n);  // before it can infect what it touches
        set(m.acceleration, lane, {}), set(m.angular_acceleration, lane, {}), set(m.momentum, lane, {}), set(m.spin, lane, {});
      }
    }
  }

  void give_up(std::uint32_t n) {
    const std::uint32_t slot = w_.slots[n];
    w_.bodies[n] = {};
    in_.bodies.quarantined[slot] = 1;
    w_.out.broken.push_back(slot);
  }

  void carry_kinematic() {
    for (std::uint32_t n = 1; n < first_mover(); ++n) {
      SoftBody& body = w_.bodies[n];
      body.shift += body.v * h_, body.turn += body.w * h_;
    }
  }

  // Motions → the bodies' state.
  void publish() {
    for (std::uint32_t n = first_mover(); n < end(); ++n) {
      if (!moves(n)) continue;
      const SoftMotion& m = motion(n);
      const std::uint32_t lane = lane_of(n), slot = w_.slots[n];
      const Quat q{m.orientation.x[lane], m.orientation.y[lane], m.orientation.z[lane], m.orientation.w[lane]};
      const BodyMotion at{w_.places[n] + w_.bodies[n].shift, q, w_.bodies[n].v, get(m.momentum, lane)};
      if (!place(in_.bodies, slot, at)) give_up(n);
    }
  }

  // --- contacts ---

  void gather_contacts(std::span<const std::uint32_t> islands) {
    w_.contacts.clear(), w_.bouncing.clear(), w_.supports.clear();
    for (const std::uint32_t k : islands) {
      const Island::Part part = in_.islands[k].contacts;
      for (std::uint32_t c = part.first; c < part.first + part.count; ++c) {
        w_.contacts.push_back({.in_view = c, .a = number_of_[in_.contacts[c].a], .b = number_of_[in_.contacts[c].b]});
      }
    }
    const auto sides = [&](std::uint32_t k) {
      const SoftContact& c = w_.contacts[k];
      return std::array{moves(c.a) ? c.a : 0u, moves(c.b) ? c.b : 0u};
    };
    w_.colours.assign(std::uint32_t(w_.contacts.size()), std::uint32_t(w_.bodies.size()), sides);
    lay_out();
    for (SoftContact& c : w_.contacts) prepare(c);
    carry_loads();
    for (SoftContact& c : w_.contacts) remember(c);
  }

  void lay_out() {
    w_.rows.clear();
    for (std::uint32_t colour = 0; colour <= Colours::colours; ++colour) {
      const auto members = w_.colours.of(colour);
      const std::uint32_t lanes = colour == Colours::crowded ? 1 : std::uint32_t(SoftLanes::count);
      for (std::uint32_t k = 0; k < members.size(); ++k) {
        if (k % lanes == 0) w_.rows.emplace_back();
        w_.contacts[members[k]].group = std::uint32_t(w_.rows.size() - 1);
        w_.contacts[members[k]].lane = k % lanes;
        ++w_.rows.back().used;
      }
    }
  }

  const ActiveContact& view(const SoftContact& c) const { return in_.contacts[c.in_view]; }

  // Which body the points of a contact go along with: the one that moves, or the smaller one.
  bool owned_by_a(const ActiveContact& c) const {
    const Bodies& b = in_.bodies;
    if (b.dynamic(c.a) != b.dynamic(c.b)) return b.dynamic(c.a);
    return b.radius[c.a] <= b.radius[c.b];
  }

  // The part of a turn by less than half a circle that goes about n.
  static Quat twist_about(const Vec3& n, const Quat& turn) {
    const Vec3 along = n * dot(turn.vector(), n);
    return normalize(Quat{along.x, along.y, along.z, turn.w});
  }

  void prepare(SoftContact& c) {
    const ActiveContact& from = view(c);
    const Manifold& manifold = *from.manifold;
    const ContactPlace& place = in_.contact_state.place[from.slot];
    const Bodies& bodies = in_.bodies;
    SoftRows& row = w_.rows[c.group];
    const std::uint32_t lane = c.lane;
    const SoftBody &on_a = w_.bodies[c.a], &on_b = w_.bodies[c.b];
    const Vec3 n = manifold.normal, t1 = any_perpendicular(n), t2 = cross(n, t1);
    c.count = std::uint32_t(manifold.count);

    const Vec3 to_shape = rotate(place.a.q, bodies.shape_frame[from.a].p);
    Vec3 middle;
    for (std::size_t k = 0; k < c.count; ++k) middle += manifold.points[k].at / Real(c.count);
    const bool of_a = owned_by_a(from);
    const Quat twist = (manifold.bits & Manifold::kept) == 0 ? Quat{}
                       : of_a ? twist_about(n, bodies.orientation[from.a] * conjugate(place.a.q))
                              : twist_about(n, bodies.orientation[from.b] * conjugate(place.b.q));
    const Vec3 ra = rotate(twist, middle + to_shape);
    const Vec3 rb = rotate(twist, middle + to_shape + (place.a.p - place.b.p));
    row.a[c.lane] = c.a, row.b[c.lane] = c.b;
    set(row.n, lane, n), set(row.t1, lane, t1), set(row.ra, lane, ra), set(row.rb, lane, rb);
    set(row.apart, lane, bodies.position[from.a] - bodies.position[from.b]);
    row.owned_by_a[lane] = of_a ? 1 : 0;

    Response press, slide;
    const auto side = [&](const SoftBody& on, const Vec3& r) {
      if (!(on.inverse_mass > 0)) return;
      const Mat3 inertia = inverse_inertia(on);
      press.add(on.inverse_mass, 0, inertia, cross(r, n), -t2, t1);
      slide.add(on.inverse_mass, on.inverse_mass, inertia, cross(r, t1), cross(r, t2), n);
    };
    side(on_a, ra), side(on_b, rb);
    press.put(row.press, lane), slide.put(row.slide, lane);

    const bool still = !moves(c.a) || !moves(c.b);
    const Real frequency = min(set_.contact_frequency, Real(0.125) / h_);
    const Softness soft = still ? softness(2 * frequency, Real(0.5) * set_.contact_damping, h_)
                                : softness(frequency, set_.contact_damping, h_);
    row.bias_rate[lane] = soft.bias_rate, row.mass_scale[lane] = soft.mass_scale, row.impulse_scale[lane] = soft.impulse_scale;

    const Vec3 surfaces = bodies.surface_velocity_world(from.a) - bodies.surface_velocity_world(from.b);
    row.glide_1[lane] = dot(surfaces, t1), row.glide_2[lane] = dot(surfaces, t2);
    const Vec3 w = on_a.w - on_b.w;
    const Vec3 u = (on_a.v - on_b.v) + (cross(on_a.w, ra) - cross(on_b.w, rb));
    for (std::size_t k = 0; k < c.count; ++k) {
      const Vec3 d = rotate(twist, manifold.points[k].at - middle);
      const Real x = dot(d, t1), y = dot(d, t2);
      SoftRows::Point& p = row.points[k];
      p.x[lane] = x, p.y[lane] = y;
      p.separation[lane] = manifold.points[k].separation;
      p.normal_mass[lane] = 1 / press.at(x, y);
      p.tangent_mass[lane] = 1 / slide.largest(x, y);
      const Real approach = -dot(u + cross(w, d), n);
      const Vec3 along = u + cross(w, d) + surfaces;
      c.sliding = max(c.sliding, length(along - n * dot(along, n)));
      c.approach = k == 0 ? approach : max(c.approach, approach);
    }
    if (from.material.restitution > 0) w_.bouncing.push_back(std::uint32_t(&c - w_.contacts.data()));
    stand(c, n, ra, rb, t1, t2, row);
  }

  static void set(Vec3T<SoftLanes>& to, std::uint32_t lane, const Vec3& v) { to.x[lane] = v.x, to.y[lane] = v.y, to.z[lane] = v.z; }
  static Vec3 get(const Vec3T<SoftLanes>& from, std::uint32_t lane) { return {from.x[lane], from.y[lane], from.z[lane]}; }

  // How three velocities answer three impulses: matrices of SoftRows.
  struct Response {
    Real xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
    void add(Real m0, Real m1, const Mat3& inertia, const Vec3& j0, const Vec3& j1, const Vec3& j2) {
      const Vec3 i0 = inertia * j0, i1 = inertia * j1, i2 = inertia * j2;
      xx += m0 + dot(j0, i0), xy += dot(j0, i1), xz += dot(j0, i2);
      yy += m1 + dot(j1, i1), yz += dot(j1, i2), zz += dot(j2, i2);
    }
    void put(Symmetric3<SoftLanes>& to, std::uint32_t lane) const {
      to.xx[lane] = xx, to.xy[lane] = xy, to.xz[lane] = xz, to.yy[lane] = yy, to.yz[lane] = yz, to.zz[lane] = zz;
    }
    // Along the normal at a point.
    Real at(Real x, Real y) const { return xx + 2 * (x * xy + y * xz) + x * x * yy + 2 * x * y * yz + y * y * zz; }
    // The larger eigenvalue along the surface at a point.
    Real largest(Real x, Real y) const {
      const Real k11 = xx - 2 * y * xz + y * y * zz, k22 = yy + 2 * x * yz + x * x * zz;
      const Real k12 = xy + x * xz - y * yz - x * y * zz;
      return (k11 + k22) * Real(0.5) + sqrt(square((k11 - k22) * Real(0.5)) + square(k12));
    }
  };

  // --- loads ---

  // Notes the contact as one that may carry.
  void stand(SoftContact& c, const Vec3& n, const Vec3& ra, const Vec3& rb, const Vec3& t1, const Vec3& t2, const SoftRows& row) {
    if (!set_.carry_loads || gravity_ == Vec3{}) return;
    const Real g = length(gravity_), vertical = -dot(n, gravity_) / g;
    if (abs(vertical) <= upright || abs(c.approach) > calm()) return;
    const bool a_above = vertical > 0;
    const std::uint32_t upper = a_above ? c.a : c.b, lower = a_above ? c.b : c.a;
    if (!moves(upper)) return;
    Support s{.upper = upper, .lower = moves(lower) ? lower : 0, .count = c.count, .steepness = abs(vertical)};
    bool near = false;
    for (std::size_t k = 0; k < c.count; ++k) {
      const SoftRows::Point& p = row.points[k];
      const Vec3 d = t1 * p.x[c.lane] + t2 * p.y[c.lane];
      s.arm_upper[k] = (a_above ? ra : rb) + d, s.arm_lower[k] = (a_above ? rb : ra) + d;
      s.carries[k] = p.separation[c.lane] < support_gap * unit_;
      near |= s.carries[k];
    }
    if (!near) return;
    c.support = std::uint32_t(w_.supports.size());
    w_.supports.push_back(s);
  }

  void carry_loads() {
    if (w_.supports.empty()) return;
    const Real g = length(gravity_);
    const Vec3 up = gravity_ * (-1 / g);
    w_.weights.assign(w_.bodies.size(), 0), w_.heights.assign(w_.bodies.size(), 0);
    w_.radii.assign(w_.bodies.size(), 0);
    w_.movers.clear();
    for (std::uint32_t i = first_mover(); i < end(); ++i) {
      w_.movers.push_back(i);
      const std::uint32_t slot = w_.slots[i];
      const Pos& p = in_.bodies.position[slot];
      w_.radii[i] = in_.bodies.radius[slot];
      w_.weights[i] = in_.bodies.mass[slot] * g * h_;
      w_.heights[i] = double(up.x) * p.x + double(up.y) * p.y + double(up.z) * p.z;
    }
    w_.support_loads.solve(w_.supports, w_.movers, w_.weights, w_.heights, w_.radii, up);
  }

  // What meets or parts faster is not at rest, and carries nothing yet, m/s: the speed of a fall from a millimetre up.
  Real calm() const { return sqrt(2 * length(gravity_) * support_gap * unit_); }

  // The impulses of the last step, point by feature; friction turned into the new tangent plane; a new contact begins
  // with what it will carry.
  void remember(SoftContact& c) {
    const ActiveContact& from = view(c);
    const Manifold& manifold = *from.manifold;
    const ContactImpulse& stored = in_.contact_state.impulse[from.slot];
    ContactReference& reference = in_.contact_state.reference[from.slot];
    SoftRows& row = w_.rows[c.group];
    const std::uint32_t lane = c.lane;
    const Vec3 t1 = get(row.t1, lane);
    const Vec3 t2 = cross(manifold.normal, t1);
    std::array<Real, 4> load{};
    if (c.support != none) load = w_.supports[c.support].load;
    Real carried = 0;
    for (const Real l : load) carried += l;
    const bool began = (manifold.bits & Manifold::began) != 0;
    const bool fresh = began || reference.carried < 0;  // has carried nothing yet
    const bool eased = !fresh && carried > 0 && carried < Real(0.9) * reference.carried;
    Real held = 0;
    bool struck = false;
    ContactReference next{.normal = {}, .carried = c.support == none && fresh ? Real(-1) : carried};
    for (std::size_t k = 0; k < c.count; ++k) {
      SoftRows::Point& p = row.points[k];
      const int match = manifold.points[k].match;
      Real normal = 0, kept = load[k];
      Vec3 friction;
      if (match >= 0 && !began) {
        normal = stored.normal[std::size_t(match)];
        friction = stored.friction[std::size_t(match)];
        held += normal;
        if (!fresh) kept = min(reference.normal[std::size_t(match)], load[k]);
        if (eased) normal *= carried / reference.carried;
      }
      struck |= normal == 0 && c.approach > threshold();
      if (fresh) normal = max(normal, load[k]);
      next.normal[k] = kept;
      p.normal[lane] = normal, p.reference[lane] = kept;
      p.friction_1[lane] = dot(friction, t1), p.friction_2[lane] = dot(friction, t2);
    }
    reference = next;
    c.fresh = fresh;
    c.pressed = held > 0;
    row.strikes |= struck;
    const Material& m = from.material;
    // Who stuck goes on sticking; who slipped sticks again once it is slow (impulse_2007.cc).
    const bool sticks = (c.pressed && in_.contact_state.slipping[from.slot] == 0) ||
                        c.sliding <= Real(0.1) * length(gravity_) * h_;
    row.friction[lane] = sticks ? m.friction_static : m.friction_dynamic;
    row.friction_dynamic[lane] = m.friction_dynamic;
    if (m.rolling > 0 || m.spinning > 0) {
      row.turning = true;
      row.rolling[lane] = m.rolling, row.spinning[lane] = m.spinning;
      row.spin_mass[lane] = 1 / row.slide.zz[lane];
      const Real yy = row.press.yy[lane], zz = row.press.zz[lane], yz = row.press.yz[lane];
      row.roll_mass[lane] = 1 / ((yy + zz) * Real(0.5) + sqrt(square((yy - zz) * Real(0.5)) + square(yz)));
      if (!began) {
        row.spin[lane] = dot(stored.turning, manifold.normal);
        row.roll_1[lane] = dot(stored.turning, t1), row.roll_2[lane] = dot(stored.turning, t2);
      }
    }
  }

  // --- restitution: true impacts, before this sub-step's gravity; one contact after the other, its points at once ---

  Vec3 pressing(const SoftRows& row, std::uint32_t lane, const SoftBody& a, const SoftBody& b) const {
    const Vec3 n = get(row.n, lane), t1 = get(row.t1, lane);
    const Vec3 ra = get(row.ra, lane), rb = get(row.rb, lane);
    const Vec3 u = (a.v - b.v) + (cross(a.w, ra) - cross(b.w, rb)), w = a.w - b.w;
    return {dot(u, n), -dot(w, cross(n, t1)), dot(w, t1)};
  }

  Real separation(const SoftContact& c, const SoftRows& row, std::size_t k) const {
    SoftBody a, b;  // displacements in the place of velocities
    a.v = w_.bodies[c.a].shift, a.w = w_.bodies[c.a].turn, b.v = w_.bodies[c.b].shift, b.w = w_.bodies[c.b].turn;
    const std::uint32_t lane = c.lane;
    const Vec3 moved = pressing(row, lane, a, b);
    const SoftRows::Point& p = row.points[k];
    return p.separation[lane] + (moved.x + (p.x[lane] * moved.y + p.y[lane] * moved.z));
  }

  Real threshold() const { return 2 * length(gravity_) * h_; }  // slower is resting, m/s

  void bounce() {
    if (w_.bouncing.empty()) return;
    for (int sweep = 0; sweep < 4; ++sweep) {
      bool struck = false;
      for (const std::uint32_t k : w_.bouncing) struck |= strike(w_.contacts[k]);
      if (!struck) break;
    }
  }

  bool strike(const SoftContact& c) {
    SoftRows& row = w_.rows[c.group];
    const std::uint32_t lane = c.lane;
    SoftBody &a = w_.bodies[c.a], &b = w_.bodies[c.b];
    const Real e = view(c).material.restitution;
    Vec3 g = pressing(row, lane, a, b);
    const Vec3 n = get(row.n, lane);
    const Real pull = dot(n, acceleration(c.a) - acceleration(c.b));
    std::array<Real, 4> target{}, impulse{};
    bool acts = false;
    std::array<bool, 4> touches{};
    constexpr Real together = Real(0.1);  // share of a sub-step's way by which points of a face may come later
    for (std::size_t k = 0; k < c.count; ++k) {
      const SoftRows::Point& p = row.points[k];
      const Real u = g.x + p.x[lane] * g.y + p.y[lane] * g.z, s = separation(c, row, k);
      touches[k] = s <= max(Real(0), -together * h_ * u);
      if (!touches[k]) continue;
      acts |= s <= 0 && u < -threshold();
      // Falling on by the depth gave speed that the surface would not have seen.
      const Real fallen = -2 * pull * min(Real(0), s);
      target[k] = u < 0 ? sqrt(max(Real(0), square(e) * max(Real(0), square(u) + fallen) - fallen)) : Real(0);
    }
    if (!acts) return false;
    Vec3 press;
    const Symmetric3<Real> response{row.press.xx[lane], row.press.xy[lane], row.press.xz[lane],
                                    row.press.yy[lane], row.press.yz[lane], row.press.zz[lane]};
    // First all points of the face alike, or what the first of them takes away turns the body.
    Vec3 all;
    Real owed = 0;
    for (std::size_t k = 0; k < c.count; ++k) {
      if (!touches[k]) continue;
      const SoftRows::Point& p = row.points[k];
      all += Vec3{1, p.x[lane], p.y[lane]};
      owed += target[k] - (g.x + p.x[lane] * g.y + p.y[lane] * g.z);
    }
    if (owed > 0) {
      const Real equal = owed / dot(all, response * all);
      press = all * equal;
      g += response * press;
      for (std::size_t k = 0; k < c.count; ++k) impulse[k] = touches[k] ? equal : Real(0);
    }
    for (int round = 0; round < 8; ++round) {
      for (std::size_t k = 0; k < c.count; ++k) {
        if (!touches[k]) continue;
        const SoftRows::Point& p = row.points[k];
        const Real x = p.x[lane], y = p.y[lane], u = g.x + x * g.y + y * g.z;
        const Real next = max(Real(0), impulse[k] - p.normal_mass[lane] * (u - target[k]));
        const Vec3 step{next - impulse[k], x * (next - impulse[k]), y * (next - impulse[k])};
        impulse[k] = next;
        press += step;
        g += response * step;
      }
    }
    push(row, lane, a, b, press, {});
    rub(c, row, a, b, impulse);
    for (std::size_t k = 0; k < c.count; ++k) {
      SoftRows::Point& p = row.points[k];
      p.normal[lane] = p.friction_1[lane] = p.friction_2[lane] = 0;
    }
    for (const std::uint32_t i : {c.a, c.b}) {
      if (!moves(i)) continue;
      motion(i).falls[lane_of(i)] = 0;
      set(motion(i).gain_v, lane_of(i), {}), set(motion(i).gain_w, lane_of(i), {});
    }
    return true;
  }

  Vec3 acceleration(std::uint32_t n) { return moves(n) ? get(motion(n).acceleration, lane_of(n)) : Vec3{}; }

  void rub(const SoftContact& c, const SoftRows& row, SoftBody& a, SoftBody& b, const std::array<Real, 4>& impulse) {
    const std::uint32_t lane = c.lane;
    const Vec3 n = get(row.n, lane), t1 = get(row.t1, lane);
    const Vec3 t2 = cross(n, t1);
    const Vec3 ra = get(row.ra, lane), rb = get(row.rb, lane);
    const Vec3 u = (a.v - b.v) + (cross(a.w, ra) - cross(b.w, rb));
    Vec3 g{dot(u, t1) + row.glide_1[lane], dot(u, t2) + row.glide_2[lane], dot(a.w - b.w, n)};
    const Symmetric3<Real> response{row.slide.xx[lane], row.slide.xy[lane], row.slide.xz[lane],
                                    row.slide.yy[lane], row.slide.yz[lane], row.slide.zz[lane]};
    const Material& m = view(c).material;
    std::array<Real, 4> f1{}, f2{};
    Vec3 slide;
    for (int round = 0; round < 8; ++round) {
      for (std::size_t k = 0; k < c.count; ++k) {
        const SoftRows::Point& p = row.points[k];
        const Real x = p.x[lane], y = p.y[lane];
        Real next_1 = f1[k] - p.tangent_mass[lane] * (g.x - y * g.z);
        Real next_2 = f2[k] - p.tangent_mass[lane] * (g.y + x * g.z);
        const Real size = sqrt(square(next_1) + square(next_2));
        if (size > m.friction_static * impulse[k]) {
          const Real cut = m.friction_dynamic * impulse[k] / size;
          next_1 *= cut, next_2 *= cut;
        }
        const Vec3 step{next_1 - f1[k], next_2 - f2[k], x * (next_2 - f2[k]) - y * (next_1 - f1[k])};
        f1[k] = next_1, f2[k] = next_2;
        slide += step;
        g += response * step;
      }
    }
    push(row, lane, a, b, {}, slide);
  }

  static void push(const SoftRows& row, std::uint32_t lane, SoftBody& a, SoftBody& b, const Vec3& press, const Vec3& slide) {
    const Vec3 n = get(row.n, lane), t1 = get(row.t1, lane);
    const Vec3 t2 = cross(n, t1);
    const Vec3 ra = get(row.ra, lane), rb = get(row.rb, lane);
    const Vec3 force = n * press.x + t1 * slide.x + t2 * slide.y, moment = t1 * press.z - t2 * press.y + n * slide.z;
    if (a.inverse_mass > 0) a.v += force * a.inverse_mass, a.w += inverse_inertia(a) * (moment + cross(ra, force));
    if (b.inverse_mass > 0) b.v -= force * b.inverse_mass, b.w -= inverse_inertia(b) * (moment + cross(rb, force));
  }

  // What comes fast and will bounce must not be braked before it touches.
  void leave_bouncing_alone() {
    for (const std::uint32_t k : w_.bouncing) {
      SoftContact& c = w_.contacts[k];
      SoftRows& row = w_.rows[c.group];
      const std::uint32_t lane = c.lane;
      const Vec3 g = pressing(row, lane, w_.bodies[c.a], w_.bodies[c.b]);
      Real fastest = 0, held = 0;
      for (std::size_t p = 0; p < c.count; ++p) {
        fastest = max(fastest, -(g.x + row.points[p].x[lane] * g.y + row.points[p].y[lane] * g.z));
        held += row.points[p].normal[lane];
      }
      row.lift[lane] = held == 0 && fastest > threshold() ? Real(1e6) * unit_ : Real(0);
    }
  }

  // --- the end of the step ---

  void store() {
    for (const SoftContact& c : w_.contacts) {
      const ActiveContact& from = view(c);
      const SoftRows& row = w_.rows[c.group];
      const std::uint32_t lane = c.lane;
      const Vec3 t1 = get(row.t1, lane), t2 = cross(from.manifold->normal, t1);
      ContactImpulse& out = in_.contact_state.impulse[from.slot];
      ContactReference& reference = in_.contact_state.reference[from.slot];
      out = {};
      out.turning = from.manifold->normal * row.spin[lane] + t1 * row.roll_1[lane] + t2 * row.roll_2[lane];
      Real held = 0, pull_1 = 0, pull_2 = 0;
      bool everywhere = true;
      const Real nearly = Real(0.999) * row.friction[lane];
      for (std::size_t k = 0; k < c.count; ++k) {
        const SoftRows::Point& p = row.points[k];
        const Real normal = p.normal[lane], f1 = p.friction_1[lane], f2 = p.friction_2[lane];
        out.normal[k] = normal;
        out.friction[k] = t1 * f1 + t2 * f2;
        held += normal, pull_1 += f1, pull_2 += f2;
        everywhere &= sqrt(square(f1) + square(f2)) >= nearly * normal;
        const Real load = c.support == none ? Real(0) : w_.supports[c.support].load[k];
        reference.normal[k] = c.fresh ? load : reference.normal[k] + follow * (load - reference.normal[k]);
      }
      const bool slips = held > 0 && (everywhere || sqrt(square(pull_1) + square(pull_2)) >= nearly * held);
      in_.contact_state.slipping[from.slot] = slips ? 1 : 0;
      w_.out.points += c.count;
      if (!c.pressed && held > 0 && c.approach > threshold()) {
        w_.out.hits.push_back({c.in_view, get(row.ra, lane), c.approach});
      }
    }
  }

  const StepView& in_;
  const SoftStep& set_;
  std::span<const std::uint32_t> number_of_;
  Workspace& w_;
  Real unit_, h_;
  Vec3 gravity_;
  PassSettings passes_settings_;
};

// Islands that are solved at once: enough to fill the lanes, few enough to stay in the caches.
struct Plan {
  std::vector<std::uint32_t> islands;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> batches;  // first, end in that list

  void make(const StepView& in) {
    constexpr std::uint32_t enough = 2000;
    const std::span<const Island> all = in.islands;
    const bool at_once = act_from_afar(in.forces);
    islands.clear(), batches.clear();
    std::uint32_t first = 0, cost = 0;
    for (std::uint32_t i = 0; i < all.size(); ++i) {
      if (ReferenceIslands::belongs(in, all[i])) continue;
      islands.push_back(i);
      cost += all[i].contacts.count + all[i].bodies.count;
      if (at_once || cost < enough) continue;
      batches.emplace_back(first, std::uint32_t(islands.size()));
      first = std::uint32_t(islands.size()), cost = 0;
    }
    if (first < islands.size()) batches.emplace_back(first, std::uint32_t(islands.size()));
  }
};

}

struct SoftStepSolver::Memory {
  std::vector<std::uint32_t> number_of;  // by slot: number in its batch; 0 but for what moves
  std::vector<Workspace> work;           // by worker
  Plan plan;
  ReferenceIslands reference;
};

SoftStepSolver::SoftStepSolver() : memory_(std::make_unique<Memory>()) {}
SoftStepSolver::SoftStepSolver(SoftStepSolver&&) noexcept = default;
SoftStepSolver& SoftStepSolver::operator=(SoftStepSolver&&) noexcept = default;
SoftStepSolver::~SoftStepSolver() = default;

void SoftStepSolver::advance(const StepView& in, StepOutcome& out) {
  Memory& m = *memory_;
  m.work.resize(in.pool.workers());
  for (Workspace& w : m.work) w.out.clear();
  m.plan.make(in);
  const bool carried = m.reference.advance(in, out);
  m.number_of.resize(in.bodies.size());
  for (std::uint32_t k = 0; k < in.kinematic.size(); ++k) m.number_of[in.kinematic[k]] = k + 1;
  for (const auto& [first, end] : m.plan.batches) {
    auto next = std::uint32_t(in.kinematic.size()) + 1;
    for (std::uint32_t k = first; k < end; ++k) {
      for (const std::uint32_t i : in.islands[m.plan.islands[k]].bodies.of(in.awake)) m.number_of[i] = next++;
    }
  }
  in.pool.for_each(std::uint32_t(m.plan.batches.size()), [&](std::uint32_t worker, std::uint32_t k) {
    const auto [first, end] = m.plan.batches[k];
    Batch(in, m.number_of, m.work[worker]).run(std::span(m.plan.islands).subspan(first, end - first));
  });
  for (const auto& list : {in.awake, in.kinematic}) {
    for (const std::uint32_t i : list) m.number_of[i] = 0;
  }
  for (const std::uint32_t i : in.kinematic) {
    for (int k = 0; k < in.substeps && !carried; ++k) carry(in.bodies, i, in.h);
  }
  for (const Workspace& w : m.work) out.add(w.out);
  std::ranges::sort(out.hits, {}, &StepOutcome::Hit::contact);
  std::ranges::sort(out.broken);
}

}
