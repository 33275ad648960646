// Half spaces: floors with a grid for scale that fade into the horizon, and walls as faint panes.
#pragma once

#include "view/camera.h"
#include "view/gl.h"

namespace sudar::view {

class Ground {
 public:
  // Floors (glass = false) are drawn solid, walls (glass = true) are laid over what there is. Surfaces seen from
  // below or behind are left out. `focus`: what the walls are drawn round.
  void draw(const Scene&, const Camera&, const Focus&, bool glass) const;

 private:
  gl::Program program_{{"frame.glsl", "ground.vert.glsl"}, {"frame.glsl", "light.glsl", "ground.frag.glsl"}};
  gl::VertexArray none_ = gl::make_vertex_array();

  friend class Renderer;  // binds the frame block and the shadow map to its programs
};

}
