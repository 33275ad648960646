// What can be shown over the picture: contact points with their normals (green: sticking, red: slipping), joints with
// their anchors, axes and limits, forces, the bodies' axes. Thicknesses are in the picture's scale, not the world's.
#pragma once

#include "view/instances.h"
#include "view/renderer.h"

namespace sudar::view {

class Marks {
 public:
  void place(const Scene&, const Pos& eye, const Style&);
  void draw() const { instances_.draw(); }

 private:
  using Copies = std::vector<std::vector<GpuInstance>>;
  void add_dot(Copies&, const Vec3f& at, float radius, const Vec3f& colour) const;
  void add_stick(Copies&, const Vec3f& from, const Vec3f& to, float radius, const Vec3f& colour) const;
  void add_freedom(Copies&, const JointMark&, const Pos& eye) const;
  void add_forces(Copies&, const Scene&, const Pos& eye) const;
  void add_arrow(Copies&, const Vec3f& from, const Vec3f& to, float radius, const Vec3f& colour) const;
  Instances instances_;
  std::size_t dot_ = instances_.add_mesh(sphere_mesh(3));
  std::size_t stick_ = instances_.add_mesh(stick_mesh());
  std::size_t cone_ = instances_.add_mesh(cone_mesh());
};

}
