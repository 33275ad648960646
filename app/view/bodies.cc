#include "view/bodies.h"

#include <algorithm>
#include <cmath>

#include "view/palette.h"

namespace sudar::view {

namespace {

Vec3f asleep(const Vec3f& c) {
  const float grey = 0.3f * c.x + 0.5f * c.y + 0.2f * c.z;
  return c * 0.35f + Vec3f{grey, grey, grey} * 0.4f;
}

Vec3f colour_of(const Instance& i, const Style& style, float top) {
  switch (style.colouring) {
    case Colouring::body:
      break;
    case Colouring::speed:
      if (!i.fixed) return scale_colour(top > 0 ? i.speed / top : 0);
      break;
    case Colouring::island:
      if (!i.fixed) return i.alone ? fixed_colour() * 0.6f : category_colour(i.island);
      break;
    case Colouring::sleep:
      if (!i.fixed) return linear_colour(i.asleep ? 0x4a6fa5 : 0xe8913a);
      break;
  }
  return style.sleep && i.asleep ? asleep(i.colour) : i.colour;
}

}

float top_speed(const Scene& scene) {
  float top = 0;
  for (const Instance& i : scene.instances) top = max(top, i.speed);
  return top > 0 ? std::exp2(std::ceil(std::log2(top))) : 0;
}

std::size_t Bodies::mesh_of(const Shape& shape) {
  if (shape.kind() == ShapeKind::sphere) return spheres_.back();
  const auto known = std::find_if(known_.begin(), known_.end(), [&](const Known& k) {
    return k.shape.shared() == shape.shared() || k.shape == shape;
  });
  if (known != known_.end()) return known->mesh;
  const bool hull = shape.kind() == ShapeKind::hull || shape.kind() == ShapeKind::mesh;
  known_.push_back({shape, hull ? instances_.add_mesh(hull_mesh(shape), plain_hull_mesh(shape))
                                : instances_.add_mesh(smooth_mesh(shape, 6), smooth_mesh(shape, 3))});
  return known_.back().mesh;
}

// How fine it has to be depends on how large it is seen: in a picture of 720 rows 0.01 is 10 pixels.
std::size_t Bodies::mesh_for(const Shape& shape, std::size_t finest, float distance, bool plain) const {
  const float apparent = (plain ? 0.4f : 1.0f) * float(shape.bounding_radius()) / distance;
  if (shape.kind() != ShapeKind::sphere) return apparent < 0.014f ? instances_.plainer(finest) : finest;
  return spheres_[apparent < 0.008f ? 0 : apparent < 0.03f ? 1 : apparent < 0.08f ? 2 : 3];
}

void Bodies::place(const Scene& scene, const Pos& eye, const Style& style) {
  const float top = style.colouring == Colouring::speed ? top_speed(scene) : 0;
  constexpr std::size_t none = ~std::size_t(0);
  std::vector<std::size_t> mesh;
  for (const Shape& s : scene.shapes) mesh.push_back(s.kind() == ShapeKind::half_space ? none : mesh_of(s));
  Instances::Copies copies(instances_.meshes()), ghosts(instances_.meshes());
  const auto add = [&](const Instance& i, std::uint32_t id, Instances::Copies& to) {
    if (mesh[i.shape] == none) return;
    const Shape& shape = scene.shapes[i.shape];
    GpuInstance g{.position = relative(i.pose.p, eye),
                  .turn = {float(i.pose.q.x), float(i.pose.q.y), float(i.pose.q.z), float(i.pose.q.w)},
                  .colour = colour_of(i, style, top),
                  .contrast = i.fixed                           ? 0.08f
                              : shape.kind() == ShapeKind::hull ? 0.17f
                                                                : 0.8f,
                  .gloss = i.fixed ? 0.3f : 0.8f,
                  .id = id};
    if (shape.kind() == ShapeKind::sphere) g.scale = Vec3f{1, 1, 1} * float(shape.radius());
    to[mesh_for(shape, mesh[i.shape], length(g.position), style.plain)].push_back(g);
  };
  for (std::size_t n = 0; n < scene.instances.size(); ++n) add(scene.instances[n], std::uint32_t(n + 1), copies);
  for (const Instance& i : scene.ghosts) add(i, 0, ghosts);
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
  instances_.place(copies, ghosts);
}

}
