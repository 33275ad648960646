// World → Scene.
#include <cmath>

#include "view/palette.h"
#include "view/scene.h"

namespace sudar::view {

namespace {

void add_bodies(Scene& scene, const World& world, std::uint32_t palette) {
  // Gradients are numbered by the first shapes of what moves: grey things use none up.
  std::vector<std::uint32_t> gradient;
  std::uint32_t next = palette;
  for (const Body b : world.bodies()) {
    const BodyView view = world[b];
    const bool fixed = view.motion() == Motion::fixed;
    const std::size_t first = scene.instances.size();
    for (const ShapeId s : view.shapes()) {
      add_instance(scene, world[s].shape(),
                   {.pose = world[s].pose(),
                    .body = b,
                    .part = s,
                    .first = scene.instances.size() == first,
                    .fixed = fixed,
                    .asleep = view.asleep(),
                    .speed = float(length(view.velocity())),
                    .name = view.name()});
    }
    constexpr std::uint32_t none = ~0u;
    gradient.resize(scene.shapes.size(), none);
    std::uint32_t& own = gradient[scene.instances[first].shape];
    if (!fixed && own == none) own = next++;
    for (std::size_t n = first; n < scene.instances.size(); ++n) {
      scene.instances[n].colour = fixed ? fixed_colour() : body_colour(own, b.index);
    }
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
  if (b.null() || !std::isfinite(world[b].radius())) return 0;
  return float(world[b].radius());
}

// The free coordinate of a hinge or slider, of a joint that has one.
template <class Definition>
void add_axis(JointMark& mark, const JointView& joint, const Definition& d) {
  const auto axis = [&](const Vec3& v) { return to_float(rotate(joint.frame_a(), v)); };
  constexpr bool has_axis = requires { d.axis; }
  || requires { d.normal; };
  if constexpr (has_axis) mark.axis = axis({1, 0, 0});
  if constexpr (std::is_same_v<Definition, Hinge> || std::is_same_v<Definition, Slider>) {
    mark.freedom = {mark.axis,          axis({0, 1, 0}),     std::is_same_v<Definition, Hinge>,
                    float(d.limit.low), float(d.limit.high), float(joint.coordinate())};
  }
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
          if (moves && (mark.size == 0 || size < mark.size)) mark.size = size;
          return center;
        };
        mark.center_a = end(d.a, mark.anchor_a);
        mark.center_b = end(d.b, mark.anchor_b);
        const float wide = thickness * max(size_of(world, d.a), size_of(world, d.b));
        if constexpr (requires { d.over_a; }) {  // a rope over pulleys
          scene.links.push_back({mark.anchor_a, d.over_a, wide});
          scene.links.push_back({d.over_a, d.over_b, wide});
          scene.links.push_back({d.over_b, mark.anchor_b, wide});
        } else if constexpr (requires { d.at_a; }) {  // a bar or a rope
          scene.links.push_back({mark.anchor_a, mark.anchor_b, wide});
        }
        add_axis(mark, joint, d);
      },
      joint.definition());
  scene.joints.push_back(mark);
}

// Weights, and what contacts and joints exerted in the last sub-step.
void add_forces(Scene& scene, const World& world) {
  Vec3 gravity{};
  for (const ForceId f : world.forces()) {
    if (const auto* g = std::get_if<Gravity>(&world[f])) gravity += g->acceleration;
  }
  float weight = 0, size = 0, largest = 0;
  int bodies = 0;
  const auto add = [&](ForceMark::Kind kind, const Pos& at, const Vec3& force) {
    const Vec3f f = to_float(force);
    if (length(f) > 0) scene.forces.push_back({kind, at, f}), largest = max(largest, length(f));
  };
  for (const Body b : world.bodies()) {
    const BodyView view = world[b];
    if (view.motion() != Motion::dynamic) continue;
    add(ForceMark::Kind::weight, view.center(), gravity * (view.mass() * view.gravity_factor()));
    weight += float(length(gravity) * view.mass() * std::abs(view.gravity_factor())), size += size_of(world, b), ++bodies;
  }
  const Config& config = world.config();
  const Real sub_step = Real(config.dt * double(config.time_factor) / config.substeps);
  for (const Contact& contact : world.contacts()) {
    for (int i = 0; i < contact.count; ++i) {
      const Contact::Point& p = contact.points[std::size_t(i)];
      // On b, or on a where b does not move: what holds a body points at it.
      const Vec3 on_a = (contact.normal * p.normal_impulse + p.friction) / sub_step;
      add(contact.slipping ? ForceMark::Kind::slip : ForceMark::Kind::stick, p.at,
          world[contact.b].motion() == Motion::dynamic ? -on_a : on_a);
    }
  }
  for (const Joint j : world.joints()) add(ForceMark::Kind::joint, world[j].anchor_b(), world[j].load().force);
  // The mean weight is an arrow as long as the mean body; without weights the largest force is.
  const float unit = weight > 0 ? weight / float(bodies) : largest;
  scene.metres_per_newton = unit > 0 ? 1.5f * size / float(max(1, bodies)) / unit : 0;
}

void add_islands(Scene& scene, const World& world) {
  const std::vector<std::uint32_t> islands = world.islands();  // in the order of the bodies
  std::vector<std::uint32_t> members;
  for (const std::uint32_t i : islands) {
    if (i >= members.size()) members.resize(i + 1);
    ++members[i];
  }
  std::size_t bodies = 0;
  for (Instance& i : scene.instances) {
    bodies += i.first ? 1 : 0;
    i.island = islands[bodies - 1];
    i.alone = members[i.island] < 2;
  }
}

}

Scene make_scene(const World& world, const Detail& detail, std::uint32_t palette) {
  Scene scene;
  add_bodies(scene, world, palette);
  add_contacts(scene, world);
  for (const Joint j : world.joints()) add_joint(scene, world, world[j]);
  if (detail.forces) add_forces(scene, world);
  if (detail.islands) add_islands(scene, world);
  const auto marks = [](const std::vector<Box>& boxes) {
    std::vector<BoxMark> all;
    for (const Box& b : boxes) all.push_back({b.low, b.high});
    return all;
  };
  if (detail.boxes) scene.boxes = marks(world.fat_boxes());
  if (detail.cells) scene.cells = marks(world.broad_boxes());
  return scene;
}

}
