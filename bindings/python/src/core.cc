// The module sudar._core. bindings/python/sudar/__init__.py puts its names where users find them.
#include "bind.h"

#include <sudar/version.h>

namespace sudar::python {

namespace {

constexpr const char* error_text =
    "Bad data: a definition, a file, a setting. Whatever raised it has changed nothing. `field` names what was wrong.";

void translate(std::exception_ptr p) {
  try {
    if (p) std::rethrow_exception(p);
  } catch (const Error& e) {
    const py::object type = py::module_::import("sudar._core").attr("Error");
    const py::object error = type(py::str(e.what()));
    error.attr("field") = e.field;
    PyErr_SetObject(type.ptr(), error.ptr());
  }
}

}

PYBIND11_MODULE(_core, m) {
  m.doc() = "Sudar's engine. Use it as `sudar`.";
  m.attr("__version__") = SUDAR_VERSION;
  m.attr("precision") = sizeof(Real) == 4 ? "float" : "double";
  m.attr("Error") = py::reinterpret_steal<py::object>(
      PyErr_NewExceptionWithDoc("sudar.Error", error_text, PyExc_ValueError, nullptr));
  m.attr("Error").attr("field") = "";
  py::register_exception_translator(&translate);
  bind_shapes(m);
  declare_handles(m);
  bind_definitions(m);
  bind_handles(m);
  bind_world(m);
  bind_arrays(m);
  bind_recordings(m);
  bind_scenarios(m);
}

}
