#include "io/gltf/scene.h"

#include <cmath>

namespace sudar::inline SUDAR_PRECISION::io::gltf {

namespace {

Affine local_of(const JsonValue& node) {
  if (const JsonValue given = node["matrix"]) {  // by columns, §3.5.2
    if (given.size() != 16) given.refuse("has " + std::to_string(given.size()) + " numbers: 16 expected");
    Affine a;
    for (std::size_t k = 0; k < 4; ++k) {
      Vec3d& column = k < 3 ? a.m[int(k)] : a.t;
      for (std::size_t i = 0; i < 3; ++i) column[int(i)] = given.element(4 * k + i).number();
    }
    return a;
  }
  const Vec3d scale = node["scale"].vector({1, 1, 1});
  return {matrix(node["rotation"].rotation()) * Mat3d::diagonal(scale), node["translation"].vector({})};
}

}

std::string SceneTree::name_of(std::size_t node) const {
  for (std::size_t i = node; i != no_node; i = nodes[i].parent) {
    if (const std::string given = nodes[i].json["name"].text(""); !given.empty()) return given;
  }
  return "node " + std::to_string(node);
}

Scaling scaling_of(const Mat3d& m) {
  Scaling s;
  Vec3d axes[3];
  for (int k = 0; k < 3; ++k) {
    s.scale[k] = length(m[k]);
    axes[k] = s.scale[k] > 0 ? m[k] / s.scale[k] : Vec3d{};
  }
  constexpr double square_enough = 1e-5;
  const bool whole = s.scale.x > 0 && s.scale.y > 0 && s.scale.z > 0;
  s.shears = whole && max(max(abs(dot(axes[0], axes[1])), abs(dot(axes[1], axes[2]))), abs(dot(axes[2], axes[0]))) >
                          square_enough;
  // What shears or has no size along an axis keeps its y, then its z.
  const Vec3d y = s.scale.y > 0 ? axes[1] : Vec3d{0, 1, 0};
  Vec3d z = axes[2] - y * dot(y, axes[2]);
  z = length(z) > 1e-9 ? normalize(z) : any_perpendicular(y);
  const Vec3d x = cross(y, z);
  if (dot(x, axes[0]) < 0) s.scale.x = -s.scale.x;
  s.turn = quaternion(Mat3d{x, y, z});
  return s;
}

SceneTree::SceneTree(const Document& doc) {
  const JsonValue list = doc.root()["nodes"];
  const std::size_t count = list.size();
  nodes.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    doc.source().count_item();
    nodes.push_back({.json = list.element(i)});
    nodes.back().local = local_of(nodes.back().json);
  }
  std::vector<std::vector<std::size_t>> children(count);
  for (std::size_t i = 0; i < count; ++i) {
    for (const JsonValue& child : nodes[i].json["children"].elements()) {
      const std::size_t c = child.index(count);
      if (nodes[c].parent != no_node)
        child.refuse("is node " + std::to_string(c) + ", which is another's child already");
      nodes[c].parent = i;
      children[i].push_back(c);
    }
  }
  std::vector<std::size_t> open, roots;
  const JsonValue scenes = doc.root()["scenes"];
  if (scenes.size() > 0) {
    const JsonValue which = doc.root()["scene"];
    for (const JsonValue& root : scenes.element(which ? which.index(scenes.size()) : 0)["nodes"].elements()) {
      const std::size_t i = root.index(count);
      if (nodes[i].parent != no_node) root.refuse("is node " + std::to_string(i) + ", which is another's child");
      roots.push_back(i);
    }
  } else {
    for (std::size_t i = 0; i < count; ++i) {
      if (nodes[i].parent == no_node) roots.push_back(i);
    }
  }
  const std::size_t deepest = doc.source().options().limits.nesting;
  std::vector<std::size_t> depth(count, 0);
  open.assign(roots.rbegin(), roots.rend());
  while (!open.empty()) {
    const std::size_t i = open.back();
    open.pop_back();
    Node& node = nodes[i];
    if (node.present) node.json.refuse("is twice in the scene");
    node.present = true;
    depth[i] = node.parent == no_node ? 0 : depth[node.parent] + 1;
    if (depth[i] > deepest) node.json.refuse("is nested more than " + std::to_string(deepest) + " deep");
    node.global = node.parent == no_node ? node.local : nodes[node.parent].global * node.local;
    if (!is_finite(node.global.t) || !is_finite(node.global.m * Vec3d{1, 1, 1}))
      node.json.refuse("lies beyond all numbers");
    order.push_back(i);
    open.insert(open.end(), children[i].rbegin(), children[i].rend());
  }
}

}
