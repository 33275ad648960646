#include "history/quantity.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sudar::history {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

constexpr QuantityKind of_all[] = {{"total energy", "J"},
                                   {"kinetic energy", "J"},
                                   {"potential energy", "J"},
                                   {"momentum", "kg m/s"},
                                   {"momentum x", "kg m/s"},
                                   {"momentum y", "kg m/s"},
                                   {"momentum z", "kg m/s"},
                                   {"angular momentum", "kg m²/s"},
                                   {"angular momentum x", "kg m²/s"},
                                   {"angular momentum y", "kg m²/s"},
                                   {"angular momentum z", "kg m²/s"},
                                   {"contacts", ""},
                                   {"deepest overlap", "m"},
                                   {"largest joint gap", "m"}};
constexpr QuantityKind of_body[] = {{"x", "m"},
                                    {"y", "m"},
                                    {"z", "m"},
                                    {"vx", "m/s"},
                                    {"vy", "m/s"},
                                    {"vz", "m/s"},
                                    {"speed", "m/s"},
                                    {"ωx", "rad/s"},
                                    {"ωy", "rad/s"},
                                    {"ωz", "rad/s"},
                                    {"spin", "rad/s"},
                                    {"kinetic energy", "J"},
                                    {"angular momentum", "kg m²/s"}};
constexpr QuantityKind of_joint[] = {{"coordinate", ""},  // rad or m
                                     {"gap", "m"},
                                     {"force", "N"},
                                     {"torque", "N m"}};
constexpr QuantityKind of_contact[] = {
    {"normal force", "N"}, {"friction", "N"}, {"share of the cone", ""}, {"overlap", "m"}, {"slips", ""}};
constexpr QuantityKind of_sensor[] = {{"value", ""}};

double of(const Vec3d& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }
double of(const Vec3& v, int axis) { return double(axis == 0 ? v.x : axis == 1 ? v.y : v.z); }
double norm(const Vec3d& v) { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }

double whole(const World& w, int which) {
  switch (which) {
    case 0:
      return w.energy().total();
    case 1:
      return w.energy().kinetic;
    case 2:
      return w.energy().potential;
    case 3:
      return norm(w.momentum().linear);
    case 7:
      return norm(w.momentum().angular);
    case 11:
      return double(w.contacts().size());
    case 12:
      return double(w.quality().penetration_max);
    case 13:
      return double(w.quality().joint_gap_max);
    default:
      return which < 7 ? of(w.momentum().linear, which - 4) : of(w.momentum().angular, which - 8);
  }
}

double body(const BodyView& b, int which) {
  if (which < 3) return which == 0 ? b.center().x : which == 1 ? b.center().y : b.center().z;
  if (which < 6) return of(b.velocity(), which - 3);
  if (which == 6) return double(length(b.velocity()));
  if (which < 10) return of(b.spin(), which - 7);
  if (which == 10) return double(length(b.spin()));
  return which == 11 ? b.kinetic_energy() : double(length(b.angular_momentum()));
}

double joint(const JointView& j, int which) {
  switch (which) {
    case 0:
      return double(j.coordinate());
    case 1:
      return double(j.gap());
    case 2:
      return double(length(j.load().force));
    default:
      return double(length(j.load().torque));
  }
}

// Forces are the last sub-step's impulses over its length.
double contact(const World& w, const Quantity& q) {
  const std::vector<Contact> all = w.contacts();
  const auto c = std::find_if(all.begin(), all.end(), [&](const Contact& i) {
    return (i.a == q.a && i.b == q.b) || (i.a == q.b && i.b == q.a);
  });
  if (c == all.end()) return q.which == 0 || q.which == 1 ? 0 : nothing;
  const double h = w.config().dt * double(w.config().time_factor) / w.config().substeps;
  double sum = 0, most = 0, deepest = 0;
  Vec3 friction{};
  for (int i = 0; i < c->count; ++i) {
    const Contact::Point& p = c->points[std::size_t(i)];
    sum += double(p.normal_impulse), friction += p.friction;
    most = std::max(most, double(p.cone_share)), deepest = std::max(deepest, -double(p.separation));
  }
  switch (q.which) {
    case 0:
      return sum / h;
    case 1:
      return double(length(friction)) / h;
    case 2:
      return most;
    case 3:
      return deepest;
    default:
      return c->slipping ? 1 : 0;
  }
}

bool alive(const World& w, SensorId s) {
  const std::vector<SensorId> all = w.sensors();
  return std::find(all.begin(), all.end(), s) != all.end();
}

std::string called(const World& w, Body b) {
  if (b.null()) return "world";
  if (w.alive(b) && !w[b].name().empty()) return w[b].name();
  return "body " + std::to_string(b.index);
}

template <class H>
H same(const H& handle, const std::vector<H>& all) {
  const auto i = std::find_if(all.begin(), all.end(),
                              [&](const H& h) { return h.index == handle.index && h.generation == handle.generation; });
  return i == all.end() ? H{} : *i;
}

}

std::span<const QuantityKind> quantities(Quantity::Of of) {
  switch (of) {
    case Quantity::Of::world:
      return of_all;
    case Quantity::Of::body:
      return of_body;
    case Quantity::Of::joint:
      return of_joint;
    case Quantity::Of::contact:
      return of_contact;
    case Quantity::Of::sensor:
      return of_sensor;
  }
  return {};
}

double value(const World& w, const Quantity& q) {
  switch (q.of) {
    case Quantity::Of::world:
      return whole(w, q.which);
    case Quantity::Of::body:
      return w.alive(q.a) ? body(w[q.a], q.which) : nothing;
    case Quantity::Of::joint:
      return w.alive(q.joint) ? joint(w[q.joint], q.which) : nothing;
    case Quantity::Of::contact:
      return w.alive(q.a) && w.alive(q.b) ? contact(w, q) : nothing;
    case Quantity::Of::sensor:
      return alive(w, q.sensor) ? w.value(q.sensor) : nothing;
  }
  return nothing;
}

std::string name(const World& w, const Quantity& q) {
  const std::string what = quantities(q.of)[std::size_t(q.which)].name;
  switch (q.of) {
    case Quantity::Of::world:
      return what;
    case Quantity::Of::body:
      return called(w, q.a) + "." + what;
    case Quantity::Of::joint:
      return "joint " + std::to_string(q.joint.index) + "." + what;
    case Quantity::Of::contact:
      return called(w, q.a) + "/" + called(w, q.b) + "." + what;
    case Quantity::Of::sensor:
      return alive(w, q.sensor) && !w[q.sensor].name.empty() ? w[q.sensor].name
                                                             : "sensor " + std::to_string(q.sensor.index);
  }
  return what;
}

std::string unit(const World& w, const Quantity& q) {
  if (q.of == Quantity::Of::joint && q.which == 0 && w.alive(q.joint)) {
    const JointDef& def = w[q.joint].definition();
    const bool angle =
        std::holds_alternative<Hinge>(def) || std::holds_alternative<Azimuth>(def) || std::holds_alternative<Tilt>(def);
    return angle ? "rad" : "m";
  }
  return quantities(q.of)[std::size_t(q.which)].unit;
}

Quantity rebound(const Quantity& q, const World& w) {
  Quantity r = q;
  if (q.of == Quantity::Of::body || q.of == Quantity::Of::contact)
    r.a = same(q.a, w.bodies()), r.b = same(q.b, w.bodies());
  if (q.of == Quantity::Of::joint) r.joint = same(q.joint, w.joints());
  if (q.of == Quantity::Of::sensor) r.sensor = same(q.sensor, w.sensors());
  return r;
}

Quantity of_world(std::string_view name) {
  for (std::size_t i = 0; i < std::size(of_all); ++i) {
    if (name == of_all[i].name) return {.which = int(i)};
  }
  throw Error("quantity", "there is none called " + std::string(name));
}

}
