#include "collision/narrow/collide.h"
#include "geometry/triangle_mesh.h"

namespace sudar::inline SUDAR_PRECISION {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Where a ray enters a ball. The nearest point of the line is found first, so that a far origin costs no digits.
bool ball(const Vec3& center, Real radius, const Vec3& from, const Vec3& direction, Real& distance) {
  const Real nearest = dot(center - from, direction);
  const Real half_chord = square(radius) - length_squared(from + direction * nearest - center);
  if (half_chord < 0) return false;
  distance = nearest - sqrt(half_chord);
  return distance >= 0;
}

bool capsule(const Geometry& g, const Vec3& from, const Vec3& direction, RayOnGeometry& out) {
  bool hit = false;
  const auto take = [&](Real distance, const Vec3& on_axis) {
    if (hit && distance >= out.distance) return;
    hit = true;
    out = {distance, normalize(from + direction * distance - on_axis)};
  };
  for (const Real end : {-g.half_length, g.half_length}) {
    Real distance;
    if (ball({0, end, 0}, g.radius, from, direction, distance)) take(distance, {0, end, 0});
  }
  // The cylinder: the same as a ball in the plane across it.
  const Vec3 flat{direction.x, 0, direction.z};
  const Real across = length(flat);
  Real distance;
  if (across > 0 && ball({}, g.radius, {from.x, 0, from.z}, flat / across, distance)) {
    const Real y = from.y + direction.y * (distance / across);
    if (abs(y) <= g.half_length) take(distance / across, {0, y, 0});
  }
  return hit;
}

bool inside_capsule(const Geometry& g, const Vec3& p) {
  const Vec3 on_axis{0, clamp(p.y, -g.half_length, g.half_length), 0};
  return length_squared(p - on_axis) < square(g.radius);
}

// Cut by one face plane after the other.
bool polyhedron(const Polyhedron& hull, const Vec3& from, const Vec3& direction, Real length, RayOnGeometry& out) {
  Real enter = -1, leave = length;
  for (const Polyhedron::Face& f : hull.faces) {
    const Real above = dot(f.normal, from) - f.offset, speed = dot(f.normal, direction);
    if (speed >= 0 && above > 0) return false;
    if (speed < 0 && above >= 0 && -above / speed > enter) enter = -above / speed, out = {enter, f.normal};
    if (speed > 0) leave = min(leave, -above / speed);
    if (enter > leave) return false;
  }
  return enter >= 0;
}

// The stretch of a ray inside a convex body that is the intersection of simpler ones; in double, since a root next to a
// far origin has lost half of its digits.
struct Stretch {
  Vec3d from, direction;
  double enter, leave;
  Vec3d normal;  // where the ray enters
  bool empty = false;

  Vec3d at(double t) const { return from + direction * t; }
  template <class Normal>
  void keep(double low, double high, Normal normal_at) {
    if (low > enter) enter = low, normal = normal_at(at(low));
    leave = min(leave, high);
    if (!(enter <= leave)) empty = true;
  }
  // low ≤ y ≤ high
  void slab(double low, double high) {
    if (direction.y == 0) {
      if (from.y < low || from.y > high) empty = true;
      return;
    }
    const bool down = direction.y < 0;
    const double first = ((down ? high : low) - from.y) / direction.y,
                 last = ((down ? low : high) - from.y) / direction.y;
    keep(first, last, [&](const Vec3d&) { return Vec3d{0, down ? 1.0 : -1.0, 0}; });
  }
  // a t² + 2 b t + c ≤ 0, on the side of a double cone to which the ray comes last if `downwards`, else first.
  template <class Normal>
  void quadric(double a, double b, double c, bool downwards, Normal normal_at) {
    const double discriminant = b * b - a * c;
    if (a > 0 ? discriminant < 0 : a == 0 && b == 0) {
      if (a > 0 || c > 0) empty = true;
      return;
    }
    if (discriminant < 0) return;                                                // a < 0: inside all along
    const double q = -(b + (b < 0 ? -sqrt(discriminant) : sqrt(discriminant)));  // the root that does not cancel
    const double one = q != 0 ? c / q : 0, two = a != 0 ? q / a : (b > 0 ? -infinity : infinity);
    const double low = min(one, two), high = max(one, two);
    if (a >= 0)
      keep(low, high, normal_at);
    else if (downwards)
      keep(high, infinity, normal_at);
    else
      keep(-infinity, low, normal_at);
  }
};

bool curved(const Geometry& g, const Vec3& from, const Vec3& direction, Real length, RayOnGeometry& out) {
  // From the point of the ray nearest to the origin: digits again.
  const double back =
      dot(convert<double>(from), convert<double>(direction)) / length_squared(convert<double>(direction));
  Stretch s{
      convert<double>(from) - convert<double>(direction) * back, convert<double>(direction), -infinity, infinity, {}};
  const double r = double(g.radius), half = double(g.half_length);
  const Vec3d &p = s.from, &d = s.direction;
  if (g.kind == ShapeKind::cylinder) {
    s.slab(-half, half);
    s.quadric(d.x * d.x + d.z * d.z, p.x * d.x + p.z * d.z, p.x * p.x + p.z * p.z - r * r, true, [](const Vec3d& x) {
      return Vec3d{x.x, 0, x.z};
    });
  } else if (g.kind == ShapeKind::cone) {
    const double apex = 1.5 * half, kk = square(r / (2 * half)), up = p.y - apex;
    s.slab(-0.5 * half, apex);
    s.quadric(d.x * d.x + d.z * d.z - kk * d.y * d.y, p.x * d.x + p.z * d.z - kk * up * d.y,
              p.x * p.x + p.z * p.z - kk * up * up, d.y < 0, [&](const Vec3d& x) {
                return Vec3d{x.x, kk * (apex - x.y), x.z};
              });
  } else {
    const Vec3d w{1 / double(g.radii.x), 1 / double(g.radii.y), 1 / double(g.radii.z)};
    const Vec3d q = scale(p, w), e = scale(d, w);
    s.quadric(dot(e, e), dot(q, e), dot(q, q) - 1, true, [&](const Vec3d& x) { return scale(x, scale(w, w)); });
  }
  const double distance = s.enter - back;
  if (s.empty || !(distance >= 0 && distance <= double(length))) return false;
  out = {Real(distance), convert<Real>(normalize(s.normal))};
  return true;
}

// The wall of a hollow as seen from inside; from outside there is none.
bool hollow(const Geometry& g, const Vec3& from, const Vec3& direction, RayOnGeometry& out) {
  const bool ball_shaped = g.kind == ShapeKind::hollow_sphere;
  const Vec3 flat = ball_shaped ? from : Vec3{from.x, 0, from.z};
  const Vec3 along = ball_shaped ? direction : Vec3{direction.x, 0, direction.z};
  const Real speed = length(along);
  if (!(length_squared(flat) < square(g.radius) && speed > 0)) return false;
  const Real nearest = -dot(flat, along) / square(speed);
  const Real half_chord = square(g.radius) - length_squared(flat + along * nearest);
  const Real distance = nearest + sqrt(max(half_chord, Real(0))) / speed;
  const Vec3 at = flat + along * distance;
  out = {distance, normalize(-at)};
  return ball_shaped || abs(from.y + direction.y * distance) <= g.half_length;
}

}

bool ray_cast(const Geometry& g, const Vec3& from, const Vec3& direction, Real length, RayOnGeometry& out) {
  switch (g.kind) {
    case ShapeKind::sphere:
      if (!ball({}, g.radius, from, direction, out.distance)) return false;
      out.normal = normalize(from + direction * out.distance);
      return out.distance <= length;
    case ShapeKind::capsule:
      return !inside_capsule(g, from) && capsule(g, from, direction, out) && out.distance <= length;
    case ShapeKind::half_space:
      if (from.y < 0 || direction.y >= 0) return false;
      out = {-from.y / direction.y, {0, 1, 0}};
      return out.distance <= length;
    case ShapeKind::hull:
      return polyhedron(g.hull, from, direction, length, out);
    case ShapeKind::cylinder:
    case ShapeKind::cone:
    case ShapeKind::ellipsoid:
      return curved(g, from, direction, length, out);
    case ShapeKind::hollow_sphere:
    case ShapeKind::hollow_cylinder:
      return hollow(g, from, direction, out) && out.distance <= length;
    case ShapeKind::mesh: {
      std::uint32_t triangle = 0;
      if (!g.mesh->ray_cast(from, direction, length, triangle, out.distance)) return false;
      out.normal = g.mesh->triangles[triangle].normal;
      return true;
    }
  }
  return false;
}


// A convex body is entered before the point and left after it, by a line in any direction.
bool contains(const Geometry& g, const Vec3& point) {
  if (g.kind == ShapeKind::half_space) return point.y <= 0;
  if (is_hollow(g.kind) || g.kind == ShapeKind::mesh || !(length(point) <= g.bounding_radius)) return false;
  const Vec3 along{0, 1, 0};
  const Real far = 3 * g.bounding_radius;
  RayOnGeometry in, out;
  return ray_cast(g, point - along * far, along, far, in) && ray_cast(g, point + along * far, -along, far, out);
}

}
