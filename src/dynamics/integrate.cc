#include "dynamics/integrate.h"

namespace sudar::inline SUDAR_PRECISION {

namespace {

Vec3 spin_at(const Bodies& b, std::uint32_t i, const Quat& q, const Vec3& angular_momentum) {
  return rotate(q, scale(rotate_back(q, angular_momentum), b.inverse_inertia[i]));
}

}

bool place(Bodies& b, std::uint32_t i, const BodyMotion& m) {
  const Vec3 spin = spin_at(b, i, m.orientation, m.angular_momentum);
  if (!is_finite(m.position) || !is_finite(m.orientation) || !is_finite(m.velocity) ||
      !is_finite(m.angular_momentum) || !is_finite(spin)) {
    return false;
  }
  b.position[i] = m.position;
  b.orientation[i] = m.orientation;
  b.velocity[i] = m.velocity;
  b.angular_momentum[i] = m.angular_momentum;
  b.spin[i] = spin;
  return true;
}

Vec3 spin_of(const Bodies& b, std::uint32_t i) { return spin_at(b, i, b.orientation[i], b.angular_momentum[i]); }

SolverBody solver_body(const Bodies& b, std::uint32_t i) {
  SolverBody s;
  s.spin_before = b.dynamic(i) ? spin_of(b, i) : b.spin[i];
  s.real = {lanes(b.velocity[i]), lanes(s.spin_before)};
  if (b.dynamic(i)) s.inverse_mass = b.inverse_mass[i], s.inverse_inertia = lanes(b.inverse_inertia_world(i));
  return s;
}

void accelerate(const Bodies& b, std::uint32_t i, const Wrench& load, const DragRates& drag, Real h, SolverBody& body) {
  Vec3 v = vector(body.real.v), w = vector(body.real.w);
  v += load.force * (b.inverse_mass[i] * h);
  if (load.torque != Vec3{}) w += vector(body.inverse_inertia * lanes(load.torque)) * h;
  const Real rate = drag.linear + drag.quadratic * length(v);
  const Real angular_rate = drag.angular + drag.angular_quadratic * length(w);
  // v/(1 + h rate) as a difference: a rounded factor near 1 would act with the same error in every step (verify V02).
  if (rate > 0) v -= v * (h * rate / (1 + h * rate));
  if (angular_rate > 0) w -= w * (h * angular_rate / (1 + h * angular_rate));
  body.real = {lanes(v), lanes(w)};
}

namespace {

Vec3 momentum(const Bodies& b, std::uint32_t i, const SolverBody& body) {
  return b.angular_momentum[i] + b.inertia_world(i) * (vector(body.real.w) - body.spin_before);
}

}

Ahead ahead(const Bodies& b, std::uint32_t i, const SolverBody& body, Real h) {
  const Pos p = b.position[i] + vector(body.real.v) * h;
  const Vec3 w = vector(body.real.w);
  if (!b.dynamic(i)) return {{p, normalize(rotation(w * h) * b.orientation[i])}, w};
  const Rotation r = rotate_freely(b.orientation[i], momentum(b, i, body), b.inertia[i], b.inverse_inertia[i], h);
  return {{p, r.orientation}, r.spin};
}

bool drift(Bodies& b, std::uint32_t i, const SolverBody& body, Real h) {
  const Vec3 v = vector(body.real.v), push_v = vector(body.push.v), push_w = vector(body.push.w);
  const Vec3 angular_momentum = momentum(b, i, body);
  Quat q = rotate_freely(b.orientation[i], angular_momentum, b.inertia[i], b.inverse_inertia[i], h).orientation;
  if (push_w != Vec3{}) q = normalize(rotation(push_w * h) * q);
  return place(b, i, {b.position[i] + (v + push_v) * h, q, v, angular_momentum});
}

void carry(Bodies& b, std::uint32_t i, Real h) {
  b.position[i] = b.position[i] + b.velocity[i] * h;
  b.orientation[i] = normalize(rotation(b.spin[i] * h) * b.orientation[i]);
}

std::vector<std::uint32_t> runge_kutta_4(Bodies& b, const Forces& forces, std::span<const std::uint32_t> which, Real h) {
  struct Rate {
    Vec3 v, a;      // ẋ, v̇
    Quat q;         // q̇
    Vec3 torque;    // L̇
  };
  const std::size_t n = which.size();
  if (n == 0) return {};
  std::vector<Pos> start(n);  // the bodies themselves visit the four states; others are seen where they are
  std::vector<Quat> start_turn(n);
  std::vector<Vec3> velocity(n), momentum(n);
  std::vector<Rate> sum(n), rate(n);
  std::vector<Wrench> load;
  for (std::size_t k = 0; k < n; ++k) {
    const std::uint32_t i = which[k];
    start[k] = b.position[i], start_turn[k] = b.orientation[i];
    velocity[k] = b.velocity[i], momentum[k] = b.angular_momentum[i];
  }

  const auto measure = [&] {
    evaluate(forces, b, which, load);
    for (std::size_t k = 0; k < n; ++k) {
      const std::uint32_t i = which[k];
      const DragRates drag = drag_on(forces, b, i);
      const Vec3 v = velocity[k], w = spin_at(b, i, b.orientation[i], momentum[k]);
      const Real linear = drag.linear + drag.quadratic * length(v);
      const Real angular = drag.angular + drag.angular_quadratic * length(w);
      const Quat spin{w.x, w.y, w.z, 0}, q = spin * b.orientation[i];
      rate[k] = {v, load[k].force * b.inverse_mass[i] - v * linear,
                 {q.x * Real(0.5), q.y * Real(0.5), q.z * Real(0.5), q.w * Real(0.5)},
                 load[k].torque - momentum[k] * angular};
    }
  };
  const auto moved = [](const Quat& q, const Quat& r, Real s) {
    return Quat{q.x + r.x * s, q.y + r.y * s, q.z + r.z * s, q.w + r.w * s};
  };
  constexpr Real weight[] = {Real(1.0 / 6), Real(1.0 / 3), Real(1.0 / 3), Real(1.0 / 6)};
  constexpr Real next[] = {Real(0.5), Real(0.5), 1, 0};  // where the following rate is measured
  for (int stage = 0; stage < 4; ++stage) {
    measure();
    for (std::size_t k = 0; k < n; ++k) {
      const std::uint32_t i = which[k];
      Rate& s = sum[k];
      const Rate& r = rate[k];
      if (stage == 0) s.q = {0, 0, 0, 0};
      s.v += r.v * weight[stage], s.a += r.a * weight[stage], s.torque += r.torque * weight[stage];
      s.q = moved(s.q, r.q, weight[stage]);
      const Real step = h * next[stage];
      b.position[i] = start[k] + r.v * step;
      velocity[k] = b.velocity[i] + r.a * step;
      b.orientation[i] = normalize(moved(start_turn[k], r.q, step));
      momentum[k] = b.angular_momentum[i] + r.torque * step;
    }
  }
  std::vector<std::uint32_t> broken;
  for (std::size_t k = 0; k < n; ++k) {
    const std::uint32_t i = which[k];
    const Rate& r = sum[k];
    b.position[i] = start[k], b.orientation[i] = start_turn[k];
    const BodyMotion end{b.position[i] + r.v * h, normalize(moved(b.orientation[i], r.q, h)), b.velocity[i] + r.a * h,
                    b.angular_momentum[i] + r.torque * h};
    if (!place(b, i, end)) broken.push_back(i);
  }
  return broken;
}

}
