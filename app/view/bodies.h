// The bodies and links of a scene as instances of meshes. Meshes are made once per shape and kept from picture to
// picture.
#pragma once

#include "view/instances.h"
#include "view/scene.h"

namespace sudar::view {

class Bodies {
 public:
  // Takes all links and all instances but half spaces. `show_sleep`: bodies asleep are pale.
  void place(const Scene&, const Pos& eye, bool show_sleep);
  void draw() const { instances_.draw(); }

 private:
  struct Known {
    Shape shape;
    std::size_t mesh;
  };
  std::size_t mesh_of(const Shape&);
  Instances instances_;
  std::vector<Known> known_;
  std::size_t sphere_ = instances_.add_mesh(sphere_mesh());
  std::size_t rod_ = instances_.add_mesh(stick_mesh());
};

}
