// The passes of soft_step over rows of W contacts. Where a formula comes from: see soft_step.h.
#pragma once

#include <span>

#include "dynamics/soft_rows.h"

namespace sudar::inline SUDAR_PRECISION {

struct PassSettings {
  Real h;           // s
  Real push_speed;  // overlap is not undone faster, m/s
  Real reach;       // within which a loaded point is still held though it is apart, m
};

template <int W>
class SoftPasses {
 public:
  using V = Wide<W>;
  using Rows = SoftRows<W>;

  SoftPasses(std::span<SoftBody> bodies, const PassSettings& set) : bodies_(bodies.data()), set_(set) {}

  // Applies what is accumulated.
  void warm(std::span<const Rows> rows) const {
    for (const Rows& r : rows) {
      const Side a = load_velocity(r.a), b = load_velocity(r.b);
      Vec3T<V> press, slide;
      for (const auto& p : r.points) {
        press += Vec3T<V>{p.normal, p.x * p.normal, p.y * p.normal};
        slide += Vec3T<V>{p.friction_1, p.friction_2, p.x * p.friction_2 - p.y * p.friction_1};
      }
      apply(r, a, b, press, slide);
    }
  }

  // Normal impulses against overlap: soft below the reach, exact where points are farther apart.
  void solve(std::span<Rows> rows) const {
    for (Rows& r : rows) {
      const Side a = load_velocity(r.a), b = load_velocity(r.b);
      Vec3T<V> press;
      press_points<true>(r, a, b, press);
      apply(r, a, b, press, {});
    }
  }

  // The same without the push that undoes overlap, then friction.
  void relax(std::span<Rows> rows) const {
    for (Rows& r : rows) {
      const Side a = load_velocity(r.a), b = load_velocity(r.b);
      Vec3T<V> press, slide;
      press_points<false>(r, a, b, press);
      rub_points(r, a, b, press, slide);
      apply(r, a, b, press, slide);
    }
  }

 private:
  struct Side {
    Vec3T<V> v, w;
    V inverse_mass, pad;
    Symmetric3<V> inverse_inertia;
  };
  using Numbers = std::array<std::uint32_t, std::size_t(W)>;

  template <class Member>
  [[gnu::always_inline]] wide::Fours<W> load(const Numbers& n, Member SoftBody::* member) const {
    return wide::load<W>([&](int lane) { return static_cast<const void*>(&(bodies_[n[std::size_t(lane)]].*member)); });
  }
  [[gnu::always_inline]] Side load_velocity(const Numbers& n) const {
    const auto v = load(n, &SoftBody::v), w = load(n, &SoftBody::w), i = load(n, &SoftBody::xx), j = load(n, &SoftBody::yz);
    return {{v.x, v.y, v.z}, {w.x, w.y, w.z}, v.w, w.w, {i.x, i.y, i.z, i.w, j.x, j.y}};
  }

  // How the middle has moved along the normal, and tilted, since the step began.
  [[gnu::always_inline]] Vec3T<V> displacement(const Rows& r, const Vec3T<V>& t2) const {
    const auto sa = load(r.a, &SoftBody::shift), sb = load(r.b, &SoftBody::shift);
    const auto ta = load(r.a, &SoftBody::turn), tb = load(r.b, &SoftBody::turn);
    return pressing(r, t2, {sa.x, sa.y, sa.z}, {ta.x, ta.y, ta.z}, {sb.x, sb.y, sb.z}, {tb.x, tb.y, tb.z});
  }
  [[gnu::always_inline]] static Vec3T<V> pressing(const Rows& r, const Vec3T<V>& t2, const Vec3T<V>& va, const Vec3T<V>& wa,
                                                  const Vec3T<V>& vb, const Vec3T<V>& wb) {
    const Vec3T<V> u = (va - vb) + (cross(wa, r.ra) - cross(wb, r.rb)), w = wa - wb;
    return {dot(u, r.n), -dot(w, t2), dot(w, r.t1)};
  }

  template <bool push>
  [[gnu::always_inline]] void press_points(Rows& r, const Side& a, const Side& b, Vec3T<V>& sum) const {
    const Vec3T<V> t2 = cross(r.n, r.t1);
    const Vec3T<V> moved = displacement(r, t2);
    Vec3T<V> g = pressing(r, t2, a.v, a.w, b.v, b.w);
    const V per_h = wide::all<V>(1 / set_.h), zero{};
    V bias[4], mass[4], leak[4];
    for (std::size_t i = 0; i < 4; ++i) {
      const auto& p = r.points[i];
      const V s = p.separation + (moved.x + (p.x * moved.y + p.y * moved.z)) + r.lift;
      const V held = p.reference > 0 ? wide::all<V>(set_.reach) : zero;
      const auto apart = s > held;
      const V gap = (s - held) * per_h;
      if constexpr (push) {
        bias[i] = apart ? gap : wide::larger(r.bias_rate * s, wide::all<V>(-set_.push_speed));
        mass[i] = apart ? p.normal_mass : p.normal_mass * r.mass_scale;
        leak[i] = apart ? zero : r.impulse_scale;
      } else {
        bias[i] = apart ? gap : zero;
        mass[i] = p.normal_mass;
      }
    }
    const int sweeps = 2;
    for (int sweep = 0; sweep < sweeps; ++sweep) {
      for (std::size_t i = 0; i < 4; ++i) {
        auto& p = r.points[i];
        const V u = g.x + (p.x * g.y + p.y * g.z);
        V next = p.normal - mass[i] * (u + bias[i]);
        if constexpr (push) next -= leak[i] * (p.normal - p.reference);
        next = wide::larger(next, zero);
        const V d = next - p.normal;
        p.normal = next;
        const Vec3T<V> step{d, p.x * d, p.y * d};
        sum += step;
        g += r.press * step;
      }
    }
  }

  // Friction, point by point, each as far as its own normal impulse lets it hold.
  [[gnu::always_inline]] void rub_points(Rows& r, const Side& a, const Side& b, const Vec3T<V>& press, Vec3T<V>& sum) const {
    const Vec3T<V> t2 = cross(r.n, r.t1);
    Side moved_a = a, moved_b = b;
    push(r, t2, moved_a, moved_b, press, {});
    const Vec3T<V> u = (moved_a.v - moved_b.v) + (cross(moved_a.w, r.ra) - cross(moved_b.w, r.rb));
    Vec3T<V> g{dot(u, r.t1) + r.glide_1, dot(u, t2) + r.glide_2, dot(moved_a.w - moved_b.w, r.n)};
    for (auto& p : r.points) {
      V next_1 = p.friction_1 - p.tangent_mass * (g.x - p.y * g.z);
      V next_2 = p.friction_2 - p.tangent_mass * (g.y + p.x * g.z);
      const V most = r.friction * p.normal, size = next_1 * next_1 + next_2 * next_2;
      const V cut = size > most * most ? most / wide::root(wide::larger(size, wide::all<V>(tiny))) : wide::all<V>(1);
      next_1 *= cut, next_2 *= cut;
      const V d1 = next_1 - p.friction_1, d2 = next_2 - p.friction_2;
      p.friction_1 = next_1, p.friction_2 = next_2;
      const Vec3T<V> step{d1, d2, p.x * d2 - p.y * d1};
      sum += step;
      g += r.slide * step;
    }
  }

  [[gnu::always_inline]] static void push(const Rows& r, const Vec3T<V>& t2, Side& a, Side& b, const Vec3T<V>& press,
                                          const Vec3T<V>& slide) {
    const Vec3T<V> force = r.n * press.x + r.t1 * slide.x + t2 * slide.y;
    const Vec3T<V> moment = r.t1 * press.z - t2 * press.y + r.n * slide.z;
    a.v += force * a.inverse_mass;
    a.w += a.inverse_inertia * (moment + cross(r.ra, force));
    b.v -= force * b.inverse_mass;
    b.w -= b.inverse_inertia * (moment + cross(r.rb, force));
  }
  [[gnu::always_inline]] void apply(const Rows& r, Side a, Side b, const Vec3T<V>& press, const Vec3T<V>& slide) const {
    push(r, cross(r.n, r.t1), a, b, press, slide);
    save(r.a, a), save(r.b, b);
  }
  [[gnu::always_inline]] void save(const Numbers& n, const Side& s) const {
    const auto put = [&](auto member, const V& x, const V& y, const V& z, const V& w) {
      wide::store<W>({x, y, z, w}, [&](int lane, const Wide<4>& four) {
        const std::uint32_t body = n[std::size_t(lane)];
        if (body != 0) *reinterpret_cast<Wide<4>*>(&(bodies_[body].*member)) = four;
      });
    };
    put(&SoftBody::v, s.v.x, s.v.y, s.v.z, s.inverse_mass);
    put(&SoftBody::w, s.w.x, s.w.y, s.w.z, s.pad);
  }

  static constexpr Real tiny = std::numeric_limits<Real>::min();

  SoftBody* bodies_;
  PassSettings set_;
};

}
