#include "collision/narrow/closest.h"

namespace sudar::inline SUDAR_PRECISION {
namespace {

constexpr Real infinity = std::numeric_limits<Real>::infinity();

// The point of the face closest to `point`, which lies above the face.
Vec3 closest_on_face(const Polyhedron& hull, const Polyhedron::Face& face, const Vec3& point, Real height) {
  Vec3 best = point - face.normal * height;
  Real best_distance = infinity;
  bool over = true;
  for (std::uint32_t k = 0; k < face.count; ++k) {
    const Vec3& from = hull.vertices[hull.loops[face.first + k]];
    const Vec3& to = hull.vertices[hull.loops[face.first + (k + 1 == face.count ? 0 : k + 1)]];
    const Segment side{from, to - from};
    if (dot(point - from, cross(side.along, face.normal)) <= 0) continue;
    over = false;
    const Vec3 on_side = side.at(closest(side, point));
    const Real d = length_squared(point - on_side);
    if (d < best_distance) best_distance = d, best = on_side;
  }
  return over ? point - face.normal * height : best;
}

}

Real closest(const Segment& a, const Vec3& point) {
  const Real full = length_squared(a.along);
  return full > 0 ? clamp(dot(point - a.start, a.along) / full, Real(0), Real(1)) : Real(0);
}

// The parameters of the lines' closest points, clamped first on a, then on b, then on a again for the clamped one of b
// (C. Ericson, Real-Time Collision Detection, §5.1.9).
SegmentPoints closest(const Segment& a, const Segment& b) {
  const Vec3 r = a.start - b.start;
  const Real aa = length_squared(a.along), bb = length_squared(b.along), ab = dot(a.along, b.along);
  const Real ar = dot(a.along, r), br = dot(b.along, r), determinant = aa * bb - ab * ab;
  Real s = 0, t = 0;
  if (determinant > Real(1e-10) * aa * bb) s = clamp((ab * br - ar * bb) / determinant, Real(0), Real(1));
  if (bb > 0) t = clamp((ab * s + br) / bb, Real(0), Real(1));
  if (aa > 0) s = clamp((ab * t - ar) / aa, Real(0), Real(1));
  return {s, t, a.at(s), b.at(t)};
}

HullDistance distance(const Polyhedron& hull, const Vec3& point, Real reach) {
  // Outside, the closest point lies on a face that sees the point; inside, the nearest face is that of the largest
  // (least negative) height.
  HullDistance best{-infinity, {}};
  for (const Polyhedron::Face& f : hull.faces) {
    const Real height = dot(f.normal, point) - f.offset;
    if (height > reach) return {infinity, f.normal};
    if (height > best.distance) best = {height, f.normal};
  }
  if (best.distance <= 0) return best;

  const Real rounding = 8 * std::numeric_limits<Real>::epsilon() * max_component(abs(point));
  HullDistance outside{infinity, best.normal};
  for (const Polyhedron::Face& f : hull.faces) {
    const Real height = dot(f.normal, point) - f.offset;
    if (height <= 0) continue;
    const Vec3 away = point - closest_on_face(hull, f, point, height);
    const Real d = length(away);
    // So close that `away` is only rounding: the face's normal is better.
    if (d < outside.distance) outside = {d, d > rounding ? away / d : f.normal};
  }
  return outside.distance > reach ? HullDistance{infinity, outside.normal} : outside;
}

}
