#include "ui/window.h"

#include <epoxy/gl.h>
// epoxy first: GLFW takes the OpenGL that is there.
#include <GLFW/glfw3.h>
#include <sudar/base.h>

#include <utility>

#include "main/priority.h"

namespace sudar::ui {

namespace {

[[noreturn]] void fail(const char* what) {
  const char* reason = nullptr;
  glfwGetError(&reason);
  throw Error("window", std::string(what) + (reason ? std::string(" (") + reason + ")" : ""));
}

// From the window's units to the framebuffer's pixels.
double pixels(GLFWwindow* w, double v) {
  int in_window = 1, in_framebuffer = 1, ignored = 0;
  glfwGetWindowSize(w, &in_window, &ignored);
  glfwGetFramebufferSize(w, &in_framebuffer, &ignored);
  return in_window > 0 ? v * in_framebuffer / in_window : v;
}

}

Window& Window::of(GLFWwindow* w) { return *static_cast<Window*>(glfwGetWindowUserPointer(w)); }

Window::Window(int width, int height, const std::string& title) {
  app::step_back();
  if (!glfwInit()) fail("there is no display to open a window on");
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  window_ = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
  if (!window_) {
    const char* reason = nullptr;
    glfwGetError(&reason);
    const std::string text = reason ? reason : "";
    glfwTerminate();
    throw Error("window", "OpenGL 3.3 is needed (" + text + ")");
  }
  glfwMakeContextCurrent(window_);
  glfwSwapInterval(1);
  glfwSetWindowUserPointer(window_, this);
  glfwGetFramebufferSize(window_, &width_, &height_);
  glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int, int action, int mods) {
    of(w).events_.push_back({.kind = InputEvent::Kind::key,
                             .code = key,
                             .down = action != GLFW_RELEASE,
                             .repeat = action == GLFW_REPEAT,
                             .mods = mods});
  });
  glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int button, int action, int mods) {
    of(w).events_.push_back({.kind = InputEvent::Kind::button,
                             .code = button,
                             .down = action != GLFW_RELEASE,
                             .mods = mods,
                             .x = of(w).x_,
                             .y = of(w).y_});
  });
  glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double x, double y) {
    of(w).x_ = pixels(w, x), of(w).y_ = pixels(w, y);
    of(w).events_.push_back({.kind = InputEvent::Kind::move, .x = of(w).x_, .y = of(w).y_});
  });
  glfwSetScrollCallback(window_, [](GLFWwindow* w, double, double clicks) {
    of(w).events_.push_back({.kind = InputEvent::Kind::wheel, .y = clicks});
  });
  glfwSetDropCallback(window_, [](GLFWwindow* w, int count, const char** paths) {
    of(w).dropped_.insert(of(w).dropped_.end(), paths, paths + count);
  });
  glfwSetCharCallback(window_, [](GLFWwindow* w, unsigned code) {
    of(w).events_.push_back({.kind = InputEvent::Kind::character, .code = int(code)});
  });
}

Window::~Window() {
  glfwDestroyWindow(window_);
  glfwTerminate();
}

std::vector<InputEvent> Window::wait(double seconds) {
  seconds > 0 ? glfwWaitEventsTimeout(seconds) : glfwPollEvents();
  glfwGetFramebufferSize(window_, &width_, &height_);
  return std::exchange(events_, {});
}

void Window::target() const {
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, width_, height_);
}

void Window::show() { glfwSwapBuffers(window_); }

bool Window::closing() const { return glfwWindowShouldClose(window_); }
void Window::close() { glfwSetWindowShouldClose(window_, GLFW_TRUE); }
void Window::set_title(const std::string& title) { glfwSetWindowTitle(window_, title.c_str()); }

bool Window::fullscreen() const { return glfwGetWindowMonitor(window_) != nullptr; }

void Window::toggle_fullscreen() {
  int(&r)[4] = windowed_;
  if (fullscreen()) return glfwSetWindowMonitor(window_, nullptr, r[0], r[1], r[2], r[3], 0);
  GLFWmonitor* monitor = glfwGetPrimaryMonitor();
  if (!monitor) return;
  glfwGetWindowPos(window_, &r[0], &r[1]);
  glfwGetWindowSize(window_, &r[2], &r[3]);
  const GLFWvidmode* mode = glfwGetVideoMode(monitor);
  glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

}
