// One window with an OpenGL 3.3 context and Dear ImGui in it. Keys and mouse come as a queue: a key pressed and
// released between two pictures is not lost, and what a panel takes for itself (typing, clicks on it) never gets in.
#pragma once

#include <string>
#include <vector>

struct GLFWwindow;

namespace sudar::ui {

struct InputEvent {
  enum class Kind { key, button, move, wheel };
  Kind kind;
  int code = 0;  // GLFW's key or button
  bool down = false;
  bool repeat = false;  // of a key that is held
  int mods = 0;         // GLFW's
  double x = 0, y = 0;  // of the mouse, in pixels of the framebuffer from the top left; wheel: clicks
};

class Window {
 public:
  Window(int width, int height, const std::string& title);  // throws Error: there is no display, no OpenGL 3.3
  ~Window();
  Window(const Window&) = delete;

  std::vector<InputEvent> wait(double seconds);  // for the next event, at most so long
  void begin_frame();                            // of ImGui
  void end_frame();                              // draws ImGui's over what there is, shows all
  bool closing() const;
  void close();
  void set_title(const std::string&);
  void toggle_fullscreen();
  int width() const { return width_; }  // of the framebuffer; 0: minimised
  int height() const { return height_; }

 private:
  static Window& of(GLFWwindow*);
  GLFWwindow* window_ = nullptr;
  int width_ = 0, height_ = 0;
  int windowed_[4] = {};  // place and size before it filled the screen
  std::vector<InputEvent> events_;
};

}
