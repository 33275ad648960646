// Draws a Scene with OpenGL 3.3 core into a framebuffer. Knows no window and no context: whoever calls has made one
// current, and it stays current as long as the renderer lives.
// A picture: shadow map → bodies, floors, sky in linear light at several samples per pixel → ambient occlusion → walls
// and marks → tone mapping into the target.
#pragma once

#include <memory>

#include "view/camera.h"
#include "view/image.h"
#include "view/scene.h"

namespace sudar::view {

struct Style {
  bool contacts = false, joints = false, axes = false;  // marks over the picture
  bool wireframe = false;
  bool sleep = false;        // bodies asleep are pale
  bool occlusion = true;     // ambient occlusion
  int samples = 2;           // per pixel along each side, 1…4: anti-aliasing
  int shadow_texels = 2048;  // edge of the shadow map
};

struct Target {
  unsigned framebuffer = 0;
  int width = 0, height = 0;
};

class Renderer {
 public:
  Renderer();  // throws std::runtime_error when there is no OpenGL 3.3
  ~Renderer();
  void draw(const Scene&, const Camera&, const Style&, const Target&);
  IdImage ids(const Scene&, const Camera&, int width, int height);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}
