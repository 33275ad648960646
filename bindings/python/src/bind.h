// The parts of the module, each in a file of its own; and how results are made.
#pragma once

#include "convert.h"

#include <sudar/shape.h>

#include "typed.h"

namespace sudar::python {

// A tuple of sudar/results.py. Its class is looked up once, and kept: the interpreter may end before statics do.
template <TypeText type, class... Values>
As<type> result(Values&&... values) {
  static const py::object& make = *new py::object(py::module_::import("sudar.results").attr(type.value));
  return make(std::forward<Values>(values)...);
}

template <class Tag>
py::object bound(const Handle<Tag>& handle, const WorldPointer& world) {
  return handle.null() ? py::object(py::none()) : py::cast(Bound<Tag>{handle, world});
}
template <class Tag>
py::list bound(const std::vector<Handle<Tag>>& handles, const WorldPointer& world) {
  py::list list(handles.size());
  for (std::size_t i = 0; i < handles.size(); ++i) list[i] = bound(handles[i], world);
  return list;
}

inline py::bytes as_bytes(std::span<const std::byte> data) {
  return {reinterpret_cast<const char*>(data.data()), data.size()};
}
inline std::span<const std::byte> from_bytes(std::string_view data) { return std::as_bytes(std::span(data)); }
using Source = As<"Union[bytes, str, PathLike[str]]">;
using Path = As<"Union[str, PathLike[str]]">;
std::string path_text(const py::object& path);
Bytes read(const Source&);

void bind_shapes(py::module_&);
void declare_handles(py::module_&);  // their names, which definitions mention
void bind_definitions(py::module_&);
void bind_handles(py::module_&);
void bind_world(py::module_&);
void bind_arrays(py::module_&);
void bind_recordings(py::module_&);
void bind_scenarios(py::module_&);

}
