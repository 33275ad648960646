// The mouse's camera: turns round a target, slides, comes closer, flies.
#pragma once

#include "history/deeds.h"
#include "view/camera.h"

namespace sudar::ui {

using namespace history;

class CameraControl {
 public:
  const Camera& camera() const { return camera_; }
  void set(const Camera& c) { camera_ = c; }

  // Mouse movements in pixels of a picture of that height.
  void orbit(double dx, double dy);
  void pan(double dx, double dy, double height);
  void zoom(double clicks, const Ray& towards);  // what the ray shows stays under the mouse
  void fly(const Vec3& way, double seconds);     // right, up, forward, each −1…1
  void look(double dx, double dy);               // turns the head
  void look_as_far_as(double distance);          // puts the target there, in the same direction
  void look_at(const Pos&);                      // slides there
  void frame(const Pos& centre, double radius);

  struct Seen {
    double x, y, depth;  // pixels from the top left; m along the view
  };
  std::optional<Seen> project(const Pos&, double width, double height) const;  // none: behind the eye
  Ray ray(double x, double y, double width, double height) const;              // through a pixel; y from the top

 private:
  Camera camera_{.eye = {0, 2, 10}, .target = {}};
};

}
