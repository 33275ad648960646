// Ball joints in soft_step, W side by side: two anchors held together as by a spring of 60 Hz that is damped twice as
// much as it needs; then, in relax, their velocities exactly.
#pragma once

#include "dynamics/soft_pair.h"

namespace sudar::inline SUDAR_PRECISION {

template <int W>
class SoftBalls : SoftPair<W> {
  using Base = SoftPair<W>;
  using typename Base::V, typename Base::Vec, typename Base::Way, typename Base::Side;
  using Base::get, Base::put, Base::on_a_, Base::on_b_, Base::save;

 public:
  [[gnu::always_inline]] SoftBalls(const SoftBallRows& r, int first, SoftBody* bodies, const PassSettings& set)
      : Base(first, bodies, r.a, r.b), set_(set) {
    const Way a = Base::way_of_a(), b = Base::way_of_b();
    const Vec arm_a = get(r.ra), arm_b = get(r.rb);
    ra_ = turned(arm_a, a.turn), rb_ = turned(arm_b, b.turn);
    gap_ = get(r.gap) + ((a.shift - b.shift) + ((ra_ - arm_a) - (rb_ - arm_b)));
  }

  [[gnu::always_inline]] void warm(const SoftBallRows& r) {
    push(get(r.impulse));
    save();
  }
  [[gnu::always_inline]] void solve(SoftBallRows& r) {
    const Vec bias = gap_ * wide::all<V>(set_.joint_bias_rate), sum = get(r.impulse);
    const Vec step = answer(rate() + bias) * wide::all<V>(-set_.joint_mass_scale) -
                     sum * wide::all<V>(set_.joint_impulse_scale);
    put(r.impulse, sum + step);
    push(step);
    save();
  }
  [[gnu::always_inline]] void relax(SoftBallRows& r) {
    const Vec step = -answer(rate());
    put(r.impulse, get(r.impulse) + step);
    push(step);
    save();
  }

 private:
  // By the Cayley map: whatever the angle, the arm keeps its length.
  [[gnu::always_inline]] static Vec turned(const Vec& arm, const Vec& turn) {
    const Vec k = turn * wide::all<V>(Real(0.5)), side = cross(k, arm);
    return arm + (side + cross(k, side)) * (wide::all<V>(2) / (wide::all<V>(1) + dot(k, k)));
  }
  [[gnu::always_inline]] Vec rate() const {
    return (on_a_.v - on_b_.v) + (cross(on_a_.w, ra_) - cross(on_b_.w, rb_));
  }
  [[gnu::always_inline]] void push(const Vec& impulse) { Base::push(impulse, cross(ra_, impulse), cross(rb_, impulse)); }

  // K⁻¹ u, thesis (3.23), by cofactors.
  [[gnu::always_inline]] Vec answer(const Vec& u) const {
    const V m = on_a_.inverse_mass + on_b_.inverse_mass;
    Symmetric3<V> k{m, V{}, V{}, m, V{}, m};
    add(k, on_a_, ra_), add(k, on_b_, rb_);
    const Vec c0{k.xx, k.xy, k.xz}, c1{k.xy, k.yy, k.yz}, c2{k.xz, k.yz, k.zz};
    const Vec r0 = cross(c1, c2), r1 = cross(c2, c0), r2 = cross(c0, c1);
    const V det = dot(c0, r0), per = wide::all<V>(1) / (det == V{} ? wide::all<V>(1) : det);
    return Vec{dot(r0, u), dot(r1, u), dot(r2, u)} * per;
  }
  // − [r]× I⁻¹ [r]×
  [[gnu::always_inline]] static void add(Symmetric3<V>& k, const Side& on, const Vec& r) {
    const V zero{};
    const Vec e0{zero, r.z, -r.y}, e1{-r.z, zero, r.x}, e2{r.y, -r.x, zero};  // r × unit vectors
    const Vec i0 = on.inverse_inertia * e0, i1 = on.inverse_inertia * e1, i2 = on.inverse_inertia * e2;
    k.xx += dot(e0, i0), k.xy += dot(e0, i1), k.xz += dot(e0, i2);
    k.yy += dot(e1, i1), k.yz += dot(e1, i2), k.zz += dot(e2, i2);
  }

  const PassSettings& set_;
  Vec ra_, rb_, gap_;  // where the anchors are now
};

}
