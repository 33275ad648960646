// The nodes of a document's scene: who is whose child, and where everything is.
#pragma once

#include "io/gltf/document.h"
#include "io/rigid.h"

namespace sudar::inline SUDAR_PRECISION::io::gltf {

struct Affine {  // x → m x + t
  Mat3d m = Mat3d::identity();
  Vec3d t;
  Vec3d point(const Vec3d& x) const { return m * x + t; }
  friend Affine operator*(const Affine& a, const Affine& b) { return {a.m * b.m, a.point(b.t)}; }
};

inline Affine affine(const Frame& f) { return {matrix(f.q), f.p}; }
inline Pose pose_of(const Frame& f) { return {{f.p.x, f.p.y, f.p.z}, convert<Real>(f.q)}; }

// A linear map as a turn after a scale along the axes. Where it shears, too, the two are not all of it.
struct Scaling {
  Quatd turn;
  Vec3d scale{1, 1, 1};  // the first is negative where the map mirrors
  bool shears = false;
};
Scaling scaling_of(const Mat3d&);

inline constexpr std::size_t no_node = std::size_t(-1);

struct Node {
  JsonValue json;
  std::size_t parent = no_node;
  bool present = false;  // in the scene
  Affine local{}, global{};

  Frame frame() const { return {global.t, scaling_of(global.m).turn}; }
  JsonValue physics() const { return json["extensions"]["KHR_physics_rigid_bodies"]; }
};

struct SceneTree {
  std::string name_of(std::size_t node) const;  // its own, else that of the nearest above it that has one
  std::vector<Node> nodes;
  std::vector<std::size_t> order;  // of those in the scene, parents first
  // Throws FileError where the nodes are no forest.
  explicit SceneTree(const Document&);
};

}
