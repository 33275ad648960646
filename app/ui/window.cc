#include "ui/window.h"

#include <epoxy/gl.h>
// epoxy first: GLFW takes the OpenGL that is there.
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>
#include <sudar/base.h>

#include <utility>

#include "ui/fonts.h"

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

InputEvent mouse(GLFWwindow* w, InputEvent::Kind kind) {
  InputEvent e{.kind = kind};
  glfwGetCursorPos(w, &e.x, &e.y);
  e.x = pixels(w, e.x), e.y = pixels(w, e.y);
  return e;
}

}

Window& Window::of(GLFWwindow* w) { return *static_cast<Window*>(glfwGetWindowUserPointer(w)); }

Window::Window(int width, int height, const std::string& title) {
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
    // Releases always pass: a key that went down before a field was entered must not stay down.
    if (action != GLFW_RELEASE && ImGui::GetIO().WantTextInput) return;
    of(w).events_.push_back({.kind = InputEvent::Kind::key,
                             .code = key,
                             .down = action != GLFW_RELEASE,
                             .repeat = action == GLFW_REPEAT,
                             .mods = mods});
  });
  glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int button, int action, int mods) {
    if (action != GLFW_RELEASE && ImGui::GetIO().WantCaptureMouse) return;
    InputEvent e = mouse(w, InputEvent::Kind::button);
    e.code = button, e.down = action != GLFW_RELEASE, e.mods = mods;
    of(w).events_.push_back(e);
  });
  glfwSetCursorPosCallback(
      window_, [](GLFWwindow* w, double, double) { of(w).events_.push_back(mouse(w, InputEvent::Kind::move)); });
  glfwSetScrollCallback(window_, [](GLFWwindow* w, double, double clicks) {
    if (!ImGui::GetIO().WantCaptureMouse) { of(w).events_.push_back({.kind = InputEvent::Kind::wheel, .y = clicks}); }
  });
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;  // the layout is fixed: there is nothing to remember
  load_fonts();
  ImGui_ImplGlfw_InitForOpenGL(window_, true);
  ImGui_ImplOpenGL3_Init("#version 330");
}

Window::~Window() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
  glfwDestroyWindow(window_);
  glfwTerminate();
}

std::vector<InputEvent> Window::wait(double seconds) {
  seconds > 0 ? glfwWaitEventsTimeout(seconds) : glfwPollEvents();
  glfwGetFramebufferSize(window_, &width_, &height_);
  return std::exchange(events_, {});
}

void Window::begin_frame() {
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
}

void Window::end_frame() {
  ImGui::Render();
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, width_, height_);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  glfwSwapBuffers(window_);
}

bool Window::closing() const { return glfwWindowShouldClose(window_); }
void Window::close() { glfwSetWindowShouldClose(window_, GLFW_TRUE); }
void Window::set_title(const std::string& title) { glfwSetWindowTitle(window_, title.c_str()); }

void Window::toggle_fullscreen() {
  int(&r)[4] = windowed_;
  if (glfwGetWindowMonitor(window_)) return glfwSetWindowMonitor(window_, nullptr, r[0], r[1], r[2], r[3], 0);
  GLFWmonitor* monitor = glfwGetPrimaryMonitor();
  if (!monitor) return;
  glfwGetWindowPos(window_, &r[0], &r[1]);
  glfwGetWindowSize(window_, &r[2], &r[3]);
  const GLFWvidmode* mode = glfwGetVideoMode(monitor);
  glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

}
