#include "dynamics/soft_contacts.h"

namespace sudar::inline SUDAR_PRECISION {

namespace {

constexpr Real upright = Real(0.3);         // cosine between normal and vertical above which a contact carries
constexpr Real follow = Real(0.01);         // share by which a reference follows a growing load in a step
constexpr std::uint32_t none = SoftContact::none;

class Preparation : public SoftBatch {
 public:
  explicit Preparation(const SoftBatch& batch)
      : SoftBatch(batch), between_bodies_(softness(frequency(), set_.contact_damping, h_)),
        on_ground_(softness(2 * frequency(), Real(0.5) * set_.contact_damping, h_)) {}

  void run(std::span<const std::uint32_t> islands) {
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

 private:
  Real frequency() const { return min(set_.contact_frequency, Real(0.125) / h_); }

  void lay_out() {
    w_.rows.clear();
    const auto points = [&](std::uint32_t k) { return view(w_.contacts[k]).manifold->count; };
    const auto by_points = [&](std::uint32_t k) { return points(k) > 2 ? 0 : points(k) == 2 ? 1 : 2; };
    w_.colours.each_group(SoftLanes::count, by_points, [&](std::uint32_t k, std::uint32_t group, std::uint32_t lane) {
      if (lane == 0) w_.rows.emplace_back().most_points = std::uint32_t(points(k) > 2 ? 4 : points(k));
      ++w_.rows[group].used;
      w_.contacts[k].group = group, w_.contacts[k].lane = lane;
    });
  }

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
    SoftRows& row = row_of(c);
    const std::uint32_t lane = c.lane;
    const SoftBody &on_a = w_.bodies[c.a], &on_b = w_.bodies[c.b];
    const Vec3 n = manifold.normal, t1 = any_perpendicular(n), t2 = cross(n, t1);
    c.count = std::uint32_t(manifold.count);

    const Vec3 to_shape = rotate(place.a.q, bodies.shape_frame(from.shape_a).p);
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

    const Softness& soft = moves(c.a) && moves(c.b) ? between_bodies_ : on_ground_;
    row.bias_rate[lane] = soft.bias_rate, row.mass_scale[lane] = soft.mass_scale, row.impulse_scale[lane] = soft.impulse_scale;

    const Vec3 surfaces = bodies.surface_velocity_world(from.shape_a) - bodies.surface_velocity_world(from.shape_b);
    row.glide_1[lane] = dot(surfaces, t1), row.glide_2[lane] = dot(surfaces, t2);
    const Vec3 w = on_a.w - on_b.w;
    const Vec3 u = (on_a.v - on_b.v) + (cross(on_a.w, ra) - cross(on_b.w, rb));
    for (std::size_t k = 0; k < c.count; ++k) {
      const Vec3 d = rotate(twist, manifold.points[k].at - middle);
      const Real x = dot(d, t1), y = dot(d, t2);
      SoftRows::Point& p = row.points[k];
      p.x[lane] = x, p.y[lane] = y;
      p.separation[lane] = manifold.points[k].separation;
      p.normal_mass[lane] = 1;
      const Real approach = -dot(u + cross(w, d), n);
      const Vec3 along = u + cross(w, d) + surfaces;
      c.sliding = max(c.sliding, length(along - n * dot(along, n)));
      c.approach = k == 0 ? approach : max(c.approach, approach);
    }
    if (from.material.restitution > 0) w_.bouncing.push_back(std::uint32_t(&c - w_.contacts.data()));
    stand(c, n, ra, rb, t1, t2, row);
  }

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
    const Real reach = (is_fresh(c) ? soft_touch : soft_support_gap) * unit_;
    bool near = false;
    for (std::size_t k = 0; k < c.count; ++k) {
      const SoftRows::Point& p = row.points[k];
      const Vec3 d = t1 * p.x[c.lane] + t2 * p.y[c.lane];
      s.arm_upper[k] = (a_above ? ra : rb) + d, s.arm_lower[k] = (a_above ? rb : ra) + d;
      s.carries[k] = p.separation[c.lane] < reach;
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
      w_.weights[i] = in_.bodies.mass[slot] * max(Real(0), in_.bodies.gravity_factor[slot]) * g * h_;
      w_.heights[i] = double(up.x) * p.x + double(up.y) * p.y + double(up.z) * p.z;
    }
    w_.support_loads.solve(w_.supports, w_.movers, w_.weights, w_.heights, w_.radii, up);
  }

  // Whether it has carried nothing yet.
  bool is_fresh(const SoftContact& c) const {
    const ActiveContact& from = view(c);
    return (from.manifold->bits & Manifold::began) != 0 || in_.contact_state.reference[from.slot].carried < 0;
  }

  // What meets or parts faster is not at rest, and carries nothing yet, m/s: the speed of a fall from a millimetre up.
  Real calm() const { return sqrt(2 * length(gravity_) * soft_support_gap * unit_); }

  // The impulses of the last step, point by feature; friction turned into the new tangent plane; a new contact begins
  // with what it will carry.
  void remember(SoftContact& c) {
    const ActiveContact& from = view(c);
    const Manifold& manifold = *from.manifold;
    const ContactImpulse& stored = in_.contact_state.impulse[from.slot];
    ContactReference& reference = in_.contact_state.reference[from.slot];
    SoftRows& row = row_of(c);
    const std::uint32_t lane = c.lane;
    const Vec3 t1 = get(row.t1, lane);
    const Vec3 t2 = cross(manifold.normal, t1);
    std::array<Real, 4> load{};
    if (c.support != none) load = w_.supports[c.support].load;
    Real carried = 0;
    for (const Real l : load) carried += l;
    const bool began = (manifold.bits & Manifold::began) != 0, fresh = is_fresh(c);
    const bool eased = !fresh && carried > 0 && carried < Real(0.9) * reference.carried;
    Real held = 0;
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
      if (fresh) normal = max(normal, load[k]);
      next.normal[k] = kept;
      p.normal[lane] = normal, p.reference[lane] = kept;
      p.friction_1[lane] = dot(friction, t1), p.friction_2[lane] = dot(friction, t2);
    }
    reference = next;
    c.fresh = fresh;
    c.pressed = held > 0;
    const Material& m = from.material;
    // Who stuck goes on sticking; who slipped sticks again once it is slow (impulse_2007.cc).
    const bool sticks = (c.pressed && in_.contact_state.slipping[from.slot] == 0) ||
                        c.sliding <= Real(0.1) * length(gravity_) * h_;
    row.friction[lane] = sticks ? m.friction_static : m.friction_dynamic;
    row.friction_dynamic[lane] = m.friction_dynamic;
    if (m.rolling > 0 || m.spinning > 0) {
      row.turning = true;
      row.rolling[lane] = m.rolling, row.spinning[lane] = m.spinning;
      if (!began) {
        row.spin[lane] = dot(stored.turning, manifold.normal);
        row.roll_1[lane] = dot(stored.turning, t1), row.roll_2[lane] = dot(stored.turning, t2);
      }
    }
  }

  Softness between_bodies_, on_ground_;
};

class Storage : public SoftBatch {
 public:
  explicit Storage(const SoftBatch& batch) : SoftBatch(batch) {}

  void run() {
    for (const SoftContact& c : w_.contacts) {
      const ActiveContact& from = view(c);
      const SoftRows& row = row_of(c);
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
};

}

void prepare_contacts(const SoftBatch& batch, std::span<const std::uint32_t> islands) { Preparation(batch).run(islands); }
void store_contacts(const SoftBatch& batch) { Storage(batch).run(); }

}
