#include "dynamics/forces.h"

#include <algorithm>

namespace sudar::inline SUDAR_PRECISION {

namespace {

template <class Kind, class Visit>
void for_each(const Forces& forces, Visit visit) {
  for (std::uint32_t i = 0; i < forces.slots.size(); ++i) {
    if (!forces.slots.used(i)) continue;
    if (const auto* force = std::get_if<Kind>(&forces.definition[i])) visit(*force);
  }
}

// Newton's gravity of every present body on body i, N.
Vec3 attraction(const NBody& law, const Bodies& bodies, std::uint32_t i) {
  const std::vector<Pos>& position = bodies.position;
  Vec3d sum;
  for (std::uint32_t j = 0; j < bodies.size(); ++j) {
    if (j == i || !bodies.slots.used(j) || bodies.mass[j] == 0) continue;
    const Vec3d d{position[j].x - position[i].x, position[j].y - position[i].y, position[j].z - position[i].z};
    const double r2 = dot(d, d) + square(double(law.softening));
    if (r2 > 0) sum += d * (double(bodies.mass[j]) / (r2 * sqrt(r2)));
  }
  const double factor = double(law.gravitational_constant) * double(bodies.mass[i]);
  return {Real(sum.x * factor), Real(sum.y * factor), Real(sum.z * factor)};
}

}

Vec3 gravity(const Forces& forces) {
  Vec3 g;
  for_each<Gravity>(forces, [&](const Gravity& f) { g += f.acceleration; });
  return g;
}

void evaluate(const Forces& forces, const Bodies& bodies, std::span<const std::uint32_t> which,
              std::vector<Wrench>& out) {
  out.resize(which.size());
  const Vec3 g = gravity(forces);
  for (std::size_t k = 0; k < which.size(); ++k) {
    const std::uint32_t i = which[k];
    out[k] = {g * (bodies.mass[i] * bodies.gravity_factor[i]) + bodies.force[i], bodies.torque[i]};
  }
  for_each<NBody>(forces, [&](const NBody& f) {
    for (std::size_t k = 0; k < which.size(); ++k) out[k].force += attraction(f, bodies, which[k]);
  });
  std::vector<const Thruster*> thrusters;  // by body, then in the order of forces
  for_each<Thruster>(forces, [&](const Thruster& f) { thrusters.push_back(&f); });
  if (thrusters.empty()) return;
  const auto by_body = [](const Thruster* f, const Thruster* g) { return f->body.index < g->body.index; };
  std::stable_sort(thrusters.begin(), thrusters.end(), by_body);
  for (std::size_t k = 0; k < which.size(); ++k) {
    const std::uint32_t i = which[k];
    Thruster here;
    here.body.index = i;
    const auto [first, last] = std::equal_range(thrusters.begin(), thrusters.end(), &here, by_body);
    for (auto f = first; f != last; ++f) {
      const Quat& q = bodies.orientation[i];
      const Vec3 force = rotate(q, rotate(bodies.frame[i].q, (*f)->force));
      out[k].force += force;
      out[k].torque += cross(rotate(q, bodies.frame[i].point((*f)->at)), force);
    }
  }
}

bool vary(const Forces& forces) {
  bool any = act_from_afar(forces);
  for_each<Thruster>(forces, [&](const Thruster&) { any = true; });
  return any;
}

bool act_from_afar(const Forces& forces) {
  bool any = false;
  for_each<NBody>(forces, [&](const NBody&) { any = true; });
  return any;
}

DragRates drag_on(const Forces& forces, const Bodies& bodies, std::uint32_t i) {
  DragRates sum;
  for_each<Drag>(forces, [&](const Drag& d) {
    if (!d.body.null() && d.body.index != i) return;
    sum.linear += d.linear;
    sum.quadratic += d.quadratic;
    sum.angular += d.angular + d.angular_per_radius * bodies.radius[i];
    sum.angular_quadratic += d.angular_quadratic;
  });
  return sum;
}

double potential_energy(const Forces& forces, const Bodies& bodies) {
  double sum = 0;
  const Vec3 g = gravity(forces);
  for (std::uint32_t i = 0; i < bodies.size(); ++i) {
    if (!bodies.slots.used(i) || !bodies.dynamic(i)) continue;
    const Pos& p = bodies.position[i];
    const double m = double(bodies.mass[i]);
    sum -= m * double(bodies.gravity_factor[i]) * (double(g.x) * p.x + double(g.y) * p.y + double(g.z) * p.z);
    for_each<NBody>(forces, [&](const NBody& law) {
      for (std::uint32_t j = 0; j < bodies.size(); ++j) {
        if (j == i || !bodies.slots.used(j) || (bodies.dynamic(j) && j < i)) continue;  // each pair once
        const Pos& o = bodies.position[j];
        const double r =
            sqrt(square(p.x - o.x) + square(p.y - o.y) + square(p.z - o.z) + square(double(law.softening)));
        if (r > 0) sum -= double(law.gravitational_constant) * m * double(bodies.mass[j]) / r;
      }
    });
  }
  return sum;
}

void write(Writer& w, const Forces& f) {
  write(w, f.slots);
  w.each("definition", f.definition);
}

void read(Reader& r, Forces& f) {
  read(r, f.slots);
  f.definition.resize(f.slots.size());
  for (Force& def : f.definition) read(r, def);
}

}
