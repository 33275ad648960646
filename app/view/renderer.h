// Draws a Scene with OpenGL 3.3 core into a framebuffer. Knows no window and no context: whoever calls has made one
// current, and it stays current as long as the renderer lives.
// A picture: shadow map → bodies, floors, sky in linear light at several samples per pixel → ambient occlusion → walls
// and marks → tone mapping into the target. A plain picture has its final colours at once and leaves out what it can,
// for machines that draw in software.
#pragma once

#include <memory>

#include "view/camera.h"
#include "view/image.h"
#include "view/scene.h"

namespace sudar::view {

enum class Colouring { body, speed, island, sleep };  // by which bodies have their colours

enum class Finish { plain, fine };

struct Style {
  bool contacts = false, joints = false, forces = false, axes = false;  // marks over the picture
  bool boxes = false, cells = false;                                    // of the broad phase
  bool wireframe = false;
  bool sleep = false;  // bodies asleep are pale
  Colouring colouring = Colouring::body;
  bool occlusion = true;     // ambient occlusion
  int samples = 2;           // per pixel along each side, 1…4: anti-aliasing
  int shadow_texels = 2048;  // edge of the shadow map
  bool plain = false;        // simpler light in one pass; then neither occlusion nor samples

  void set(Finish);  // the last four
  bool operator==(const Style&) const = default;
};

inline Detail needed_for(const Style& s) { return {s.forces, s.boxes, s.cells, s.colouring == Colouring::island}; }

// The speed that the fastest of the scene's bodies does not exceed, rounded up to a power of two: the end of the scale
// of Colouring::speed. 0: nothing moves.
float top_speed(const Scene&);

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
