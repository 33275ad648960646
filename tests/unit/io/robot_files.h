// Small files of robots, and what was made of them.
#pragma once

#include <algorithm>

#include "unit/io/files.h"

namespace sudar_test {

using io::Finding, io::Model, io::Reading, io::Severity;

inline Reading read_text(const std::string& ending, const std::string& text) {
  const Folder folder;
  return io::read(folder.write("file" + ending, text));
}
inline Reading read_mjcf(const std::string& inside) { return read_text(".xml", "<mujoco>\n" + inside + "</mujoco>\n"); }
inline Reading read_urdf(const std::string& inside) {
  return read_text(".urdf", "<robot name='r'>\n" + inside + "</robot>\n");
}

// A tetrahedron with three edges of length 1 along the axes, of 1/6 m³.
inline const char* const tetrahedron_obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

inline const BodyDef& body(const Model& m, const std::string& name) {
  const auto it = std::ranges::find(m.bodies, name, [](const auto& b) { return b.def.name; });
  if (it == m.bodies.end()) throw Error("body", "there is none of that name: " + name);
  return it->def;
}
template <class Kind>
const Kind& joint(const Model& m, const std::string& name) {
  for (const auto& j : m.joints) {
    if (j.name == name && std::holds_alternative<Kind>(j.def)) return std::get<Kind>(j.def);
  }
  throw Error("joint", "there is none of that name and kind: " + name);
}
template <class Kind>
std::ptrdiff_t count(const Model& m) {
  return std::ranges::count_if(m.joints, [](const auto& j) { return std::holds_alternative<Kind>(j.def); });
}

}
