#include "world/physical.h"

#include <algorithm>

#include "base/text.h"
#include "dynamics/rotation.h"
#include "dynamics/solve.h"
#include "geometry/principal.h"

namespace sudar::inline SUDAR_PRECISION {

// --- bodies ---

namespace {

constexpr double greatest_product = greatest * greatest;

// A body's motion as sizes, and what its mass makes of it over the coming step.
struct Load {
  double mass = 0, inverse_mass = 0;                   // kg; of what no force moves: 0
  double largest_moment = 0, inverse_smallest_moment = 0;  // kg m²
  double speed = 0, spin = 0;                          // m/s, rad/s
  double force = 0, torque = 0;                        // N, N m; without gravity
  double gravity_factor = 0;

  // Momentum and energy, over m or kg m².
  static bool motion_fits(double inertia, double speed) {
    return speed <= greatest && inertia * speed <= greatest_product && inertia * speed * speed <= greatest_product;
  }
  bool way_fits(const Surroundings& around) const {
    const double fastest = speed + (force * inverse_mass + gravity_factor * around.gravity) * around.step;
    return mass * gravity_factor * around.gravity + force <= greatest_product && motion_fits(mass, fastest) &&
           fastest * around.step <= greatest;
  }
  // A turn is found by a determinant, in which half of each part of it stands to the third power (dynamics/rotation.h).
  bool turn_fits(const Surroundings& around) const {
    const double fastest = spin + torque * inverse_smallest_moment * around.step;
    const double turn = fastest * around.sub_step / (2 * most_free_steps);
    return torque <= greatest_product && motion_fits(largest_moment, fastest) &&
           (mass == 0 || turn * turn * turn <= greatest_product);
  }
};

template <class T>
double size(const Vec3T<T>& v) {
  return length(convert<double>(v));
}

Load load_of(const Bodies& b, std::uint32_t i) {
  Load load{.speed = size(b.velocity[i]), .spin = size(b.spin[i])};
  if (!b.dynamic(i)) return load;
  load.mass = double(b.mass[i]), load.inverse_mass = double(b.inverse_mass[i]);
  load.largest_moment = double(max_component(b.inertia[i]));
  load.inverse_smallest_moment = double(max_component(b.inverse_inertia[i]));
  load.force = size(b.force[i]), load.torque = size(b.torque[i]);
  load.gravity_factor = abs(double(b.gravity_factor[i]));
  return load;
}

constexpr const char* too_fast = "makes a speed, momentum, energy or way in a step that the precision cannot hold";
constexpr const char* too_fast_a_spin = "makes a spin, angular momentum or turn in a step that the precision cannot hold";

void check_velocity(const Load& load, const Surroundings& around) {
  if (!load.way_fits(around)) throw Error("velocity", too_fast);
  if (!load.turn_fits(around)) throw Error("spin", too_fast_a_spin);
}

// Which fields of a definition a mass comes from, and whether the inertia is a given one.
struct MassFields {
  const char *mass, *inertia;
  bool given = false;
};

// A body's load without its motion.
Load check_mass(const MassSum& sum, Motion motion, double gravity_factor, const MassFields& from, const Surroundings& around) {
  const auto fits = [](double x) { return std::isfinite(Real(x)) && Real(x) > 0 && std::isfinite(1 / Real(x)); };
  const double mass = sum.density * sum.unit.volume;
  if (!fits(mass)) throw Error(from.mass, "makes a mass of " + text(mass) + " kg, which the precision cannot hold");
  const Mat3d& tensor = sum.unit.inertia;
  const bool finite = is_finite(sum.unit.center) && is_finite(tensor.c0) && is_finite(tensor.c1) && is_finite(tensor.c2);
  const Vec3d moments = finite ? principal_frame(sum.unit).moments * sum.density : Vec3d{};
  if (motion == Motion::dynamic && !(fits(moments.x) && fits(moments.y) && fits(moments.z))) {
    throw Error(from.inertia, "makes an inertia that the precision cannot hold");
  }
  const double largest = max_component(moments);
  if (from.given && largest > 1.001 * (moments.x + moments.y + moments.z - largest)) {
    throw Error(from.inertia, "is of no body: a principal moment is greater than the sum of the others");
  }
  Load load;
  if (motion != Motion::dynamic) return load;
  load.mass = mass, load.inverse_mass = 1 / mass, load.gravity_factor = abs(gravity_factor);
  load.largest_moment = largest;
  load.inverse_smallest_moment = 1 / min(min(moments.x, moments.y), moments.z);
  if (load.mass * max(1.0, load.gravity_factor * around.gravity) > greatest_product) {
    throw Error(from.mass, "makes a mass of " + text(load.mass) + " kg, whose weight the precision cannot hold");
  }
  return load;
}

}

void check_body(const BodyDef& def, std::span<const ShapeDef> shapes, const Surroundings& around) {
  for (const ShapeDef& part : shapes) {
    if (may_have(def.motion, part.shape.kind())) continue;
    throw Error("motion", part.shape.kind() == ShapeKind::mesh ? "must be fixed or kinematic: a mesh has no mass"
                                                              : "must be fixed: a half space or a hollow has no mass");
  }
  if (def.motion == Motion::fixed && (def.velocity != Vec3{} || def.spin != Vec3{})) {
    throw Error(def.velocity != Vec3{} ? "velocity" : "spin", "must be zero: the body is fixed");
  }
  const std::optional<MassSum> sum = mass_of(def, shapes);
  if (!sum) {
    if (def.center || def.inertia) {
      throw Error(def.center ? "center" : "inertia", "is given, but a half space, a hollow or a mesh has none");
    }
    return;
  }
  const char* of_inertia = def.inertia ? "inertia" : def.shape ? "shape" : "shapes";
  Load load = check_mass(*sum, def.motion, double(def.gravity_factor), {def.mass > 0 ? "mass" : "density", of_inertia, def.inertia.has_value()}, around);
  load.speed = size(def.velocity), load.spin = size(def.spin);
  check_velocity(load, around);
}

void check_shape(const Bodies& b, std::uint32_t i, const MassSum& sum, const Surroundings& around) {
  Load load = check_mass(sum, b.motion[i], double(b.gravity_factor[i]), {"shape", "shape"}, around);
  if (b.motion[i] != Motion::dynamic) return;
  const Vec3d shift = sum.unit.center - convert<double>(inverse(b.frame[i]).p);  // of the centre, in the given frame
  load.speed = size(b.velocity[i]) + size(b.spin[i]) * length(shift);
  load.spin = size(b.spin[i]);
  load.force = size(b.force[i]), load.torque = size(b.torque[i]) + load.force * length(shift);
  if (!load.way_fits(around)) throw Error("shape", too_fast);
  if (!load.turn_fits(around)) throw Error("shape", too_fast_a_spin);
}

void check_velocity(const Bodies& b, std::uint32_t i, const Vec3& velocity, const Vec3& spin, const Surroundings& around) {
  Load load = load_of(b, i);
  load.speed = size(velocity), load.spin = size(spin);
  check_velocity(load, around);
}

void check_force(const char* field, const Bodies& b, std::uint32_t i, const Vec3& force, const Surroundings& around) {
  Load load = load_of(b, i);
  load.force = size(convert<double>(b.force[i]) + convert<double>(force));
  if (!load.way_fits(around)) throw Error(field, too_fast);
}

void check_torque(const char* field, const Bodies& b, std::uint32_t i, const Vec3& torque, const Surroundings& around) {
  Load load = load_of(b, i);
  load.torque = size(convert<double>(b.torque[i]) + convert<double>(torque));
  if (!load.turn_fits(around)) throw Error(field, too_fast_a_spin);
}

void check_surroundings(const char* field, const Bodies& b, const Surroundings& around) {
  if (!(around.gravity * square(around.step) <= greatest)) throw Error(field, too_fast);
  for (std::uint32_t i = 0; i < b.size(); ++i) {
    if (!b.slots.used(i) || b.quarantined[i] != 0) continue;
    const Load load = load_of(b, i);
    if (!load.way_fits(around)) throw Error(field, too_fast);
    if (!load.turn_fits(around)) throw Error(field, too_fast_a_spin);
  }
}

Surroundings surroundings(const Forces& forces, const Config& config, double dt) {
  const double step = dt * double(config.time_factor);
  return {size(gravity(forces)), step, step / substeps(config)};
}

void check_step(const char* field, const Surroundings& around) {
  if (!(around.sub_step > 0) || !std::isnormal(Real(around.sub_step)) || !(around.step <= greatest)) {
    throw Error(field, "makes a sub-step of " + text(around.sub_step) + " s, which the precision cannot hold");
  }
}

const char* name_of_step(const Config& config) {
  const double factor = double(config.time_factor);
  const bool long_step = config.dt * factor > 1, greater_factor = factor > config.dt;
  return long_step == greater_factor ? "time_factor" : "dt";
}

void check_config(const Config& config) { check_step(name_of_step(config), surroundings({}, config, config.dt)); }

// --- joints ---

const char* kind_of(const JointDef& def) {
  constexpr const char* names[] = {"bar",    "rope",   "ball", "hinge",       "slider",  "fixed", "plane",
                                   "muscle", "pulley", "reel", "orientation", "azimuth", "tilt",  "stroke"};
  static_assert(std::size(names) == std::variant_size_v<JointDef>);
  return names[def.index()];
}

namespace {

void check_limit(const Limit& limit, const std::string& field) {
  if (limit.low > limit.high) throw Error(field + ".low", "is above limit.high");
  if (limit.low > 0 && std::isinf(limit.low)) throw Error(field + ".low", "is infinite: nothing meets it");
  if (limit.high < 0 && std::isinf(limit.high)) throw Error(field + ".high", "is minus infinite: nothing meets it");
}

// An anchor must be a finite arm in this precision, seen from the body that it is on.
void check_anchors(const std::string& kind, const JointDef& def, const Bodies& bodies) {
  const auto check = [&](const char* name, Body body, const Pos& at) {
    if (!body.null() && !std::isfinite(length(at - bodies.position[body.index]))) {
      throw Error(kind + "." + name, "is farther from the body than the precision can tell");
    }
  };
  std::visit(
      [&](const auto& d) {
        if constexpr (requires { d.at, d.at_a; })
          check("at_a", d.a, d.at_a), check("at", d.b, d.at);
        else if constexpr (requires { d.at; })
          check("at", d.a, d.at), check("at", d.b, d.at);
        else
          check("at_a", d.a, d.at_a), check("at_b", d.b, d.at_b);
      },
      def);
}

}

void check_joint(const JointDef& def, const Bodies& bodies) {
  const std::string kind = kind_of(def);
  const Body a = body_a(def), b = body_b(def);
  if (a == b) throw Error(kind + ".b", "is the same body as a");
  check_anchors(kind, def, bodies);
  const bool moves = (!a.null() && bodies.dynamic(a.index)) || (!b.null() && bodies.dynamic(b.index));
  if (!moves) throw Error(kind + ".a", "and b are both unable to move: nothing to join");
  std::visit(
      [&](const auto& d) {
        if constexpr (requires { d.limit; }) check_limit(d.limit, kind + ".limit");
      },
      def);
  if (const auto* reel = std::get_if<Reel>(&def)) {
    const Vec3 away = reel->at_a - reel->at, across = away - reel->axis * dot(reel->axis, away);
    if (!(length(across) > reel->radius)) throw Error("reel.at_a", "lies within the axle");
  }
  if (const auto* azimuth = std::get_if<Azimuth>(&def)) {
    if (length(cross(azimuth->axis, azimuth->direction)) < Real(1e-3))
      throw Error("azimuth.direction", "lies along the axis");
  }
  if (const auto* bar = std::get_if<Bar>(&def); bar != nullptr && bar->at_a == bar->at_b) {
    throw Error("bar.at_b", "is the same point as at_a: use a ball joint");
  }
}

}
