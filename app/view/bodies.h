// The bodies and links of a scene as instances of meshes. Meshes are made once per shape and kept from picture to
// picture.
#pragma once

#include <array>

#include "view/instances.h"
#include "view/renderer.h"

namespace sudar::view {

class Bodies {
 public:
  // Takes all links and all instances but half spaces, in the style's colours.
  void place(const Scene&, const Pos& eye, const Style&);
  void draw() const { instances_.draw(); }
  bool any_ghosts() const { return instances_.any_translucent(); }
  void draw_ghosts() const { instances_.draw_translucent(); }
  void draw_for_shadows() const { instances_.draw(Instances::Detail::plainer); }

 private:
  struct Known {
    Shape shape;
    std::size_t mesh;
  };
  std::size_t mesh_of(const Shape&);  // the finest
  std::size_t mesh_for(const Shape&, std::size_t finest, float distance, bool plain) const;
  Instances instances_;
  std::vector<Known> known_;
  // Spheres from coarse to fine: how many triangles one needs depends on how large it is seen.
  std::array<std::size_t, 4> spheres_ = {
      instances_.add_mesh(sphere_mesh(1)), instances_.add_mesh(sphere_mesh(2), sphere_mesh(1)),
      instances_.add_mesh(sphere_mesh(3), sphere_mesh(2)), instances_.add_mesh(sphere_mesh(6), sphere_mesh(3))};
  std::size_t rod_ = instances_.add_mesh(stick_mesh());
};

}
