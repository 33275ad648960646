#include "view/bodies.h"

#include <algorithm>

#include "view/palette.h"

namespace sudar::view {

namespace {

Vec3f asleep(const Vec3f& c) {
  const float grey = 0.3f * c.x + 0.5f * c.y + 0.2f * c.z;
  return c * 0.35f + Vec3f{grey, grey, grey} * 0.4f;
}

}

std::size_t Bodies::mesh_of(const Shape& shape) {
  if (shape.kind() == ShapeKind::sphere) return sphere_;
  const auto known = std::find_if(known_.begin(), known_.end(), [&](const Known& k) {
    return k.shape.shared() == shape.shared() || k.shape == shape;
  });
  if (known != known_.end()) return known->mesh;
  const Mesh mesh = shape.kind() == ShapeKind::hull ? hull_mesh(shape) : smooth_mesh(shape);
  known_.push_back({shape, instances_.add_mesh(mesh)});
  return known_.back().mesh;
}

void Bodies::place(const Scene& scene, const Pos& eye, bool show_sleep) {
  constexpr std::size_t none = ~std::size_t(0);
  std::vector<std::size_t> mesh;
  for (const Shape& s : scene.shapes) mesh.push_back(s.kind() == ShapeKind::half_space ? none : mesh_of(s));
  std::vector<std::vector<GpuInstance>> copies(rod_ + 1 + known_.size());
  for (std::size_t n = 0; n < scene.instances.size(); ++n) {
    const Instance& i = scene.instances[n];
    if (mesh[i.shape] == none) continue;
    const Shape& shape = scene.shapes[i.shape];
    GpuInstance g{.position = relative(i.pose.p, eye),
                  .turn = {float(i.pose.q.x), float(i.pose.q.y), float(i.pose.q.z), float(i.pose.q.w)},
                  .colour = show_sleep && i.asleep ? asleep(i.colour) : i.colour,
                  .contrast = i.fixed                           ? 0.08f
                              : shape.kind() == ShapeKind::hull ? 0.17f
                                                                : 0.8f,
                  .gloss = i.fixed ? 0.3f : 0.8f,
                  .id = std::uint32_t(n + 1)};
    if (shape.kind() == ShapeKind::sphere) g.scale = Vec3f{1, 1, 1} * float(shape.radius());
    copies[mesh[i.shape]].push_back(g);
  }
  for (const Link& link : scene.links) {
    const Vec3f from = relative(link.from, eye), way = relative(link.to, link.from);
    const float reach = length(way);
    if (!(reach > 0)) continue;
    copies[rod_].push_back({.position = from,
                            .turn = turn_y_to(way / reach),
                            .scale = {link.radius, reach, link.radius},
                            .colour = link_colour(),
                            .gloss = 0.8f});
  }
  // Near ones first: what they hide is not shaded.
  for (auto& list : copies) {
    std::sort(list.begin(), list.end(), [](const GpuInstance& a, const GpuInstance& b) {
      return length_squared(a.position) < length_squared(b.position);
    });
  }
  instances_.place(copies);
}

}
