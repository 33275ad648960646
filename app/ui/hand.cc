#include "ui/hand.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>

namespace sudar::ui {

// The mouse points elsewhere when it moves, and when the camera does.
void Hand::aim() {
  const Area& area = controls_.area;
  controls_.pointer = controls_.camera.ray(x_ - area.x, y_ - area.y, area.width, area.height);
}

void Hand::take(const InputEvent& e, const Area& area) {
  using Kind = InputEvent::Kind;
  aim();
  if (e.kind == Kind::key) return key(e);
  if (e.kind == Kind::wheel) return controls_.camera.zoom(e.y, controls_.pointer);
  const double dx = e.x - x_, dy = e.y - y_;
  x_ = e.x, y_ = e.y;
  aim();
  if (e.kind == Kind::move) return move(dx, dy, area);
  if (e.down && mode_ == Mode::none) return press(e, area);
  if (!e.down && e.code == button_) release();
}

void Hand::press(const InputEvent& e, const Area& area) {
  const bool shift = e.mods & GLFW_MOD_SHIFT, ctrl = e.mods & GLFW_MOD_CONTROL;
  button_ = e.code;
  if (e.code == GLFW_MOUSE_BUTTON_MIDDLE) mode_ = shift ? Mode::pan : Mode::orbit;
  if (e.code == GLFW_MOUSE_BUTTON_RIGHT) mode_ = Mode::right;
  if (e.code != GLFW_MOUSE_BUTTON_LEFT) return;
  const Body body = pick_(int(e.x) - area.x, int(e.y) - area.y);
  controls_.select(body);
  mode_ = body.null() ? Mode::orbit : ctrl ? Mode::twist : Mode::drag;
  if (!body.null()) controls_.simulation().perform(Grab{body, controls_.pointer});
}

void Hand::move(double dx, double dy, const Area& area) {
  CameraControl& camera = controls_.camera;
  Simulation& simulation = controls_.simulation();
  switch (mode_) {
    case Mode::none:
      return;
    case Mode::orbit:
      return camera.orbit(dx, dy);
    case Mode::pan:
      return camera.pan(dx, dy, area.height);
    case Mode::right:
      return down_.empty() ? camera.pan(dx, dy, area.height) : camera.look(dx, dy);
    case Mode::drag:
      return simulation.perform(DragTo{controls_.pointer});
    case Mode::twist: {
      // A pixel of movement asks for 0.2 rad/s about the axis across it.
      const Ray& ray = controls_.pointer;
      const Vec3 right = normalize(cross(ray.forward, Vec3{0, 1, 0})), up = cross(right, ray.forward);
      const Vec3 spin = (up * Real(dx) + right * Real(dy)) * Real(0.2);
      return simulation.perform(Twist{spin});
    }
  }
}

void Hand::release() {
  if (mode_ == Mode::drag || mode_ == Mode::twist) {
    controls_.simulation().perform(Release{});
  }
  mode_ = Mode::none;
}

void Hand::key(const InputEvent& e) {
  std::erase(down_, e.code);
  const bool flies = mode_ == Mode::right && std::string_view("WASDQE").find(char(e.code)) != std::string_view::npos;
  if (e.down && flies) return down_.push_back(e.code);
  const bool bare = (e.mods & (GLFW_MOD_CONTROL | GLFW_MOD_ALT)) == 0;
  if (!e.down || (bare && controls_.belongs_to_scenario(e.code))) return controls_.key(e.code, e.down);
  if (const Binding* b = find_binding(e.code, e.mods)) {
    const bool repeats = b->action == Action::step || b->action == Action::ten_steps || b->action == Action::step_back ||
                         b->action == Action::ten_steps_back;
    if (!e.repeat || repeats) controls_.perform(b->action);
  }
}

void Hand::fly(double seconds) {
  if (mode_ != Mode::right || down_.empty()) return;
  const auto axis = [&](char plus, char minus) {
    const auto held = [&](char c) { return std::find(down_.begin(), down_.end(), int(c)) != down_.end(); };
    return Real(int(held(plus)) - int(held(minus)));
  };
  controls_.camera.fly({axis('D', 'A'), axis('E', 'Q'), axis('W', 'S')}, seconds);
  // What is turned round later lies as far ahead as the scene is away, and the flight slows down near it.
  const view::Focus& focus = controls_.focus;
  const double away = double(length(focus.centre - controls_.camera.camera().eye));
  controls_.camera.look_as_far_as(std::max(away, 0.2 * double(focus.radius)));
}

}
