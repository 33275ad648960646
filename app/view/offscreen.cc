#include "view/offscreen.h"

#include <epoxy/egl.h>

#include <stdexcept>

#include "view/canvas.h"

namespace sudar::view {

namespace {

class Context {
 public:
  Context() {
    display_ = open_display();
    if (!eglBindAPI(EGL_OPENGL_API)) fail("EGL offers no desktop OpenGL");
    const EGLint wanted[] = {
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    context_ = eglCreateContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted);
    if (context_ == EGL_NO_CONTEXT) fail("there is no OpenGL 3.3");
    if (!eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) fail("the context needs a window");
  }
  ~Context() { close(); }
  Context(const Context&) = delete;

 private:
  static EGLDisplay open_display() {
    EGLDisplay display = EGL_NO_DISPLAY;
    if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
      display = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    }
    if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr)) return display;
    display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr)) return display;
    throw std::runtime_error("drawing without a window needs EGL, which does not start here (package libegl1)");
  }
  [[noreturn]] void fail(const std::string& reason) {
    close();
    throw std::runtime_error("drawing without a window: " + reason);
  }
  void close() {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context_ != EGL_NO_CONTEXT) eglDestroyContext(display_, context_);
    eglTerminate(display_);
  }

  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}

struct Offscreen::Impl {
  Context context;  // first, so that it goes last
  Renderer renderer;
  std::optional<Canvas> canvas;
};

Offscreen::Offscreen() : impl_(std::make_unique<Impl>()) {}
Offscreen::~Offscreen() = default;

Image Offscreen::picture(const Scene& scene, const Camera& camera, const Style& style, int width, int height) {
  std::optional<Canvas>& canvas = impl_->canvas;
  if (!canvas || canvas->width() != width || canvas->height() != height) canvas.emplace(width, height);
  impl_->renderer.draw(scene, camera, style, canvas->target());
  return canvas->read();
}

IdImage Offscreen::ids(const Scene& scene, const Camera& camera, int width, int height) {
  return impl_->renderer.ids(scene, camera, width, height);
}

std::string Offscreen::driver() const { return reinterpret_cast<const char*>(glGetString(GL_RENDERER)); }

}
