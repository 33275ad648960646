#include "collision/narrow/moment.h"

#include "geometry/triangle_mesh.h"

namespace sudar::inline SUDAR_PRECISION {

namespace {

Vec3d between(const Pos& from, const Pos& to) { return {to.x - from.x, to.y - from.y, to.z - from.z}; }

// At most, m/s. What does not turn may be infinite.
double swept(double spin, const ShapeOnCourse& s) {
  return spin > 0 ? spin * double(length(s.frame.p - s.course.pivot) + swing_radius(*s.geometry)) : 0;
}

bool is_convex(ShapeKind k) { return has_mass(k); }

}

Course Course::between(double begin, const Pose& start, const Pose& end, const Vec3& expected, double time,
                       const Vec3& pivot) {
  const Pos from = start.point(pivot);
  const Vec3d way = sudar::between(from, end.point(pivot));
  Course c{begin, from, normalize(convert<double>(start.q)), way / time, {}, pivot};
  const Vec3d turn = rotation_vector(normalize(convert<double>(end.q)) * conjugate(c.turned));
  const Vec3d about = convert<double>(expected) * time;
  constexpr double certain = 2;  // rad: less than half a turn is no whole one
  if (length_squared(about) < square(certain)) {
    c.spin = turn / time;
    return c;
  }
  const double angle = length(turn);
  const Vec3d axis = angle > 1e-6 ? turn / angle : normalize(about);
  const double more = (dot(about, axis) - angle) / (2 * pi);
  const auto turns = double(std::int64_t(more < 0 ? more - 0.5 : more + 0.5));
  c.spin = axis * ((angle + 2 * pi * turns) / time);
  return c;
}

Encounter::Encounter(const ShapeOnCourse& a, const ShapeOnCourse& b, std::uint32_t triangle)
    : a_(a), b_(b), exchanged_(!is_convex(a.geometry->kind)), triangle_(triangle) {
  if (exchanged_) std::swap(a_, b_);
  of_b_ = b_.geometry;
  const ShapeKind kind = of_b_->kind;
  kind_ = kind == ShapeKind::half_space ? Other::half_space : is_hollow(kind) ? Other::hollow : Other::convex;
  if (kind != ShapeKind::mesh) return;
  mesh_ = of_b_->mesh.get();
  of_b_ = mesh_->triangles[triangle].piece.get();
}

// About the place where a's way begins: near it, doubles hold more than enough digits.
Convex Encounter::convex(const ShapeOnCourse& s, const Geometry& g, double t) const {
  const Course& c = s.course;
  const Mat3d turn = matrix(c.orientation(t));
  const Vec3d pivot = sudar::between(a_.course.from, c.from) + c.velocity * (t - c.begin);
  return {g, turn * matrix(normalize(convert<double>(s.frame.q))), pivot + turn * convert<double>(s.frame.p - c.pivot)};
}

Vec3d Encounter::middle(const ShapeOnCourse& s, double t) const {
  const Geometry& g = &s == &b_ ? *of_b_ : *s.geometry;
  return convex(s, g, t).point(g.mass.center);
}

bool Encounter::may_meet(double begin, double end, double distance) const {
  if (kind_ != Other::convex) return true;
  const auto radius = [](const ShapeOnCourse& s, const Geometry& g) {
    const Vec3d& center = g.mass.center;
    return double(g.bounding_radius) + length(center) +
           2 * (double(length(s.frame.p - s.course.pivot)) + length(center));
  };
  // The ball about a centre that goes its own way: twice the arm, since it turns about the body's.
  const Vec3d from = middle(a_, begin) - middle(b_, begin),
              way = (a_.course.velocity - b_.course.velocity) * (end - begin);
  const double reach = radius(a_, *a_.geometry) + radius(b_, *of_b_) + distance;
  const double full = length_squared(way), t = full > 0 ? clamp(-dot(from, way) / full, 0.0, 1.0) : 0;
  return length_squared(from + way * t) <= square(reach);
}

Separation Encounter::apart(double t, double reach) const {
  const Convex a = convex(a_, *a_.geometry, t), b = convex(b_, *of_b_, t);
  switch (kind_) {
    case Other::half_space: {
      const Vec3d n = b.turn.c1, lowest = a.support(-n) - n * a.round;
      const double value = dot(n, lowest - b.at);
      return {value, n, lowest, lowest - n * value};
    }
    case Other::hollow: {  // for balls only
      const Vec3d from = a.at - b.at, axis = b.turn.c1;
      const bool pipe = of_b_->kind == ShapeKind::hollow_cylinder;
      const double r = double(of_b_->radius), half = double(of_b_->half_length);
      const Vec3d along = pipe ? axis * dot(from, axis) : Vec3d{}, out = from - along;
      const double off = length(out), height = length(along);
      if (!(off < r)) return {std::numeric_limits<double>::infinity(), axis, {}, {}};  // behind the wall there is none
      const Vec3d rim = (off > 0 ? out * (r / off) : any_perpendicular(axis) * r);
      const Vec3d wall = b.at + rim + along * (height > half ? half / height : 1);
      const double distance = length(a.at - wall);
      const Vec3d n = (a.at - wall) / distance;
      return {distance - a.round, n, a.at - n * a.round, wall};
    }
    default:
      return separation(a, b, reach);
  }
}

double Encounter::along(double t, const Vec3d& normal) const {
  if (kind_ != Other::convex) return apart(t, 0).distance;
  return separation_along(convex(a_, *a_.geometry, t), convex(b_, *of_b_, t), normal);
}

// An axis of a hollow says nothing about what is beside it.
double Encounter::closing(const Vec3d& n) const {
  if (kind_ == Other::hollow) return fastest();
  const auto turning = [&](const ShapeOnCourse& s) { return swept(length(cross(s.course.spin, n)), s); };
  return dot(n, b_.course.velocity - a_.course.velocity) + turning(a_) + turning(b_);
}

double Encounter::fastest() const {
  const auto turning = [&](const ShapeOnCourse& s) { return swept(length(s.course.spin), s); };
  return length(b_.course.velocity - a_.course.velocity) + turning(a_) + turning(b_);
}

std::optional<double> Encounter::first(double begin, double end, double least, double rounding) const {
  return first_or_left(begin, end, least, rounding, std::numeric_limits<double>::infinity());
}

std::optional<double> Encounter::first_or_left(double begin, double end, double least, double rounding,
                                               double leave) const {
  constexpr int most = 400;  // axes and steps; then they are near enough for a meeting
  const double enough = least + rounding;
  double t = begin;
  for (int step = 0; step < most;) {
    const Separation now = apart(t, enough + fastest() * (end - t));
    if (now.distance <= enough || now.distance > leave) return t;
    const double rate = closing(now.normal);
    if (!(rate > 0)) return {};
    for (double d = now.distance; d > enough && d <= leave && step < most; ++step) {
      t += (d - least) / rate;
      if (!(t < end)) return {};
      d = along(t, now.normal);
    }
  }
  return t;
}

Vec3d Encounter::in_mesh(double t) const {
  const Convex mesh = convex(b_, *b_.geometry, t);
  const Vec3d d = middle(a_, t) - mesh.at;
  return {dot(mesh.turn.c0, d), dot(mesh.turn.c1, d), dot(mesh.turn.c2, d)};
}

bool Encounter::concerns(double begin, double moment, double end) const {
  if (mesh_ == nullptr) return true;
  const TriangleMesh::Triangle& face = mesh_->triangles[triangle_];
  const Vec3d n = convert<double>(face.normal), corner = convert<double>(face.corners[0]), before = in_mesh(begin);
  const double high = dot(n, before - corner);
  if (high < 0) return false;
  const Convex mesh = convex(b_, *b_.geometry, moment);
  const Vec3d normal = apart(moment, std::numeric_limits<double>::infinity()).normal;
  const Vec3 leans =
      convert<Real>(Vec3d{dot(mesh.turn.c0, normal), dot(mesh.turn.c1, normal), dot(mesh.turn.c2, normal)});
  if (length(leans - face.normal) < Real(1e-3) || face.allows(leans)) return true;
  const Vec3d after = in_mesh(end);
  const double low = dot(n, after - corner);
  return low < 0 &&
         face.above(convert<Real>(before + (after - before) * (high / (high - low))), Real(1e-4) * face.size());
}

Encounter::Place Encounter::place(double t) const {
  const Separation s = apart(t, std::numeric_limits<double>::infinity());
  return {a_.course.from + (s.on_a + s.on_b) * 0.5, convert<Real>(exchanged_ ? -s.normal : s.normal)};
}

}
