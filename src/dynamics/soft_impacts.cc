#include "dynamics/soft_impacts.h"

namespace sudar::inline SUDAR_PRECISION {

namespace {

class Impacts : public SoftBatch {
  static constexpr Real together = Real(0.1);  // share of a sub-step's way by which points of a face may come later

 public:
  explicit Impacts(const SoftBatch& batch) : SoftBatch(batch) {}

  void strike_all() {
    if (w_.bouncing.empty()) return;
    for (int sweep = 0; sweep < 4; ++sweep) {
      bool struck = false;
      for (const std::uint32_t k : w_.bouncing) struck |= strike(w_.contacts[k]);
      if (!struck) break;
    }
  }

  void leave_bouncing_alone() {
    for (const std::uint32_t k : w_.bouncing) {
      SoftContact& c = w_.contacts[k];
      SoftRows& row = row_of(c);
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

 private:
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

  bool strike(const SoftContact& c) {
    SoftRows& row = row_of(c);
    const std::uint32_t lane = c.lane;
    SoftBody &a = w_.bodies[c.a], &b = w_.bodies[c.b];
    const Real e = view(c).material.restitution;
    Vec3 g = pressing(row, lane, a, b);
    const Vec3 n = get(row.n, lane);
    const Real pull = dot(n, acceleration(c.a) - acceleration(c.b)), late = Real(0.5) * h_ * pull;
    std::array<Real, 4> speed{}, depth{}, target{}, impulse{};
    std::array<bool, 4> touches{};
    bool acts = false;
    Real since = 0;  // the first point touched, s
    for (std::size_t k = 0; k < c.count; ++k) {
      const SoftRows::Point& p = row.points[k];
      const Real u = g.x + p.x[lane] * g.y + p.y[lane] * g.z;
      speed[k] = u, depth[k] = -separation(c, row, k);
      touches[k] = -depth[k] <= max(Real(0), -together * h_ * u);
      if (depth[k] < 0 || u >= -threshold()) continue;
      acts = true;
      since = max(since, min(h_, depth[k] / -u));
    }
    if (!acts) return false;
    const Symmetric3<Real> response{row.press.xx[lane], row.press.xy[lane], row.press.xz[lane],
                                    row.press.yy[lane], row.press.yz[lane], row.press.zz[lane]};
    // First all points of the face alike, or what the first of them takes away turns the body. `rise`: of a above where it
    // is now.
    const auto aim_alike = [&](Real rise) {
      Vec3 all;
      Real owed = 0;
      for (std::size_t k = 0; k < c.count; ++k) {
        if (!touches[k]) continue;
        const SoftRows::Point& p = row.points[k];
        target[k] = bounce(e, speed[k], depth[k], rise, pull, late);
        all += Vec3{1, p.x[lane], p.y[lane]};
        owed += target[k] - speed[k];
      }
      const Real equal = max(Real(0), owed) / dot(all, response * all);
      return all * equal;
    };
    Vec3 press = aim_alike(0);
    press = aim_alike(since * press.x * (a.inverse_mass + b.inverse_mass));
    const SoftBody was_a = a, was_b = b;
    for (std::size_t k = 0; k < c.count; ++k) impulse[k] = touches[k] ? press.x / Real(std::ranges::count(touches, true)) : Real(0);
    g += response * press;
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
    // It has flown off since.
    if (moves(c.a)) a.shift += (a.v - was_a.v) * since;
    if (moves(c.b)) b.shift += (b.v - was_b.v) * since;
    for (const std::uint32_t i : {c.a, c.b}) {
      if (!moves(i)) continue;
      motion(i).falls[lane_of(i)] = 0;
      set(motion(i).gain_v, lane_of(i), {}), set(motion(i).gain_momentum, lane_of(i), {});
    }
    return true;
  }

  // The rate of a point that came with rate u and is `depth` too deep, once the body has flown off and risen by `rise`: e
  // times what it was at the surface, both found from the energy. `late`: what the rates of both sub-steps, which are those
  // of their middles, lack of the moment between them.
  Real bounce(Real e, Real u, Real depth, Real rise, Real pull, Real late) const {
    if (u >= 0) return 0;
    const Real at_surface = square(u + late) + 2 * pull * depth;
    return max(Real(0), sqrt(max(Real(0), square(e) * max(Real(0), at_surface) + 2 * pull * (rise - depth))) + late);
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
};

}

void strike_contacts(const SoftBatch& batch) { Impacts(batch).strike_all(); }
void leave_bouncing_alone(const SoftBatch& batch) { Impacts(batch).leave_bouncing_alone(); }

}
