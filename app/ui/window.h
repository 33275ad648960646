// One window with an OpenGL 3.3 context. Keys and mouse come as a queue: a key pressed and released between two
// pictures is not lost.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "ui/input.h"

struct GLFWwindow;

namespace sudar::ui {

class Window {
 public:
  Window(int width, int height, const std::string& title);  // throws Error: there is no display, no OpenGL 3.3
  ~Window();
  Window(const Window&) = delete;

  std::vector<std::string> take_dropped() { return std::exchange(dropped_, {}); }  // names of files dropped since
  std::vector<InputEvent> wait(double seconds);  // for the next event, at most so long
  void target() const;                           // what is drawn from now on goes into the window
  void show();                                   // what was drawn
  bool closing() const;
  void close();
  void set_title(const std::string&);
  void toggle_fullscreen();
  bool fullscreen() const;
  int width() const { return width_; }  // of the framebuffer; 0: minimised
  int height() const { return height_; }

 private:
  static Window& of(GLFWwindow*);
  GLFWwindow* window_ = nullptr;
  int width_ = 0, height_ = 0;
  double x_ = 0, y_ = 0;  // of the mouse, as its last event told: asking for it now could be ahead of a click
  int windowed_[4] = {};  // place and size before it filled the screen
  std::vector<InputEvent> events_;
  std::vector<std::string> dropped_;
};

}
