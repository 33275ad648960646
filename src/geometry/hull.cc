// In three steps: the exact hull as triangles; groups of triangles that are flat together become faces; vertices that
// are left with two faces or fewer lie on an edge or within a face, are dropped, and it begins again without them. The
// groups are merged within a tolerance; should they not fit together as a polyhedron, a smaller tolerance is tried. The
// last one is 0, that is, exactly coplanar triangles, for which it holds by geometry.
#include "geometry/hull.h"

#include "geometry/predicates.h"
#include "geometry/primitives.h"
#include "geometry/triangulated_hull.h"

#include <algorithm>
#include <numeric>
#include <optional>

namespace sudar::inline SUDAR_PRECISION {

namespace {

constexpr std::uint32_t none = 0xffffffffu;
using Loops = std::vector<std::vector<std::uint32_t>>;

Error bad_points(const char* reason) { return Error("points", reason); }

// Too small to matter, and below what the exact tests can multiply.
Vec3d without_dust(const Vec3& p) {
  const auto clean = [](Real x) { return abs(double(x)) < 1e-60 ? 0 : double(x); };
  return {clean(p.x), clean(p.y), clean(p.z)};
}

// The number of the point for which `measure` is largest, and that measure.
template <class Measure>
std::pair<std::uint32_t, double> farthest(const std::vector<Vec3d>& points, Measure measure) {
  std::pair<std::uint32_t, double> best{0, -1};
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const double m = measure(points[i]);
    if (m > best.second) best = {i, m};
  }
  return best;
}

// Four points far apart, none in the plane of the others by `tolerance`.
std::array<std::uint32_t, 4> find_simplex(const std::vector<Vec3d>& points, double tolerance) {
  const auto from_first = farthest(points, [&](const Vec3d& p) { return length(p - points[0]); });
  const std::uint32_t a = from_first.first;
  const auto [b, ab] = farthest(points, [&](const Vec3d& p) { return length(p - points[a]); });
  if (!(ab > tolerance)) throw bad_points("all lie in one place");
  const Line3 line{points[a], points[b] - points[a]};
  const auto [c, height] = farthest(points, [&](const Vec3d& p) { return line.distance(p); });
  if (!(height > tolerance)) throw bad_points("all lie on one line");
  const Plane3 plane = Plane3::through(points[a], points[b], points[c]);
  const auto [d, depth] = farthest(points, [&](const Vec3d& p) { return abs(plane.distance(p)); });
  if (!(depth > tolerance) || orientation(points[a], points[b], points[c], points[d]) == 0) {
    throw bad_points("all lie in one plane");
  }
  return {a, b, c, d};
}

// For each triangle the number of its group: triangles that hang together and whose corners lie within `tolerance` of
// the plane of the group's largest.
std::vector<std::uint32_t> group(const std::vector<Vec3d>& points, const std::vector<HullTriangle>& triangles,
                                 double tolerance) {
  std::vector<Vec3d> area(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto& [a, b, c] = triangles[t].corners;
    area[t] = cross(points[b] - points[a], points[c] - points[a]);
  }
  std::vector<std::uint32_t> by_size(triangles.size()), group_of(triangles.size(), none), stack;
  std::iota(by_size.begin(), by_size.end(), 0u);
  std::stable_sort(by_size.begin(), by_size.end(),
                   [&](std::uint32_t s, std::uint32_t t) { return length_squared(area[s]) > length_squared(area[t]); });
  std::uint32_t groups = 0;
  for (const std::uint32_t seed : by_size) {
    if (group_of[seed] != none) continue;
    const auto& corners = triangles[seed].corners;
    const Vec3d &a = points[corners[0]], &b = points[corners[1]], &c = points[corners[2]];
    const Plane3 plane = Plane3::through(a, b, c);
    const auto flat = [&](std::uint32_t p) {
      return abs(plane.distance(points[p])) <= tolerance || orientation(a, b, c, points[p]) == 0;
    };
    group_of[seed] = groups;
    for (stack = {seed}; !stack.empty();) {
      const HullTriangle triangle = triangles[stack.back()];
      stack.pop_back();
      for (const std::uint32_t n : triangle.neighbors) {
        const auto& others = triangles[n].corners;
        if (group_of[n] != none || !std::all_of(others.begin(), others.end(), flat)) continue;
        group_of[n] = groups;
        stack.push_back(n);
      }
    }
    ++groups;
  }
  return group_of;
}

// The points at which three groups or more meet.
std::vector<std::uint32_t> true_corners(std::size_t points, const std::vector<HullTriangle>& triangles,
                                        const std::vector<std::uint32_t>& group_of) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> meetings;  // point, group
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (const std::uint32_t corner : triangles[t].corners) meetings.push_back({corner, group_of[t]});
  }
  std::sort(meetings.begin(), meetings.end());
  meetings.erase(std::unique(meetings.begin(), meetings.end()), meetings.end());
  std::vector<std::uint32_t> count(points, 0), corners;
  for (const auto& [point, group] : meetings) ++count[point];
  for (std::uint32_t p = 0; p < points; ++p) {
    if (count[p] >= 3) corners.push_back(p);
  }
  return corners;
}

// The outline of each group, from its lowest corner on; nothing if one is not a single loop.
std::optional<Loops> outlines(const std::vector<HullTriangle>& triangles, const std::vector<std::uint32_t>& group_of) {
  struct Step {
    std::uint32_t group, from, to;
    auto operator<=>(const Step&) const = default;
  };
  std::vector<Step> steps;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (group_of[triangles[t].neighbors[i]] == group_of[t]) continue;
      steps.push_back({group_of[t], triangles[t].corners[i], triangles[t].corners[(i + 1) % 3]});
    }
  }
  std::sort(steps.begin(), steps.end());
  Loops loops;
  for (auto first = steps.begin(); first != steps.end();) {
    const auto last = std::find_if(first, steps.end(), [&](const Step& s) { return s.group != first->group; });
    std::vector<std::uint32_t> loop;
    auto at = first;
    do {
      loop.push_back(at->from);
      const std::uint32_t next = at->to;
      at = std::partition_point(first, last, [&](const Step& s) { return s.from < next; });
    } while (at != first && loop.size() < std::size_t(last - first));
    if (at != first || loop.size() != std::size_t(last - first)) return {};
    loops.push_back(std::move(loop));
    first = last;
  }
  std::sort(loops.begin(), loops.end());
  return loops;
}

// The polyhedron of these points with faces flat within `merge`; nothing if it does not fit together.
std::optional<Polyhedron> polyhedron_of(std::vector<Vec3> points, double flatness, double merge) {
  for (;;) {
    std::vector<Vec3d> exact;
    for (const Vec3& p : points) exact.push_back(without_dust(p));
    const std::vector<HullTriangle> triangles = triangulated_hull(exact, find_simplex(exact, flatness));
    const std::vector<std::uint32_t> group_of = group(exact, triangles, merge);
    const std::vector<std::uint32_t> corners = true_corners(points.size(), triangles, group_of);
    if (corners.size() < 4) return {};
    if (corners.size() == points.size()) {
      const std::optional<Loops> loops = outlines(triangles, group_of);
      return loops ? std::optional(make_polyhedron(std::move(points), *loops)) : std::nullopt;
    }
    std::vector<Vec3> kept;
    for (const std::uint32_t corner : corners) kept.push_back(points[corner]);
    points = std::move(kept);
  }
}

}

Polyhedron convex_hull(std::span<const Vec3> points) {
  if (points.size() < 4) throw bad_points("must be four or more");
  for (const Vec3& p : points) {
    if (!is_finite(p) || max_component(abs(p)) > Real(1e30)) throw bad_points("must be finite and below 1e30 m");
  }
  const double flatness = flatness_tolerance(points);
  for (const double merge : {flatness, flatness / 8, flatness / 64, 0.0}) {
    try {
      if (std::optional<Polyhedron> p = polyhedron_of({points.begin(), points.end()}, flatness, merge))
        return *std::move(p);
    } catch (const Error& error) {
      if (error.field == "points" || merge == 0) throw;
    }
  }
  throw bad_points("are too close to a plane for a polyhedron");
}

}
