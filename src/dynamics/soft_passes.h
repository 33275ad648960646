// The passes of soft_step over contacts side by side, W in a register, and the table of all passes; compiled for each
// width by soft_passes_*.cc with what the processor must have for it.
#pragma once

#include "dynamics/soft_balls.h"
#include "dynamics/soft_motion.h"

namespace sudar::inline SUDAR_PRECISION {

template <int W>
class SoftPasses : SoftPair<W> {
  using Base = SoftPair<W>;
  using typename Base::V, typename Base::Vec, typename Base::Way, typename Base::Side;
  using Base::get, Base::put, Base::on_a_, Base::on_b_, Base::save;

 public:
  static constexpr SoftPassTable table() {
    return {W,
            [](SoftMotion* motions, std::size_t n, SoftBody* bodies, const PassSettings& set) {
              each(motions, n, [&]<int w>(SoftMotion& m, int first) { SoftMotions<w>(first, bodies, set).begin(m); });
            },
            [](SoftMotion* motions, std::size_t n, SoftBody* bodies, const PassSettings& set) {
              each(motions, n, [&]<int w>(SoftMotion& m, int first) { SoftMotions<w>(first, bodies, set).drift(m); });
            },
            [](SoftMotion* motions, std::size_t n, SoftBody* bodies, const PassSettings& set) {
              each(motions, n, [&]<int w>(SoftMotion& m, int first) { SoftMotions<w>(first, bodies, set).settle(m); });
            },
            [](SoftRows* rows, std::size_t n, SoftBody* bodies, const PassSettings& set) {
              each(rows, n, [&]<int w>(SoftRows& r, int first) { SoftPasses<w>(r, first, bodies, set).answer_all(r); });
            },
            [](SoftRows* rows, std::size_t n, SoftBody* bodies, const PassSettings& set) {
              each(rows, n, [&]<int w>(SoftRows& r, int first) { SoftPasses<w>(r, first, bodies, set).answer_again(r); });
            },
            [](const SoftRows* rows, std::size_t n, SoftBody* bodies, const PassSettings& set) {
              each(rows, n, [&]<int w>(const SoftRows& r, int first) {
                by_points(r, [&]<int points> { SoftPasses<w>(r, first, bodies, set).template warm<points>(r); });
              });
            },
            [](SoftRows* rows, std::size_t n, SoftBody* bodies, const PassSettings& set) {
              each(rows, n, [&]<int w>(SoftRows& r, int first) {
                by_points(r, [&]<int points> { SoftPasses<w>(r, first, bodies, set).template solve<points>(r); });
              });
            },
            [](SoftRows* rows, std::size_t n, SoftBody* bodies, const PassSettings& set) {
              each(rows, n, [&]<int w>(SoftRows& r, int first) {
                by_points(r, [&]<int points> { SoftPasses<w>(r, first, bodies, set).template relax<points>(r); });
              });
            },
            [](const SoftBallRows* rows, std::size_t n, SoftBody* bodies, const PassSettings& set) {
              each(rows, n, [&]<int w>(const SoftBallRows& r, int first) { SoftBalls<w>(r, first, bodies, set).warm(r); });
            },
            [](SoftBallRows* rows, std::size_t n, SoftBody* bodies, const PassSettings& set) {
              each(rows, n, [&]<int w>(SoftBallRows& r, int first) { SoftBalls<w>(r, first, bodies, set).solve(r); });
            },
            [](SoftBallRows* rows, std::size_t n, SoftBody* bodies, const PassSettings& set) {
              each(rows, n, [&]<int w>(SoftBallRows& r, int first) { SoftBalls<w>(r, first, bodies, set).relax(r); });
            }};
  }

 private:
  // Every W lanes in use; fewer where few are left.
  template <class Rows, class Visit>
  [[gnu::always_inline]] static void each(Rows* rows, std::size_t n, Visit visit) {
    for (Rows* r = rows; r != rows + n; ++r) {
      const int used = int(r->used);
      for (int first = 0; first < used; first += W) {
        const int left = used - first;
        if (W > 4 && left <= 4) visit.template operator()<smaller<W, 4>>(*r, first);
        else if (W > 8 && left <= 8) visit.template operator()<smaller<W, 8>>(*r, first);
        else visit.template operator()<W>(*r, first);
      }
    }
  }
  // Most contacts of round bodies have one point, and are spared the arithmetic of four.
  template <class Visit>
  [[gnu::always_inline]] static void by_points(const SoftRows& r, Visit visit) {
    if (r.most_points == 4) visit.template operator()<4>();
    else if (r.most_points == 2) visit.template operator()<2>();
    else visit.template operator()<1>();
  }
  template <int a, int b>
  static constexpr int smaller = a < b ? a : b;

  template <int>
  friend class SoftPasses;
  [[gnu::always_inline]] SoftPasses(const SoftRows& r, int first, SoftBody* bodies, const PassSettings& set)
      : Base(first, bodies, r.a, r.b), set_(set), n_(get(r.n)), t1_(get(r.t1)), t2_(cross(n_, t1_)), ra_(get(r.ra)),
        rb_(get(r.rb)) {}

  // How three velocities answer three impulses.
  struct Answer {
    [[gnu::always_inline]] void add(const V& m0, const V& m1, const Symmetric3<V>& inertia, const Vec& j0, const Vec& j1,
                                    const Vec& j2) {
      const Vec i0 = inertia * j0, i1 = inertia * j1, i2 = inertia * j2;
      k.xx += m0 + dot(j0, i0), k.xy += dot(j0, i1), k.xz += dot(j0, i2);
      k.yy += m1 + dot(j1, i1), k.yz += dot(j1, i2), k.zz += dot(j2, i2);
    }
    // Along the normal at a point.
    [[gnu::always_inline]] V at(const V& x, const V& y) const {
      const V two = wide::all<V>(2);
      return k.xx + two * (x * k.xy + y * k.xz) + x * x * k.yy + two * x * y * k.yz + y * y * k.zz;
    }
    // The larger eigenvalue along the surface at a point.
    [[gnu::always_inline]] V largest(const V& x, const V& y) const {
      const V two = wide::all<V>(2);
      return larger_eigenvalue(k.xx - two * y * k.xz + y * y * k.zz, k.yy + two * x * k.yz + x * x * k.zz,
                               k.xy + x * k.xz - y * k.yz - x * y * k.zz);
    }
    [[gnu::always_inline]] static V larger_eigenvalue(const V& k11, const V& k22, const V& k12) {
      const V half = wide::all<V>(Real(0.5)), apart = (k11 - k22) * half;
      return (k11 + k22) * half + wide::root(apart * apart + k12 * k12);
    }
    Symmetric3<V> k;
  };

  // `which`: in which lanes.
  template <class Mask>
  [[gnu::always_inline]] void answer(SoftRows& r, const Mask& which) {
    const V zero{}, one = wide::all<V>(1);
    const auto renew = [&](SoftLanes& m, const V& v) { put(m, which ? v : get(m)); };
    const auto renew_all = [&](Symmetric3<SoftLanes>& m, const Symmetric3<V>& v) {
      renew(m.xx, v.xx), renew(m.xy, v.xy), renew(m.xz, v.xz), renew(m.yy, v.yy), renew(m.yz, v.yz), renew(m.zz, v.zz);
    };
    Answer press, slide;
    const auto side = [&](const Side& on, const Vec& arm) {
      press.add(on.inverse_mass, zero, on.inverse_inertia, cross(arm, n_), -t2_, t1_);
      slide.add(on.inverse_mass, on.inverse_mass, on.inverse_inertia, cross(arm, t1_), cross(arm, t2_), n_);
    };
    side(on_a_, ra_), side(on_b_, rb_);
    renew_all(r.press, press.k), renew_all(r.slide, slide.k);
    for (int i = 0; i < int(r.most_points); ++i) {
      SoftRows::Point& p = r.points[i];
      const V x = get(p.x), y = get(p.y);
      const auto is_one = get(p.normal_mass) > zero;
      renew(p.normal_mass, is_one ? one / press.at(x, y) : zero);
      renew(p.tangent_mass, is_one ? one / slide.largest(x, y) : zero);
    }
    renew(r.spin_mass, one / slide.k.zz);
    renew(r.roll_mass, one / Answer::larger_eigenvalue(press.k.yy, press.k.zz, press.k.yz));
  }
  [[gnu::always_inline]] void answer_all(SoftRows& r) { answer(r, V{} == V{}); }
  [[gnu::always_inline]] void answer_again(SoftRows& r) {
    const Way a = Base::way_of_a(), b = Base::way_of_b();
    const auto far = (dot(a.turn, a.turn) > a.most_turn) | (dot(b.turn, b.turn) > b.most_turn);
    if (wide::any(far)) answer(r, far);
  }

  template <int points>
  [[gnu::always_inline]] void warm(const SoftRows& r) {
    Vec press, slide;
    for (int i = 0; i < points; ++i) {
      const SoftRows::Point& p = r.points[i];
      const V x = get(p.x), y = get(p.y), normal = get(p.normal), f1 = get(p.friction_1), f2 = get(p.friction_2);
      press += Vec{normal, x * normal, y * normal};
      slide += Vec{f1, f2, x * f2 - y * f1};
    }
    push(press, slide);
    if (r.turning) turn({get(r.spin), get(r.roll_1), get(r.roll_2)});
    save();
  }
  template <int points>
  [[gnu::always_inline]] void solve(SoftRows& r) {
    press_points<points, true>(r);
    save();
  }
  template <int points>
  [[gnu::always_inline]] void relax(SoftRows& r) {
    press_points<points, false>(r);
    rub_points<points>(r);
    if (r.turning) resist_turning<points>(r);
    save();
  }

  // How the middle moves along the normal, and tilts.
  [[gnu::always_inline]] Vec pressing(const Vec& va, const Vec& wa, const Vec& vb, const Vec& wb) const {
    const Vec u = (va - vb) + (cross(wa, ra_) - cross(wb, rb_)), w = wa - wb;
    return {dot(u, n_), -dot(w, t2_), dot(w, t1_)};
  }

  template <int points, bool undo_overlap>
  [[gnu::always_inline]] void press_points(SoftRows& r) {
    way_a_ = Base::way_of_a(), way_b_ = Base::way_of_b();
    const Vec moved = pressing(way_a_.shift, way_a_.turn, way_b_.shift, way_b_.turn);
    Vec g = pressing(on_a_.v, on_a_.w, on_b_.v, on_b_.w);
    const Symmetric3<V> response = get(r.press);
    const V per_h = wide::all<V>(1 / set_.h), zero{}, lift = get(r.lift);
    V x[points], y[points], bias[points], mass[points], leak[points], reference[points], normal[points];
    for (int i = 0; i < points; ++i) {
      const SoftRows::Point& p = r.points[i];
      x[i] = get(p.x), y[i] = get(p.y), reference[i] = get(p.reference), normal[i] = get(p.normal);
      mass[i] = get(p.normal_mass);
      const V s = get(p.separation) + (moved.x + (x[i] * moved.y + y[i] * moved.z)) + lift;
      const V held = reference[i] > zero ? wide::all<V>(set_.reach) : zero;
      const auto apart = s > held;
      const V gap = s * per_h;
      if constexpr (undo_overlap) {
        bias[i] = apart ? gap : wide::larger(get(r.bias_rate) * s, wide::all<V>(-set_.push_speed));
        mass[i] = apart ? mass[i] : mass[i] * get(r.mass_scale);
        leak[i] = apart ? zero : get(r.impulse_scale);
      } else {
        bias[i] = apart ? gap : zero;
      }
    }
    Vec sum;
    for (int sweep = 0; sweep < 2; ++sweep) {
      for (int i = 0; i < points; ++i) {
        V next = normal[i] - mass[i] * (g.x + (x[i] * g.y + y[i] * g.z) + bias[i]);
        if constexpr (undo_overlap) next -= leak[i] * (normal[i] - reference[i]);
        next = wide::larger(next, zero);
        const V d = next - normal[i];
        normal[i] = next;
        const Vec step{d, x[i] * d, y[i] * d};
        sum += step;
        g += response * step;
      }
    }
    for (int i = 0; i < points; ++i) put(r.points[i].normal, normal[i]);
    push(sum, {});
  }

  // Friction, point by point, each as far as its own normal impulse lets it hold.
  template <int points>
  [[gnu::always_inline]] void rub_points(SoftRows& r) {
    arms_of_friction(r);
    const Vec u = (on_a_.v - on_b_.v) + (cross(on_a_.w, ra_) - cross(on_b_.w, rb_));
    Vec g{dot(u, t1_) + get(r.glide_1), dot(u, t2_) + get(r.glide_2), dot(on_a_.w - on_b_.w, n_)};
    const Symmetric3<V> response = get(r.slide);
    const V coefficient = get(r.friction), one = wide::all<V>(1);
    Vec before, after;
    V load{};
    for (int i = 0; i < points; ++i) {
      SoftRows::Point& p = r.points[i];
      const V x = get(p.x), y = get(p.y), mass = get(p.tangent_mass), f1 = get(p.friction_1), f2 = get(p.friction_2);
      V next_1 = f1 - mass * (g.x - y * g.z), next_2 = f2 - mass * (g.y + x * g.z);
      const V normal = get(p.normal), most = coefficient * normal, size = next_1 * next_1 + next_2 * next_2;
      const V cut = size > most * most ? most / wide::root(wide::larger(size, wide::all<V>(tiny))) : one;
      next_1 *= cut, next_2 *= cut;
      put(p.friction_1, next_1), put(p.friction_2, next_2);
      load += normal;
      before += Vec{f1, f2, x * f2 - y * f1}, after += Vec{next_1, next_2, x * next_2 - y * next_1};
      const V d1 = next_1 - f1, d2 = next_2 - f2;
      g += response * Vec{d1, d2, x * d2 - y * d1};
    }
    // What slips as a whole is held by dynamic friction only, from this moment on.
    const V edge = coefficient * load * wide::all<V>(Real(0.999)), dynamic = get(r.friction_dynamic);
    const auto slips = after.x * after.x + after.y * after.y > edge * edge;
    const V left = slips ? dynamic / coefficient : one;
    for (int i = 0; i < points; ++i) {
      SoftRows::Point& p = r.points[i];
      put(p.friction_1, get(p.friction_1) * left), put(p.friction_2, get(p.friction_2) * left);
    }
    put(r.friction, slips ? dynamic : coefficient);
    push({}, after * left - before);
  }

  // Where the contact was in the middle of the drift: on its owner, whose turn about the normal takes it
  // along, and from there on the other. Friction that asked for velocities where the contact was would send what is
  // carried round in circles outwards.
  [[gnu::always_inline]] void arms_of_friction(const SoftRows& r) {
    const Way &a = way_a_, &b = way_b_;
    const V half = wide::all<V>(set_.h * Real(-0.5)), one = wide::all<V>(1);
    const auto of_a = get(r.owned_by_a) > V{};
    // Half the angle, for the Cayley map: whatever it is, the arm keeps its length.
    const V k = (of_a ? dot(a.turn + on_a_.w * half, n_) : dot(b.turn + on_b_.w * half, n_)) * wide::all<V>(Real(0.5));
    const V share = (k + k) / (one + k * k);
    const Vec own{of_a ? ra_.x : rb_.x, of_a ? ra_.y : rb_.y, of_a ? ra_.z : rb_.z};
    const Vec side = cross(n_, own), across = cross(n_, side);
    const Vec turned = own + (side + across * k) * share;
    const Vec apart = get(r.apart) + (a.shift - b.shift) + (on_a_.v - on_b_.v) * half;
    const Vec before = turned - apart, after = turned + apart;
    const auto far = k * k > wide::all<V>(most_half_turn * most_half_turn);
    const auto choose = [&](const Vec& start, const Vec& on_a, const Vec& on_b) {
      return Vec{far ? start.x : of_a ? on_a.x : on_b.x, far ? start.y : of_a ? on_a.y : on_b.y,
                 far ? start.z : of_a ? on_a.z : on_b.z};
    };
    ra_ = choose(ra_, turned, before);
    rb_ = choose(rb_, after, turned);
  }

  template <int points>
  [[gnu::always_inline]] void resist_turning(SoftRows& r) {
    V load{};
    for (int i = 0; i < points; ++i) load += get(r.points[i].normal);
    const Vec w = on_a_.w - on_b_.w;
    const V spin = get(r.spin), roll_1 = get(r.roll_1), roll_2 = get(r.roll_2), roll_mass = get(r.roll_mass);
    const V most = get(r.spinning) * load, roll_most = get(r.rolling) * load;
    const V next = wide::smaller(wide::larger(spin - get(r.spin_mass) * dot(w, n_), -most), most);
    V next_1 = roll_1 - roll_mass * dot(w, t1_), next_2 = roll_2 - roll_mass * dot(w, t2_);
    const V size = next_1 * next_1 + next_2 * next_2;
    const V cut = size > roll_most * roll_most ? roll_most / wide::root(wide::larger(size, wide::all<V>(tiny))) : wide::all<V>(1);
    next_1 *= cut, next_2 *= cut;
    put(r.spin, next), put(r.roll_1, next_1), put(r.roll_2, next_2);
    turn({next - spin, next_1 - roll_1, next_2 - roll_2});
  }
  // Moments about n, t1, t2.
  [[gnu::always_inline]] void turn(const Vec& m) {
    const Vec moment = n_ * m.x + t1_ * m.y + t2_ * m.z;
    Base::push({}, moment, moment);
  }

  [[gnu::always_inline]] void push(const Vec& press, const Vec& slide) {
    const Vec force = n_ * press.x + t1_ * slide.x + t2_ * slide.y;
    const Vec moment = t1_ * press.z - t2_ * press.y + n_ * slide.z;
    Base::push(force, moment + cross(ra_, force), moment + cross(rb_, force));
  }

  static constexpr Real most_half_turn = Real(0.1);  // rad, since the step began, with which arms of friction still turn
  static constexpr Real tiny = std::numeric_limits<Real>::min();

  const PassSettings& set_;
  Vec n_, t1_, t2_, ra_, rb_;
  Way way_a_, way_b_;  // since the step began
};

}
