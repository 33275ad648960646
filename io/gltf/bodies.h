// KHR_physics_rigid_bodies: motions and colliders become bodies.
#pragma once

#include <map>

#include "io/gltf/geometry.h"

namespace sudar::inline SUDAR_PRECISION::io::gltf {

// The scene's bodies in a model, and which node is which.
class Bodies {
 public:
  // Throws FileError. Adds bodies, and materials of pairs, to the model.
  Bodies(Document&, const SceneTree&, Model&);

  // Whose frame a node's is fixed in: that of the nearest motion at or above it, else of the nearest collider that
  // stands still; none: the world's.
  std::optional<std::size_t> body_of(std::size_t node) const;

 private:
  struct Material {
    sudar::Material values{};
    std::optional<std::size_t> friction_mode{}, restitution_mode{};  // in combine_modes; none: no say
  };
  void read_materials();
  void read_filters();
  void add_body(std::size_t node);
  void add_obstacle(std::size_t node);
  bool add_collider(BodyDef&, std::vector<std::optional<MassProperties>>&, const JsonValue& collider, const Frame& body,
                    const Affine& place, std::size_t number);
  void set_mass(BodyDef&, const JsonValue& motion, const Vec3d& scale,
                const std::vector<std::optional<MassProperties>>&);
  void set_inertia(BodyDef&, const JsonValue& motion, const Inertial& own);
  void hold(std::size_t number, const JsonValue& motion, bool turns_freely);
  void mix_pairs();

  Document& doc_;
  const SceneTree& tree_;
  Model& model_;
  Geometry geometry_;
  std::vector<Material> materials_;
  std::vector<Filter> filters_;
  std::vector<std::optional<std::size_t>> moving_, standing_;  // by node: the body that it is the root of
  std::vector<std::vector<std::size_t>> colliders_;            // by moving body: nodes
  std::vector<std::vector<std::size_t>> used_;                 // by body: numbers of materials, each once
};

}
