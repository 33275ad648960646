// World → Scene.
#include "view/palette.h"
#include "view/scene.h"

namespace sudar::view {

namespace {

void add_bodies(Scene& scene, const World& world, std::uint32_t palette) {
  // Gradients are numbered by the shapes that move: grey things use none up.
  std::vector<std::uint32_t> gradient;
  std::uint32_t next = palette;
  for (const Body b : world.bodies()) {
    const BodyView view = world[b];
    const bool fixed = view.motion() == Motion::fixed;
    add_instance(scene, view.shape(), {.pose = view.pose(), .body = b, .fixed = fixed, .asleep = view.asleep()});
    Instance& instance = scene.instances.back();
    constexpr std::uint32_t none = ~0u;
    gradient.resize(scene.shapes.size(), none);
    std::uint32_t& own = gradient[instance.shape];
    if (!fixed && own == none) own = next++;
    instance.colour = fixed ? fixed_colour() : body_colour(own, b.index);
  }
}

void add_contacts(Scene& scene, const World& world) {
  for (const Contact& contact : world.contacts()) {
    for (int i = 0; i < contact.count; ++i) {
      scene.contacts.push_back({contact.points[std::size_t(i)].at, to_float(contact.normal), contact.slipping});
    }
  }
}

// How large a body is to the eye; 0 for what has no size.
float size_of(const World& world, Body b) {
  if (b.null() || world[b].shape().kind() == ShapeKind::half_space) return 0;
  return float(world[b].shape().bounding_radius());
}

void add_joint(Scene& scene, const World& world, const JointView& joint) {
  constexpr float thickness = 0.035f, away = 1.15f;  // of the body's bounding radius
  JointMark mark{.anchor_a = joint.anchor_a(), .anchor_b = joint.anchor_b()};
  std::visit(
      [&](const auto& d) {
        const auto end = [&](Body b, const Pos& anchor) {
          const Pos center = b.null() ? anchor : world[b].center();
          const float size = size_of(world, b);
          const bool moves = size > 0 && world[b].motion() != Motion::fixed;
          if (moves && float(length(anchor - center)) > away * size)
            scene.links.push_back({center, anchor, thickness * size});
          return center;
        };
        mark.center_a = end(d.a, mark.anchor_a);
        mark.center_b = end(d.b, mark.anchor_b);
        if constexpr (requires { d.at_a; }) {  // a bar or a rope
          const float size = max(size_of(world, d.a), size_of(world, d.b));
          scene.links.push_back({mark.anchor_a, mark.anchor_b, thickness * size});
        }
      },
      joint.definition());
  scene.joints.push_back(mark);
}

}

Scene make_scene(const World& world, std::uint32_t palette) {
  Scene scene;
  add_bodies(scene, world, palette);
  add_contacts(scene, world);
  for (const Joint j : world.joints()) add_joint(scene, world, world[j]);
  return scene;
}

}
