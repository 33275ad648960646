// The geometry of colliders: KHR_implicit_shapes, and the meshes of nodes.
#pragma once

#include "io/gltf/scene.h"
#include "io/surface.h"

namespace sudar::inline SUDAR_PRECISION::io::gltf {

// A shape in its place, and what weighs there if that is not what the shape would.
struct Solid {
  Shape shape;
  Frame at;                            // of the shape, in the body
  std::optional<MassProperties> mass;  // per unit density, in the same frame; none: the shape's
};

class Geometry {
 public:
  Geometry(Document& doc, const SceneTree& tree) : doc_(doc), tree_(tree) {}

  // Of a "geometry" object that stands in a body at `place`, with its scale. `dynamic`: the body falls, so that an
  // obstacle does not do. None: it is disabled, or what a finding says.
  std::optional<Solid> solid(const JsonValue& geometry, const Affine& place, bool dynamic);
  // All triangles of a node's mesh, and of those of its children, in the node's frame.
  Surface surface(std::size_t node);
  Surface own_surface(std::size_t node);  // without the children
  Solid obstacle(const JsonValue& where, const Surface&);

 private:
  std::optional<Solid> implicit(const JsonValue& shape, const JsonValue& where, const Affine& place, bool dynamic);
  std::optional<Solid> of_surface(const JsonValue& where, const Surface&, bool as_hull, bool dynamic);
  std::optional<Solid> plane(const JsonValue& shape, const JsonValue& where, const Affine& place, bool dynamic);
  void add_mesh(const JsonValue& mesh, const Affine& place, Surface& to);

  Document& doc_;
  const SceneTree& tree_;
};

}
