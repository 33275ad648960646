#include "bench/quality.h"

#include <sudar/distance.h>

#include <algorithm>
#include <numeric>

namespace sudar::bench {

namespace {

Vec3d between(const Pos& from, const Pos& to) { return {to.x - from.x, to.y - from.y, to.z - from.z}; }
Vec3d rotated(const Pose& pose, const Vec3d& local) { return rotate(normalize(convert<double>(pose.q)), local); }

Box bounds(const Solid& solid, const Pose& pose) {
  Vec3d low, high;
  if (solid.kind == Solid::Kind::ball) {
    high = {solid.radius, solid.radius, solid.radius}, low = -high;
  } else if (solid.kind == Solid::Kind::box) {
    for (int k = 0; k < 3; ++k) {
      Vec3d edge;
      edge[k] = solid.half[k];
      high += abs(rotated(pose, edge));
    }
    low = -high;
  } else {
    low = high = rotated(pose, solid.points[0]);
    for (const Vec3d& p : solid.points) low = min(low, rotated(pose, p)), high = max(high, rotated(pose, p));
  }
  return {pose.p + low, pose.p + high};
}

// Calls visit(a, b) for all pairs of bodies whose bounding boxes overlap and of which one at least is dynamic. A plane
// sweeps along x; those that rest are kept apart, or a million tiles would be compared with each other.
template <class F>
void each_near_pair(const Scene& scene, std::span<const Pose> poses, F visit) {
  struct Item {
    Box box;
    std::uint32_t body;
    bool dynamic;
  };
  std::vector<Item> items;
  for (std::uint32_t i = 0; i < poses.size(); ++i) {
    const SceneBody& b = scene.bodies[i];
    if (b.collides) items.push_back({bounds(scene.solids[b.solid], poses[i]), i, b.motion == Motion::dynamic});
  }
  std::sort(items.begin(), items.end(), [](const Item& a, const Item& b) { return a.box.low.x < b.box.low.x; });
  std::vector<const Item*> dynamic, other;  // that the plane has met
  const auto meet = [&](std::vector<const Item*>& met, const Item& item) {
    std::erase_if(met, [&](const Item* m) { return m->box.high.x < item.box.low.x; });
    for (const Item* m : met) {
      if (overlap(m->box, item.box)) visit(m->body, item.body);
    }
  };
  for (const Item& item : items) {
    meet(dynamic, item);
    if (item.dynamic) meet(other, item);
    (item.dynamic ? dynamic : other).push_back(&item);
  }
}

void measure_penetration(const Scene& scene, std::span<const Pose> poses, SceneQuality& q) {
  std::vector<Shape> shapes;
  for (const Solid& solid : scene.solids) shapes.push_back(shape(solid));
  std::vector<double> depths;
  each_near_pair(scene, poses, [&](std::uint32_t a, std::uint32_t b) {
    const double depth =
        -distance(shapes[scene.bodies[a].solid], poses[a], shapes[scene.bodies[b].solid], poses[b]).value;
    if (depth > 0) depths.push_back(depth);
  });
  if (depths.empty()) return;
  std::sort(depths.begin(), depths.end());
  q.overlaps = std::int64_t(depths.size());
  q.penetration_max = depths.back();
  q.penetration_mean = std::accumulate(depths.begin(), depths.end(), 0.0) / double(depths.size());
  q.penetration_p99 = depths[(depths.size() - 1) * 99 / 100];
}

void measure_gaps(const Scene& scene, std::span<const Pose> poses, SceneQuality& q) {
  for (const SceneBall& joint : scene.joints) {
    const auto anchor = [&](std::uint32_t body) {
      const SceneBody& b = scene.bodies[body];
      return poses[body].p + rotated(poses[body], rotate_back(b.turn, between(b.at, joint.at)));
    };
    const double gap = length(between(anchor(joint.a), anchor(joint.b)));
    q.joint_gap_max = max(q.joint_gap_max, gap);
    q.joint_gap_mean += gap / double(scene.joints.size());
  }
}

void measure_drift(const Scene& scene, std::span<const Pose> poses, SceneQuality& q) {
  double drift = 0, sink = 0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (scene.bodies[i].motion != Motion::dynamic) continue;
    const Vec3d way = between(scene.bodies[i].at, poses[i].p);
    drift = max(drift, length(Vec3d{way.x, 0, way.z})), sink = max(sink, abs(way.y));
  }
  q.drift = drift, q.sink = sink;
}

}

SceneQuality measure(const Scene& scene, std::span<const Pose> poses) {
  SceneQuality q;
  q.finite = std::all_of(poses.begin(), poses.end(), [](const Pose& p) { return is_finite(p.p) && is_finite(p.q); });
  if (!q.finite) return q;
  measure_penetration(scene, poses, q);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const SceneBody& b = scene.bodies[i];
    if (b.motion != Motion::dynamic || !b.collides) continue;
    q.below_ground += bounds(scene.solids[b.solid], poses[i]).high.y < 0;
  }
  measure_gaps(scene, poses, q);
  if (scene.stands) measure_drift(scene, poses, q);
  return q;
}

}
