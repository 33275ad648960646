// How bodies move in soft_step, W in a register.
#pragma once

#include "dynamics/soft_pair.h"

namespace sudar::inline SUDAR_PRECISION {

template <int W>
class SoftMotions : SoftAccess<W> {
  using Base = SoftAccess<W>;
  using typename Base::V, typename Base::Vec;
  using Base::first_, Base::get, Base::put;

 public:
  [[gnu::always_inline]] SoftMotions(int first, SoftBody* bodies, const PassSettings& set)
      : Base(first), bodies_(bodies), h_(wide::all<V>(set.h)) {}

  [[gnu::always_inline]] void begin(SoftMotion& m) const {
    const auto [v_in, w_in] = load_velocity(m);
    const V share = h_ * get(m.falls);
    Vec v = v_in + get(m.acceleration) * share, w = w_in + get(m.angular_acceleration) * share;
    // v / (1 + h rate), thesis (3.6), as a difference: a rounded factor near 1 would act with the same error every time.
    const V one = wide::all<V>(1);
    const V rate = (get(m.drag) + get(m.quadratic_drag) * wide::root(dot(v, v))) * share;
    const V turn_rate = (get(m.angular_drag) + get(m.quadratic_angular_drag) * wide::root(dot(w, w))) * share;
    v -= v * (rate / (one + rate)), w -= w * (turn_rate / (one + turn_rate));
    put(m.falls, one);
    take_momentum(m, w);
    put(m.spin, w);
    put(m.v_before, v), put(m.momentum_before, get(m.momentum));
    const auto i = load(m, &SoftBody::xx), j = load(m, &SoftBody::yz);
    const Symmetric3<V> inverse{i.x, i.y, i.z, i.w, j.x, j.y};
    save_velocity(m, v + get(m.gain_v), w + inverse * get(m.gain_momentum));
  }

  [[gnu::always_inline]] void drift(SoftMotion& m) const {
    const auto [v, w] = load_velocity(m);
    take_momentum(m, w);
    const Quat4 q = get(m.orientation);
    const Vec inertia = get(m.inertia), inverse = get(m.inverse_inertia), momentum = get(m.momentum);
    const Vec body_momentum = rotate_back(q, momentum);
    Vec spin = scale(body_momentum, inverse);
    const V angle = wide::root(dot(spin, spin)) * h_;
    put(m.orientation, turned(q, body_momentum, spin, inertia));
    const auto slow = angle < wide::all<V>(Real(0.25));
    if (wide::any(~slow)) {
      for (int lane = 0; lane < W; ++lane) {
        if (slow[lane]) continue;
        const auto at = std::uint32_t(first_ + lane);
        m.orientation.x[at] = q.x[lane], m.orientation.y[at] = q.y[lane];
        m.orientation.z[at] = q.z[lane], m.orientation.w[at] = q.w[lane];
        turn_in_parts(m, at, h_[0]);
      }
    }
    const Quat4 now = get(m.orientation);
    save_inertia(m, now, inverse);
    const Vec turned_spin = rotate(now, scale(rotate_back(now, momentum), inverse));
    put(m.spin, turned_spin);
    save_velocity(m, v, turned_spin);
    move(m, &SoftBody::shift, v);
    const auto turned = move(m, &SoftBody::turn, w);
    m.turned_far |= wide::any(turned.x * turned.x + turned.y * turned.y + turned.z * turned.z > turned.w);
  }

  [[gnu::always_inline]] void settle(SoftMotion& m) const {
    const auto [v, w] = load_velocity(m);
    take_momentum(m, w);
    put(m.gain_v, v - get(m.v_before)), put(m.gain_momentum, get(m.momentum) - get(m.momentum_before));
    const Quat4 q = get(m.orientation);
    const Vec spin = rotate(q, scale(rotate_back(q, get(m.momentum)), get(m.inverse_inertia)));
    put(m.spin, spin);
    save_velocity(m, v, spin);
  }

 private:
  struct Quat4 {
    V x, y, z, w;
    Vec vector() const { return {x, y, z}; }
  };
  [[gnu::always_inline]] static Vec rotate(const Quat4& q, const Vec& v) {
    const Vec c = cross(q.vector(), v), t = c + c;
    return v + t * q.w + cross(q.vector(), t);
  }
  [[gnu::always_inline]] static Vec rotate_back(const Quat4& q, const Vec& v) {
    return rotate({-q.x, -q.y, -q.z, q.w}, v);
  }

  // What impulses made of ω goes into the angular momentum; an untouched ω adds an exact zero.
  [[gnu::always_inline]] void take_momentum(SoftMotion& m, const Vec& w) const {
    const Quat4 q = get(m.orientation);
    const Vec change = rotate(q, scale(rotate_back(q, w - get(m.spin)), get(m.inertia)));
    put(m.momentum, get(m.momentum) + change);
  }

  // free_midpoint() of dynamics/rotation.h. `spin`: in the body's frame.
  [[gnu::always_inline]] Quat4 turned(const Quat4& q, const Vec& momentum, Vec spin, const Vec& inertia) const {
    const V unit = wide::all<V>(1) / wide::larger(wide::larger(wide::larger(inertia.x, inertia.y), inertia.z), wide::all<V>(tiny));
    const Vec d = inertia * unit, iw = scale(d, spin);
    const V k = h_ * wide::all<V>(Real(0.5));
    const Vec f = iw + cross(spin, iw) * k - momentum * unit;
    const V zero{};
    const Vec c0{d.x, k * (spin.z * d.x - iw.z), k * (iw.y - spin.y * d.x)};
    const Vec c1{k * (iw.z - spin.z * d.y), d.y, k * (spin.x * d.y - iw.x)};
    const Vec c2{k * (spin.y * d.z - iw.y), k * (iw.x - spin.x * d.z), d.z};
    const Vec r0 = cross(c1, c2), r1 = cross(c2, c0), r2 = cross(c0, c1);
    const V det = dot(c0, r0), per = wide::all<V>(1) / (det == zero ? wide::all<V>(1) : det);
    spin -= Vec{dot(r0, f), dot(r1, f), dot(r2, f)} * per;
    const V x = k * spin.x, y = k * spin.y, z = k * spin.z;
    const Quat4 p{q.w * x + q.x + q.y * z - q.z * y, q.w * y - q.x * z + q.y + q.z * x,
                  q.w * z + q.x * y - q.y * x + q.z, q.w - q.x * x - q.y * y - q.z * z};
    const V s = wide::all<V>(1) / wide::root(p.x * p.x + p.y * p.y + p.z * p.z + p.w * p.w);
    return {p.x * s, p.y * s, p.z * s, p.w * s};
  }

  // --- memory ---

  [[gnu::always_inline]] Quat4 get(const QuatT<SoftLanes>& m) const { return {get(m.x), get(m.y), get(m.z), get(m.w)}; }
  [[gnu::always_inline]] void put(QuatT<SoftLanes>& m, const Quat4& q) const {
    put(m.x, q.x), put(m.y, q.y), put(m.z, q.z), put(m.w, q.w);
  }

  [[gnu::always_inline]] SoftBody* body(const SoftMotion& m, int lane) const { return bodies_ + m.first + first_ + lane; }
  template <class Member>
  [[gnu::always_inline]] wide::Fours<W> load(const SoftMotion& m, Member SoftBody::* member) const {
    return wide::load<W>([&](int lane) { return static_cast<const void*>(&(body(m, lane)->*member)); });
  }
  template <class Member>
  [[gnu::always_inline]] void save(const SoftMotion& m, Member SoftBody::* member, const wide::Fours<W>& f) const {
    wide::store<W>(f, [&](int lane, const Wide<4>& four) {
      __builtin_memcpy(static_cast<void*>(&(body(m, lane)->*member)), &four, sizeof four);
    });
  }
  struct Velocity {
    Vec v, w;
  };
  [[gnu::always_inline]] Velocity load_velocity(const SoftMotion& m) const {
    const auto v = load(m, &SoftBody::v), w = load(m, &SoftBody::w);
    return {{v.x, v.y, v.z}, {w.x, w.y, w.z}};
  }
  [[gnu::always_inline]] void save_velocity(const SoftMotion& m, const Vec& v, const Vec& w) const {
    const auto old = load(m, &SoftBody::v);
    save(m, &SoftBody::v, {v.x, v.y, v.z, old.w});
    save(m, &SoftBody::w, {w.x, w.y, w.z, V{}});
  }
  [[gnu::always_inline]] wide::Fours<W> move(const SoftMotion& m, Vec3 SoftBody::* member, const Vec& velocity) const {
    const auto old = load(m, member);
    const wide::Fours<W> now{old.x + velocity.x * h_, old.y + velocity.y * h_, old.z + velocity.z * h_, old.w};
    save(m, member, now);
    return now;
  }
  [[gnu::always_inline]] void save_inertia(const SoftMotion& m, const Quat4& q, const Vec& d) const {
    const V one = wide::all<V>(1), two = wide::all<V>(2);
    const Vec c0{one - two * (q.y * q.y + q.z * q.z), two * (q.x * q.y + q.w * q.z), two * (q.x * q.z - q.w * q.y)};
    const Vec c1{two * (q.x * q.y - q.w * q.z), one - two * (q.x * q.x + q.z * q.z), two * (q.y * q.z + q.w * q.x)};
    const Vec c2{two * (q.x * q.z + q.w * q.y), two * (q.y * q.z - q.w * q.x), one - two * (q.x * q.x + q.y * q.y)};
    const Vec e0 = c0 * d.x, e1 = c1 * d.y, e2 = c2 * d.z;
    save(m, &SoftBody::xx, {e0.x * c0.x + e1.x * c1.x + e2.x * c2.x, e0.x * c0.y + e1.x * c1.y + e2.x * c2.y,
                            e0.x * c0.z + e1.x * c1.z + e2.x * c2.z, e0.y * c0.y + e1.y * c1.y + e2.y * c2.y});
    save(m, &SoftBody::yz, {e0.y * c0.z + e1.y * c1.z + e2.y * c2.z, e0.z * c0.z + e1.z * c1.z + e2.z * c2.z, V{}, V{}});
  }

  static constexpr Real tiny = std::numeric_limits<Real>::min();

  SoftBody* bodies_;
  V h_;
};

}
