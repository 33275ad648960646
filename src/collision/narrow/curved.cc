#include "collision/narrow/curved.h"

#include "collision/narrow/overlay.h"
#include "collision/narrow/reduce.h"
#include "collision/narrow/separation.h"

namespace sudar::inline SUDAR_PRECISION {
namespace {

Vec3d clean_normal(const Convex& a, const Convex& b, const Separation& s, double scale) {
  const double least = s.distance - 1e-4 * abs(s.distance) - 2e-5 * scale;
  const Vec3d of_a = -face_across(a, -s.normal), of_b = face_across(b, s.normal);
  for (const Vec3d& n : {of_a, of_b}) {
    if (n != Vec3d{} && separation_along(a, b, n) >= least) return n;
  }
  return s.normal;
}

// 1: on a's surface, 0: on b's. What is flat takes the other's surface: a ball's friction acts on the ball where it is.
double share(const Patch& a, const Patch& b, bool a_is_hull) {
  if (a.flat() != b.flat()) return a.flat() ? 0 : 1;
  return a_is_hull && !a.flat() ? 0 : 0.5;
}

double lowest(const Manifold& m) {
  double low = double(m.points[0].separation);
  for (int i = 1; i < m.count; ++i) low = min(low, double(m.points[std::size_t(i)].separation));
  return low;
}

}

void collide_curved(const Placed& pa, const Placed& pb, Reach reach, Manifold& out) {
  const Convex a(*pa.geometry, pa.pose), b(*pb.geometry, pb.pose);
  const Separation s = separation(a, b, double(reach.margin));
  if (!(s.distance < double(reach.margin))) return;
  const double scale = min(a.radius(), b.radius());
  const Vec3d n = clean_normal(a, b, s, scale);
  out.normal = convert<Real>(n);
  const Patch of_a = touching_part(a, -n), of_b = touching_part(b, n);
  const Overlay how{n, 1e-4 * scale, share(of_a, of_b, a.geometry->kind == ShapeKind::hull), double(reach.margin)};
  SmallArray<ManifoldPoint, 64> points(most_points(of_a, of_b));
  overlay(of_a, of_b, how, points);
  if (points.size() > 0) {
    reduce(points.all(), out.normal, reach.turn, Real(scale), out);
    // Else the parts pass beside what is nearest or deepest.
    if (lowest(out) <= (s.distance > 0 ? s.distance : s.distance / 2) + how.thick) return;
  }
  const std::uint32_t end_of_a = of_a.feature_at(s.on_a, how.thick), end_of_b = of_b.feature_at(s.on_b, how.thick);
  out.points[0] = {convert<Real>(s.on_a * how.share + s.on_b * (1 - how.share)), Real(s.distance),
                   end_of_b != feature::lone ? end_of_b : end_of_a};
  out.count = 1;
}

void collide_curved_plane(const Placed& placed, const Placed& plane, Reach reach, Manifold& out) {
  const Convex a(*placed.geometry, placed.pose);
  const Vec3d n = rotate(normalize(convert<double>(plane.pose.q)), Vec3d{0, 1, 0});
  out.normal = convert<Real>(n);
  const Patch part = touching_part(a, -n);
  const auto add = [&](const Vec3d& p, std::uint32_t feature) {
    const double separation = dot(n, p - convert<double>(plane.pose.p));
    if (!(separation < double(reach.margin))) return;
    out.points[std::size_t(out.count++)] = {convert<Real>(p), Real(separation), feature};
  };
  if (part.kind == Patch::disc) {
    for (int k = 0; k < 4; ++k) add(part.rim(k), part.id[0] + std::uint32_t(k));
  } else {
    add(part.start, part.id[0]);
    if (part.kind == Patch::segment) add(part.end, part.id[1]);
  }
}

void collide_sphere_hollow(const Placed& sphere, const Placed& hollow, Real margin, Manifold& out) {
  const Geometry& g = *hollow.geometry;
  const Quatd turn = normalize(convert<double>(hollow.pose.q));
  const Vec3d center = rotate_back(turn, convert<double>(sphere.pose.p) - convert<double>(hollow.pose.p));
  const double radius = double(g.radius), half = double(g.half_length);
  const bool pipe = g.kind == ShapeKind::hollow_cylinder;
  const Vec3d out_from_middle = pipe ? Vec3d{center.x, 0, center.z} : center;
  const double off = length(out_from_middle);
  if (!(off > 0 && off < radius)) return;  // in the middle it touches everywhere or nowhere
  Vec3d wall = out_from_middle * (radius / off);
  if (pipe) wall.y = clamp(center.y, -half, half);
  const Vec3d inward = center - wall;
  const double distance = length(inward), separation = distance - double(sphere.geometry->radius);
  if (!(separation < double(margin))) return;
  const Vec3d n = rotate(turn, inward / distance);
  out.normal = convert<Real>(n);
  const Vec3d at = convert<double>(sphere.pose.p) - n * double(sphere.geometry->radius);
  out.points[0] = {convert<Real>(at), Real(separation), 0};
  out.count = 1;
}

}
