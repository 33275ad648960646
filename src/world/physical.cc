#include "world/physical.h"

#include "base/text.h"
#include "geometry/principal.h"

namespace sudar::inline SUDAR_PRECISION {

// --- bodies ---

void check_spin(const Vec3& spin, const Vec3& inertia) {
  if (!std::isfinite(length(spin)) || !std::isfinite(length(spin) * max_component(inertia))) {
    throw Error("spin", "makes an angular momentum that the precision cannot hold");
  }
}

namespace {

void check_mass(const BodyDef& def) {
  const double density = density_of(def);
  const MassProperties m = mass_properties(def);
  const auto fits = [](double x) { return std::isfinite(Real(x)) && Real(x) > 0 && std::isfinite(1 / Real(x)); };
  if (!fits(density * m.volume)) {
    throw Error(def.mass > 0 ? "mass" : "density",
                "makes a mass of " + text(density * m.volume) + " kg, which the precision cannot hold");
  }
  const Vec3d moments = principal_frame(m).moments * density;
  if (def.motion == Motion::dynamic && !(fits(moments.x) && fits(moments.y) && fits(moments.z))) {
    throw Error(def.inertia ? "inertia" : "shape", "makes an inertia that the precision cannot hold");
  }
  const double largest = max_component(moments);
  if (def.inertia && largest > 1.001 * (moments.x + moments.y + moments.z - largest)) {
    throw Error("inertia", "is of no body: a principal moment is greater than the sum of the others");
  }
  check_spin(def.spin, def.motion == Motion::dynamic ? convert<Real>(moments) : Vec3{});
}

}

void check_body(const BodyDef& def) {
  const bool massive = has_mass(def.shape.kind());
  if (!massive && def.motion != Motion::fixed) {
    throw Error("motion", "must be fixed: a half space or a hollow has no mass");
  }
  if (def.motion == Motion::fixed && (def.velocity != Vec3{} || def.spin != Vec3{})) {
    throw Error(def.velocity != Vec3{} ? "velocity" : "spin", "must be zero: the body is fixed");
  }
  if (massive) {
    check_mass(def);
  } else if (def.center || def.inertia) {
    throw Error(def.center ? "center" : "inertia", "is given, but a half space or a hollow has none");
  }
}

// --- joints ---

const char* kind_of(const JointDef& def) {
  constexpr const char* names[] = {"bar",   "rope",  "ball",   "hinge",  "slider",
                                   "fixed", "plane", "muscle", "pulley", "reel"};
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
  if (const auto* bar = std::get_if<Bar>(&def); bar != nullptr && bar->at_a == bar->at_b) {
    throw Error("bar.at_b", "is the same point as at_a: use a ball joint");
  }
}

}
