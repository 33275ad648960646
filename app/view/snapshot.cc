// World → Scene.
#include "view/palette.h"
#include "view/scene.h"

namespace sudar::inline SUDAR_PRECISION {

namespace {

void add_bodies(Scene& scene, const World& world) {
  // Gradients are numbered by the shapes that move: grey things use none up.
  std::vector<std::uint32_t> gradient;
  std::uint32_t gradients = 0;
  for (const Body b : world.bodies()) {
    const BodyView view = world[b];
    const bool fixed = view.motion() == Motion::fixed;
    add_instance(scene, view.shape(), {.pose = view.pose(), .body = b, .fixed = fixed, .asleep = view.asleep()});
    Instance& instance = scene.instances.back();
    constexpr std::uint32_t none = ~0u;
    gradient.resize(scene.shapes.size(), none);
    std::uint32_t& own = gradient[instance.shape];
    if (!fixed && own == none) own = gradients++;
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

JointMark mark_of(const World& world, const JointView& joint) {
  JointMark mark{.anchor_a = joint.anchor_a(), .anchor_b = joint.anchor_b()};
  const auto center = [&](Body b, const Pos& anchor) { return b.null() ? anchor : world[b].center(); };
  std::visit(
      [&](const auto& d) {
        mark.center_a = center(d.a, mark.anchor_a);
        mark.center_b = center(d.b, mark.anchor_b);
      },
      joint.definition());
  return mark;
}

}

Scene make_scene(const World& world) {
  Scene scene;
  add_bodies(scene, world);
  add_contacts(scene, world);
  for (const Joint j : world.joints()) scene.joints.push_back(mark_of(world, world[j]));
  return scene;
}

}
