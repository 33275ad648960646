// Half spaces: floors with a grid for scale that fade into the horizon, and walls as faint panes.
#pragma once

#include "view/camera.h"
#include "view/gl.h"

namespace sudar::view {

class Ground {
 public:
  explicit Ground(const std::vector<std::string>& light);  // the shaders that light it
  // Floors (glass = false) are drawn solid, walls (glass = true) are laid over what there is. Surfaces seen from
  // below or behind are left out. `focus`: what the walls are drawn round.
  void draw(const Scene&, const Camera&, const Focus&, bool glass) const;
  const gl::Program& floors() const { return floors_; }
  const gl::Program& walls() const { return walls_; }

 private:
  gl::Program floors_, walls_;
  gl::VertexArray none_ = gl::make_vertex_array();
};

}
