#include "dynamics/joints.h"

namespace sudar::inline SUDAR_PRECISION {

static_assert(sizeof(JointImpulse) == 16 * sizeof(Real) && sizeof(Limit) == 2 * sizeof(Real), "saved as bytes");

namespace {

// A joint is the list of its parts, with at most one free coordinate; nothing else in this file knows a joint's kind.
struct Nothing {};
template <class Coordinate, class... Parts>
struct Assembly {
  static void fill(const JointFrame& f, JointRows& out) {
    (
        [&] {
          Parts::fill(f, out.rows.data() + out.count);
          out.count += Parts::rows;
        }(),
        ...);
    if constexpr (!std::is_same_v<Coordinate, Nothing>) {
      out.free = true;
      out.period = Coordinate::period(f);
      out.rate = Coordinate::row(f);
      out.value = Coordinate::value(f);
    }
  }
};
template <class Definition>
struct PartsOf;
template <>
struct PartsOf<Bar> : Assembly<Nothing, Distance> {};
template <>
struct PartsOf<Rope> : Assembly<Span> {};
template <>
struct PartsOf<Ball> : Assembly<Nothing, Point> {};
template <>
struct PartsOf<Hinge>  // thesis (3.24) as exact rows, not two ball joints far apart
    : Assembly<Twist, Point, Align> {};
template <>
struct PartsOf<Slider> : Assembly<Travel, Slide, Lock> {};
template <>
struct PartsOf<Fixed> : Assembly<Nothing, Point, Lock> {};
template <>
struct PartsOf<Plane> : Assembly<Nothing, Offset> {};
template <>
struct PartsOf<Muscle> : Assembly<Span> {};
template <>
struct PartsOf<Pulley> : Assembly<Detour> {};
template <>
struct PartsOf<Reel> : Assembly<Winding> {};
template <>
struct PartsOf<Orientation> : Assembly<Nothing, Lock> {};
template <>
struct PartsOf<Azimuth> : Assembly<Bearing> {};
template <>
struct PartsOf<Tilt> : Assembly<Incline> {};
template <>
struct PartsOf<Stroke> : Assembly<Travel> {};

// The joint's frame in world axes at creation: x along its axis.
Quat basis_along(const Vec3& axis) {
  const Vec3 x = normalize(axis), y = any_perpendicular(x);
  return quaternion(Mat3{x, y, cross(x, y)});
}

// The same with y as near as can be to a direction.
Quat basis_toward(const Vec3& axis, const Vec3& direction) {
  const Vec3 x = normalize(axis), across = direction - x * dot(x, direction);
  const Vec3 y = length_squared(across) > 0 ? normalize(across) : any_perpendicular(x);
  return quaternion(Mat3{x, y, cross(x, y)});
}

Real distance(const Pos& p, const Pos& q) { return length(p - q); }

struct Placement {
  Pos at_a, at_b;
  Vec3 axis{1, 0, 0};
  Limit limit;
  bool taut = false;  // the coordinate may not exceed that at creation
  std::optional<Vec3> direction{};  // x of b's axes; none: the axis
};
Placement placement(const Bar& d) { return {d.at_a, d.at_b, {1, 0, 0}, {distance(d.at_a, d.at_b), 0}}; }
Placement placement(const Rope& d) {
  return {d.at_a, d.at_b, {1, 0, 0}, {-Limit{}.high, d.length > 0 ? d.length : distance(d.at_a, d.at_b)}};
}
Placement placement(const Ball& d) { return {d.at, d.at, {1, 0, 0}, {}}; }
Placement placement(const Fixed& d) { return {d.at, d.at, {1, 0, 0}, {}}; }
Placement placement(const Plane& d) { return {d.at, d.at, d.normal, {}}; }
Placement placement(const Muscle& d) { return {d.at_a, d.at_b, {1, 0, 0}, {}}; }
Placement placement(const Pulley& d) {
  return {d.at_a, d.at_b, {1, 0, 0}, {-Limit{}.high, d.length}, d.length == 0};
}
Placement placement(const Reel& d) { return {d.at_a, d.at, d.axis, {}, true}; }
Placement placement(const Orientation& d) { return {d.at, d.at, {1, 0, 0}, {}}; }
Placement placement(const Azimuth& d) { return {d.at, d.at, d.axis, d.limit, false, d.direction}; }
Placement placement(const Tilt& d) { return {d.at, d.at, d.axis, d.limit, false, d.direction}; }
Placement placement(const Stroke& d) { return {d.at, d.at, d.axis, d.limit}; }
Placement placement(const Hinge& d) { return {d.at, d.at, d.axis, d.limit}; }
Placement placement(const Slider& d) { return {d.at, d.at, d.axis, d.limit}; }

Pos anchor(const Joints& j, std::uint32_t i, std::uint32_t body, const Pose& at, const Vec3& local) {
  return body == no_body ? j.ground[i] : at.point(local);
}
Vec3 arm(std::uint32_t body, const Pose& at, const Vec3& anchor) {
  return body == no_body ? Vec3{} : rotate(at.q, anchor);
}
Quat turned(std::uint32_t body, const Pose& at, const Quat& basis) { return body == no_body ? basis : at.q * basis; }

Pose center_pose(const Bodies& bodies, std::uint32_t body) {
  return body == no_body ? Pose{} : Pose{bodies.position[body], bodies.orientation[body]};
}
JointEnds ends_of(const Joints& j, const Bodies& bodies, std::uint32_t i) {
  return {center_pose(bodies, j.a[i]), center_pose(bodies, j.b[i])};
}

JointFrame frame_of(const Joints& j, const JointEnds& ends, std::uint32_t i) {
  const std::uint32_t a = j.a[i], b = j.b[i];
  const Pos on_a = anchor(j, i, a, ends.a, j.anchor_a[i]), on_b = anchor(j, i, b, ends.b, j.anchor_b[i]);
  JointFrame f;
  f.ra = arm(a, ends.a, j.anchor_a[i]);
  f.rb = arm(b, ends.b, j.anchor_b[i]);
  f.gap = on_a - on_b;
  f.turn_a = turned(a, ends.a, j.basis_a[i]);
  f.turn_b = turned(b, ends.b, j.basis_b[i]);
  f.basis_a = matrix(f.turn_a);
  f.basis_b = matrix(f.turn_b);
  f.length = j.limit[i].low;  // of a bar
  if (const auto* pulley = std::get_if<Pulley>(&j.definition[i])) {
    f.reach_a = on_a - pulley->over_a;
    f.reach_b = on_b - pulley->over_b;
    f.ratio = pulley->ratio;
  }
  if (const auto* reel = std::get_if<Reel>(&j.definition[i])) f.radius = reel->radius;
  return f;
}
}

std::uint32_t Joints::add(const JointDef& def, const Bodies& bodies) {
  const std::uint32_t i = slots.take();
#define JOINT_FIELD(type, name, unit, stage) \
  if (i == name.size()) name.emplace_back(); else name[i] = type{};
#include "dynamics/fields.def"
  if (i == definition.size()) definition.emplace_back();
  definition[i] = def;
  a[i] = body_a(def).index;  // a null handle's index is no_body
  b[i] = body_b(def).index;
  const Placement p = std::visit([](const auto& d) { return placement(d); }, def);
  const auto attach = [&](std::uint32_t body, const Pos& at, const Quat& basis, Vec3& local, Quat& local_basis) {
    if (body == no_body) {
      ground[i] = at;
      local_basis = basis;
    } else {
      local = bodies.center_pose(body).local(at);
      local_basis = conjugate(bodies.orientation[body]) * basis;
    }
  };
  attach(a[i], p.at_a, p.direction ? basis_toward(p.axis, *p.direction) : basis_along(p.axis), anchor_a[i], basis_a[i]);
  attach(b[i], p.at_b, basis_along(p.direction.value_or(p.axis)), anchor_b[i], basis_b[i]);
  limit[i] = p.limit;
  coordinate[i] = rows_of(*this, bodies, i).value;
  if (p.taut) limit[i].high = coordinate[i];
  return i;
}

void Joints::turn_frame(std::uint32_t i, std::uint32_t body, const Transform& to_new) {
  const auto turn = [&](Vec3& anchor, Quat& basis) {
    anchor = to_new.point(anchor);
    basis = normalize(to_new.q * basis);
  };
  if (a[i] == body) turn(anchor_a[i], basis_a[i]);
  if (b[i] == body) turn(anchor_b[i], basis_b[i]);
}

Pos anchor_a(const Joints& j, const Bodies& bodies, std::uint32_t i) {
  return anchor(j, i, j.a[i], center_pose(bodies, j.a[i]), j.anchor_a[i]);
}
Pos anchor_b(const Joints& j, const Bodies& bodies, std::uint32_t i) {
  return anchor(j, i, j.b[i], center_pose(bodies, j.b[i]), j.anchor_b[i]);
}

Quat frame_a(const Joints& j, const Bodies& bodies, std::uint32_t i) {
  return turned(j.a[i], center_pose(bodies, j.a[i]), j.basis_a[i]);
}
Quat frame_b(const Joints& j, const Bodies& bodies, std::uint32_t i) {
  return turned(j.b[i], center_pose(bodies, j.b[i]), j.basis_b[i]);
}

JointRows rows_of(const Joints& j, const JointEnds& ends, std::uint32_t i) {
  const JointFrame f = frame_of(j, ends, i);
  JointRows rows;
  std::visit([&]<class Definition>(const Definition&) { PartsOf<Definition>::fill(f, rows); }, j.definition[i]);
  return rows;
}
JointRows rows_of(const Joints& j, const Bodies& bodies, std::uint32_t i) {
  return rows_of(j, ends_of(j, bodies, i), i);
}

Real gap_of(const Joints& j, const Bodies& bodies, std::uint32_t i) {
  const JointRows rows = rows_of(j, bodies, i);
  Real sum = 0;
  if (rows.free && rows.rate.linear_a != Vec3{}) {
    const Limit& limit = j.limit[i];
    const Real value = unwind(j.coordinate[i], rows.value, rows.period);
    sum = square(max(Real(0), max(limit.low - value, value - limit.high)));
  }
  for (int k = 0; k < rows.count; ++k) {
    const Row& row = rows.rows[std::size_t(k)];
    if (row.linear_a != Vec3{}) sum += square(row.error);
  }
  return sqrt(sum);
}

const Drive* drive_of(const JointDef& def) {
  return std::visit(
      [](const auto& d) -> const Drive* {
        if constexpr (requires { d.drive; })
          return &d.drive;
        else
          return nullptr;
      },
      def);
}
Drive* drive_of(JointDef& def) { return const_cast<Drive*>(drive_of(std::as_const(def))); }

Real unwind(Real previous, Real value, Real period) {
  return period > 0 ? value + period * std::round((previous - value) / period) : value;
}

void write(Writer& w, const Joints& j) {
  write(w, j.slots);
#define JOINT_FIELD(type, name, unit, stage) w.named(#name, j.name);
#include "dynamics/fields.def"
  w.each("definition", j.definition);
}

void read(Reader& r, Joints& j) {
  read(r, j.slots);
#define JOINT_FIELD(type, name, unit, stage) \
  r.array(j.name);                           \
  if (j.name.size() != j.size()) throw Error("data", "has arrays of different lengths");
#include "dynamics/fields.def"
  j.definition.resize(j.size());
  for (JointDef& def : j.definition) read(r, def);
}

}
