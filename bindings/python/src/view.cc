// The module sudar._view: pictures of a world, drawn without a window. Apart from sudar._core, which needs no OpenGL.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

#include "access.h"
#include "convert.h"
#include "view/offscreen.h"

namespace sudar::python {

namespace {

using namespace py::literals;

// A context of OpenGL is of one thread. This one draws for all, and lives as long as the process.
class Painter {
 public:
  Painter() {
    std::thread([this] { paint(); }).detach();
  }

  view::Image draw(const std::function<view::Image(view::Offscreen&)>& task) {
    threads_.require_them();
    const std::scoped_lock one_at_a_time(door_);
    std::unique_lock lock(mutex_);
    task_ = &task, failure_ = nullptr;
    bell_.notify_all();
    bell_.wait(lock, [&] { return task_ == nullptr; });
    if (failure_) std::rethrow_exception(failure_);
    return std::move(image_);
  }

 private:
  void paint() {
    std::optional<view::Offscreen> offscreen;
    std::unique_lock lock(mutex_);
    for (;;) {
      bell_.wait(lock, [&] { return task_ != nullptr; });
      try {
        if (!offscreen) offscreen.emplace();
        image_ = (*task_)(*offscreen);
      } catch (...) { failure_ = std::current_exception(); }
      task_ = nullptr;
      bell_.notify_all();
    }
  }

  HasThreads threads_;
  std::mutex door_, mutex_;
  std::condition_variable bell_;
  const std::function<view::Image(view::Offscreen&)>* task_ = nullptr;
  view::Image image_;
  std::exception_ptr failure_;
};

Painter& painter() {
  static Painter& one = *new Painter;
  return one;
}

std::optional<Camera> camera_of(const std::optional<std::vector<py::object>>& given) {
  if (!given) return {};
  Camera c;
  if (given->size() < 2 || given->size() > 3 || !read_numbers((*given)[0], c.eye) ||
      !read_numbers((*given)[1], c.target)) {
    throw Error("camera", "must be (eye, target) or (eye, target, field of view), the first two as three numbers");
  }
  if (given->size() == 3) c.field_of_view = (*given)[2].cast<Real>();
  if (c.eye == c.target) throw Error("camera", "looks at where it is");
  if (!(c.field_of_view > Real(0.01) && c.field_of_view < 3))
    throw Error("camera", "has a field of view outside 0.01 to 3 rad");
  return c;
}

view::Colouring colouring_of(const std::string& name) {
  static constexpr const char* names[] = {"body", "speed", "island", "sleep"};
  for (int i = 0; i < 4; ++i) {
    if (name == names[i]) return view::Colouring(i);
  }
  throw Error("colour", "is \"" + name + "\", expected body, speed, island or sleep");
}

py::array picture(SharedWorld& w, std::pair<int, int> size, const std::optional<std::vector<py::object>>& camera,
                  const std::string& colour, bool contacts, bool joints, bool forces, bool axes, bool wireframe) {
  const int width = size.first, height = size.second;
  if (width < 1 || height < 1 || width > 8192 || height > 8192) throw Error("size", "must be within 1 and 8192");
  view::Style style{.contacts = contacts,
                    .joints = joints,
                    .forces = forces,
                    .axes = axes,
                    .wireframe = wireframe,
                    .colouring = colouring_of(colour)};
  const std::optional<Camera> eye = camera_of(camera);
  const view::Scene scene = view::make_scene(w.get(), view::needed_for(style));
  view::Image image;
  {
    const py::gil_scoped_release released;
    image = painter().draw([&](view::Offscreen& o) {
      return o.picture(scene, eye ? *eye : view::framing(scene, double(width) / height), style, width, height);
    });
  }
  py::array_t<std::uint8_t> array({height, width, 4});
  std::copy(image.rgba.begin(), image.rgba.end(), array.mutable_data());
  return array;
}

}

PYBIND11_MODULE(_view, m) {
  py::module_::import("sudar._core");  // World
  m.def("picture", &picture, "world"_a, "size"_a, "camera"_a, "colour"_a, "contacts"_a, "joints"_a, "forces"_a,
        "axes"_a, "wireframe"_a);
}

}
