#include "io/gltf/read.h"

#include <algorithm>

#include "io/gltf/joints.h"

namespace sudar::inline SUDAR_PRECISION::io {

namespace {

using namespace gltf;

constexpr std::string_view read_extensions[] = {"KHR_physics_rigid_bodies", "KHR_implicit_shapes",
                                                "KHR_mesh_quantization"};
// What only concerns how things look: nothing is lost of how they move.
bool only_looks(std::string_view name) {
  constexpr std::string_view starts[] = {
      "KHR_materials_", "KHR_lights_", "KHR_texture_",        "EXT_texture_",          "EXT_lights_",
      "MSFT_texture_",  "KHR_xmp",     "KHR_node_visibility", "KHR_animation_pointer", "EXT_mesh_gpu_instancing"};
  return std::ranges::any_of(starts, [&](std::string_view s) { return name.starts_with(s); });
}

void check_extensions(const JsonValue& root) {
  for (const JsonValue& e : root["extensionsRequired"].elements()) {
    const std::string name = e.text();
    if (std::ranges::find(read_extensions, name) != std::end(read_extensions) || only_looks(name)) continue;
    const bool compressed = name == "KHR_draco_mesh_compression" || name == "EXT_meshopt_compression";
    e.refuse("the file needs " + name + ", which is not supported" +
             (compressed ? ": export it without compression" : ""));
  }
  for (const JsonValue& e : root["extensionsUsed"].elements()) {
    const std::string name = e.text();
    if (name.starts_with("OMI_physics") || name.starts_with("OMI_collider")) {
      e.warn(name + " is not read: only KHR_physics_rigid_bodies is");
    }
  }
}

std::optional<Camera> camera_of(const Document& doc, const SceneTree& tree) {
  for (const std::size_t i : tree.order) {
    const Node& node = tree.nodes[i];
    if (!node.json["camera"]) continue;
    const JsonValue perspective = doc.element("cameras", node.json["camera"])["perspective"];
    if (!perspective) {
      node.json["camera"].note("is no perspective; left out");
      continue;
    }
    const Frame frame = node.frame();
    Vec3d center;  // of the other nodes, for how far off it looks
    for (const std::size_t k : tree.order) center += tree.nodes[k].global.t * (1.0 / double(tree.order.size()));
    const Vec3d ahead = rotate(frame.q, Vec3d{0, 0, -1}),
                target = frame.p + ahead * max(1.0, dot(center - frame.p, ahead));
    return Camera{.eye = {frame.p.x, frame.p.y, frame.p.z},
                  .target = {target.x, target.y, target.z},
                  .field_of_view = Real(clamp(perspective["yfov"].number(0.7), 0.01, 3.0))};
  }
  return {};
}

// Animations that move what physics should move: the file wants them to have their way.
void tell_animations(const JsonValue& root, const SceneTree& tree, const gltf::Bodies& bodies) {
  for (const JsonValue& animation : root["animations"].elements()) {
    bool moves_bodies = false;
    for (const JsonValue& channel : animation["channels"].elements()) {
      const JsonValue node = channel["target"]["node"];
      moves_bodies |= node && bodies.body_of(node.index(tree.nodes.size())).has_value();
    }
    if (moves_bodies)
      animation.warn("animations are not played: bodies that this one moves move by themselves or stand still");
    else
      animation.note("animations are not played");
  }
}

// Without physics a file is scenery: every mesh an obstacle.
void read_scenery(Document& doc, const SceneTree& tree, Model& model) {
  gltf::Geometry geometry(doc, tree);
  for (const std::size_t i : tree.order) {
    const Node& node = tree.nodes[i];
    if (!node.json["mesh"]) continue;
    doc.source().count_item();
    const Frame frame = node.frame();
    const Affine local = affine(inverse(frame)) * node.global;
    try {
      Surface own = geometry.own_surface(i);
      for (Vec3d& v : own.vertices) v = local.point(v);
      BodyDef def{.shape = geometry.obstacle(node.json, own).shape,
                  .at = pose_of(frame).p,
                  .turn = pose_of(frame).q,
                  .motion = Motion::fixed,
                  .name = tree.name_of(i)};
      model.bodies.push_back({std::move(def), node.json.origin(), tree.name_of(i)});
    } catch (const FileError&) { throw; } catch (const Error& e) {
      node.json.warn(std::string("makes no obstacle (") + e.what() + "); left out");
    }
  }
  doc.source().note({}, "has no physics (KHR_physics_rigid_bodies): its meshes are obstacles that stand still");
}

}

Model read_gltf(Source& source) {
  Document doc(source);
  const JsonValue root = doc.root();
  check_extensions(root);
  const SceneTree tree(doc);
  Model model;
  if (const JsonValue scenes = root["scenes"]; scenes.size() > 0) {
    model.name = scenes.element(root["scene"].whole(0))["name"].text("");
  }
  const bool physics = std::ranges::any_of(tree.order, [&](std::size_t i) { return bool(tree.nodes[i].physics()); });
  if (physics) {
    const gltf::Bodies bodies(doc, tree, model);
    read_joints(doc, tree, bodies, model);
    tell_animations(root, tree, bodies);
  } else {
    read_scenery(doc, tree, model);
  }
  if (model.bodies.empty()) source.warn({}, "has nothing that moves or stands in the way");
  model.forces.push_back({Gravity{}, {}, ""});
  model.camera = camera_of(doc, tree);
  return model;
}

}
