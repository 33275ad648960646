#include "view/scene.h"

#include <algorithm>

namespace sudar::view {

namespace {

// Its number in the scene.
std::uint32_t add_shape(Scene& scene, const Shape& shape) {
  // Bodies of one shape mostly follow each other: look from the end. The pointer first, since it is cheap.
  const auto same = std::find_if(scene.shapes.rbegin(), scene.shapes.rend(),
                                 [&](const Shape& s) { return s.shared() == shape.shared() || s == shape; });
  if (same != scene.shapes.rend()) return std::uint32_t(scene.shapes.rend() - same - 1);
  scene.shapes.push_back(shape);
  return std::uint32_t(scene.shapes.size() - 1);
}

Pose mix(const Pose& a, const Pose& b, double share) {
  // The shorter way round: q and −q are the same turn. Between two steps the straight way is as good as the arc.
  const Real t = Real(share);
  const Real sign = a.q.x * b.q.x + a.q.y * b.q.y + a.q.z * b.q.z + a.q.w * b.q.w < 0 ? Real(-1) : Real(1);
  const auto between = [&](Real from, Real to) { return from * (1 - t) + sign * to * t; };
  const Quat q{between(a.q.x, b.q.x), between(a.q.y, b.q.y), between(a.q.z, b.q.z), between(a.q.w, b.q.w)};
  return {a.p + (b.p - a.p) * t, normalize(q)};
}

// Finds the shapes of one list in another, if asked for them in their order: both lists are in that of the bodies' numbers.
class Twins {
 public:
  explicit Twins(const std::vector<Instance>& list) : at_(list.begin()), end_(list.end()) {}
  const Instance* of(const Instance& i) {
    while (at_ != end_ && at_->body.index < i.body.index) ++at_;
    const auto of_body = std::find_if(at_, end_, [&](const Instance& k) { return k.body != i.body || k.part == i.part; });
    return of_body != end_ && of_body->body == i.body ? &*of_body : nullptr;
  }

 private:
  std::vector<Instance>::const_iterator at_, end_;
};

void mix(const std::vector<Instance>& before, std::vector<Instance>& after, double share) {
  Twins twins(before);
  for (Instance& i : after) {
    if (const Instance* old = twins.of(i)) i.pose = mix(old->pose, i.pose, share);
  }
}

}

void add_instance(Scene& scene, const Shape& shape, Instance instance) {
  instance.shape = add_shape(scene, shape);
  scene.instances.push_back(instance);
}

void add_ghosts(Scene& scene, const Scene& other) {
  Twins own(scene.instances);
  for (Instance i : other.instances) {
    if (i.fixed) continue;
    if (const Instance* twin = own.of(i); twin != nullptr && twin->pose == i.pose) continue;
    i.shape = add_shape(scene, other.shapes[i.shape]);
    scene.ghosts.push_back(i);
  }
}

Scene mix(const Scene& before, const Scene& after, double share) {
  Scene scene = after;
  mix(before.instances, scene.instances, share);
  mix(before.ghosts, scene.ghosts, share);
  if (before.links.size() == after.links.size()) {
    const Real t = Real(share);
    for (std::size_t n = 0; n < scene.links.size(); ++n) {
      const Link &a = before.links[n], &b = after.links[n];
      scene.links[n] = {a.from + (b.from - a.from) * t, a.to + (b.to - a.to) * t, b.radius};
    }
  }
  return scene;
}

}
