// Two bodies of each of W contacts or joints side by side, in registers: what all passes read and write. Like all of
// soft_*.h below it, includes nothing that is also compiled elsewhere out of line: the linker would keep one copy, and it
// might be the one that not every processor can run.
#pragma once

#include "dynamics/soft_rows.h"
#include "math/wide.h"

namespace sudar::inline SUDAR_PRECISION {

// W lanes of what lies in memory.
template <int W>
class SoftAccess {
 protected:
  using V = Wide<W>;
  using Vec = Vec3T<V>;

  [[gnu::always_inline]] explicit SoftAccess(int first) : first_(first) {}

  [[gnu::always_inline]] V get(const SoftLanes& m) const {
    V v;
    __builtin_memcpy(&v, m.x + first_, sizeof v);
    return v;
  }
  [[gnu::always_inline]] Vec get(const Vec3T<SoftLanes>& m) const { return {get(m.x), get(m.y), get(m.z)}; }
  [[gnu::always_inline]] Symmetric3<V> get(const Symmetric3<SoftLanes>& m) const {
    return {get(m.xx), get(m.xy), get(m.xz), get(m.yy), get(m.yz), get(m.zz)};
  }
  [[gnu::always_inline]] void put(SoftLanes& m, const V& v) const { __builtin_memcpy(m.x + first_, &v, sizeof v); }
  [[gnu::always_inline]] void put(Vec3T<SoftLanes>& m, const Vec& v) const { put(m.x, v.x), put(m.y, v.y), put(m.z, v.z); }

  int first_;  // lane
};

template <int W>
class SoftPair : protected SoftAccess<W> {
 protected:
  using V = Wide<W>;
  using Vec = Vec3T<V>;
  struct Side {
    Vec v, w;
    V inverse_mass, pad;
    Symmetric3<V> inverse_inertia;
  };
  struct Way {  // since the step began
    Vec shift, turn;
    V most_turn;
  };

  [[gnu::always_inline]] SoftPair(int first, SoftBody* bodies, const std::uint32_t* a, const std::uint32_t* b)
      : SoftAccess<W>(first), bodies_(bodies), a_(a + first), b_(b + first), on_a_(load_velocity(a_)), on_b_(load_velocity(b_)) {}

  [[gnu::always_inline]] Way way_of_a() const { return load_way(a_); }
  [[gnu::always_inline]] Way way_of_b() const { return load_way(b_); }

  // An impulse and its moments about both centres of mass act on a, and against b.
  [[gnu::always_inline]] void push(const Vec& impulse, const Vec& moment_a, const Vec& moment_b) {
    on_a_.v += impulse * on_a_.inverse_mass;
    on_a_.w += on_a_.inverse_inertia * moment_a;
    on_b_.v -= impulse * on_b_.inverse_mass;
    on_b_.w -= on_b_.inverse_inertia * moment_b;
  }

  [[gnu::always_inline]] void save() const {
    store(a_, &SoftBody::v, {on_a_.v.x, on_a_.v.y, on_a_.v.z, on_a_.inverse_mass});
    store(a_, &SoftBody::w, {on_a_.w.x, on_a_.w.y, on_a_.w.z, on_a_.pad});
    store(b_, &SoftBody::v, {on_b_.v.x, on_b_.v.y, on_b_.v.z, on_b_.inverse_mass});
    store(b_, &SoftBody::w, {on_b_.w.x, on_b_.w.y, on_b_.w.z, on_b_.pad});
  }

 private:
  template <class Member>
  [[gnu::always_inline]] wide::Fours<W> load(const std::uint32_t* numbers, Member SoftBody::* member) const {
    return wide::load<W>([&](int lane) { return static_cast<const void*>(&(bodies_[numbers[lane]].*member)); });
  }
  [[gnu::always_inline]] Way load_way(const std::uint32_t* n) const {
    const auto shift = load(n, &SoftBody::shift), turn = load(n, &SoftBody::turn);
    return {{shift.x, shift.y, shift.z}, {turn.x, turn.y, turn.z}, turn.w};
  }
  [[gnu::always_inline]] Side load_velocity(const std::uint32_t* n) const {
    const auto v = load(n, &SoftBody::v), w = load(n, &SoftBody::w), i = load(n, &SoftBody::xx), j = load(n, &SoftBody::yz);
    return {{v.x, v.y, v.z}, {w.x, w.y, w.z}, v.w, w.w, {i.x, i.y, i.z, i.w, j.x, j.y}};
  }
  template <class Member>
  [[gnu::always_inline]] void store(const std::uint32_t* numbers, Member SoftBody::* member, const wide::Fours<W>& f) const {
    wide::store<W>(f, [&](int lane, const Wide<4>& four) {
      if (numbers[lane] != 0) __builtin_memcpy(static_cast<void*>(&(bodies_[numbers[lane]].*member)), &four, sizeof four);
    });
  }

  SoftBody* bodies_;
  const std::uint32_t *a_, *b_;

 protected:
  Side on_a_, on_b_;
};

}
