// What keys and mouse did, in order.
#pragma once

namespace sudar::ui {

struct InputEvent {
  enum class Kind { key, character, button, move, wheel };
  Kind kind;
  int code = 0;  // GLFW's key or button; of a character its Unicode number
  bool down = false;
  bool repeat = false;  // of a key that is held
  int mods = 0;         // GLFW's
  double x = 0, y = 0;  // of the mouse, in pixels of the framebuffer from the top left; wheel: clicks
};

}
